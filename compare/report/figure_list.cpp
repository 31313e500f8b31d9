#include "compare/report/figure_list.hpp"

#include "dem/files/base64.hpp"

namespace fiberchain::compare {
namespace {

/// A figure by the names that studies give it, the first that is found; SVG rather than PNG.
struct ListedFigure {
  std::vector<std::string> names;
  std::string caption;
};

struct ListedPaperFigure {
  int number;
  std::string heading;
  std::vector<ListedFigure> figures;
};

struct ListedSection {
  std::string id, heading, text;
  std::vector<ListedFigure> figures;
};

const std::vector<ListedPaperFigure>& listed_paper_figures() {
  static const std::vector<ListedPaperFigure> listed{
      {3, "Deflection against load", {{{"fig-3"}, "Deflection of the free end, r_f = 10."}}},
      {4,
       "Departure from the Elastica",
       {{{"fig-4"}, "Departure of the chain's free end from the Elastica by aspect ratio."}}},
      {5,
       "A rigid fiber in shear",
       {{{"fig-5-over-cox", "fig-5"}, "Orbit period of a rigid fiber over Cox's, by aspect ratio."}}},
      {6, "A fiber let go", {{{"fig-6"}, "The free end after the release."}}},
      {7, "Damping of the fiber by that of the bonds", {{{"fig-7"}, "ξ_f against ξ_b, r_f = 10."}}},
      {8,
       "What the damping does not depend on",
       {{{"fig-8-load"}, "ξ_f against the load before the release."},
        {{"fig-8-modulus"}, "ξ_f against Young's modulus."}}},
      {9, "Damping against aspect ratio, Eq 20", {{{"fig-9"}, "ξ_f against r_f."}}},
      {10,
       "Rolling friction of the bonds",
       {{{"fig-10"}, "ξ_f with rolling friction against r_f."},
        {{"fig-10-step"}, "The same by friction law and time step."}}},
      {11, "Packings", {{{"fig-11"}, "Packings of fibers, rendered."}}},
      {12,
       "Bending angles in packings",
       {{{"fig-12-damping"}, "Mean bending angle by bond damping."},
        {{"fig-12-friction"}, "Mean bending angle by rolling friction."},
        {{"fig-12-damping-seeds"}, "Final bending angle of several fillings."}}}};
  return listed;
}

const std::vector<ListedSection>& listed_sections() {
  static const std::vector<ListedSection> listed{
      {"budgets",
       "Budgets of error",
       "Each departure is split into its causes: shear and stretch, which a real fiber has and the Elastica "
       "lacks, and finite bonds, which are the model's. What vanishes with more bonds, and how fast, is the "
       "order.",
       {{{"static-budget"}, "What the departure from the Elastica consists of, r_f = 10."},
        {{"static-order"},
         "Distance from the Elastica against aspect ratio: of second order, of fourth by the corrected bond "
         "when "
         "stretch is taken off."},
        {{"contact-modulus"}, "What contacts softer than the fibers change."}}},
      {"stability",
       "Stability map",
       "The largest stable time step, which the paper's rules for it miss in part of the plane of Poisson's "
       "ratio "
       "and damping.",
       {{{"stability-map", "stability-map-paper-leapfrog-10"},
         "Largest stable step by Poisson's ratio and bond damping, over the time scale of a bond."}}},
      {"cost",
       "Run time against error",
       "The same quantity by every method: what an error costs.",
       {{{"bench-damping-100"}, "ξ_f at r_f = 100: run time against error."},
        {{"bench-history-10"}, "Path of the free end after a release, r_f = 10: run time against error."}}},
      {"rods",
       "Rods in space",
       "The bonds' law is a geometrically exact rod's: chains held and loaded in any way, through limit "
       "points and onto "
       "branches, against rods that were solved apart.",
       {{{"rods-lees-frame"}, "Lee's frame, which snaps through: the force against its point's drop."},
        {{"rods-column"}, "A column between hinges at its critical load and beyond."},
        {{"rods-order-corrected"}, "Error of the corrected bond against aspect ratio, by benchmark."}}},
      {"capstan",
       "A fiber about a drum",
       "Euler's e^μφ, which a fiber that bends and is thick departs from as the rod says.",
       {{{"capstan"}, "Ratio of the tensions over Euler's, by turning, friction and surface."}}},
      {"spacing",
       "Longer bonds",
       "A fiber cut into fewer bonds than it is diameters long: cheaper, and how much less exact.",
       {{{"spacing-statics"}, "Free end's distance from the Elastica against the number of bonds."},
        {{"spacing-mode"}, "Error of the first frequency against the number of bonds."}}},
      {"beyond",
       "Beyond the paper",
       "",
       {{{"materials"},
         "Damping ratio of three fibers against frequency: a dashpot's grows, a material's does "
         "not."},
        {{"contact-rebound"}, "Oblique impacts of spheres against measured points."},
        {{"shear-shapes"}, "Flexible fibers in shear."}}}};
  return listed;
}

/// As it stands in the page; nothing if no source has it.
std::optional<ReportFigure> embedded(const Sources& sources, const ListedFigure& listed) {
  for (const char* const suffix : {".svg", ".png"}) {
    std::optional<SourceFile>
        first;  // of all names: what was made anew goes before what came with the program
    std::size_t place = sources.size();
    for (const std::string& name : listed.names) {
      for (std::size_t i = 0; i < place; ++i) {
        if (const auto file = find_source({sources[i]}, name + suffix)) first = file, place = i;
      }
    }
    if (!first) continue;
    const std::string content = read_source(first->path);
    return ReportFigure{listed.caption, data_uri(content), origin_of(first->label, content)};
  }
  return std::nullopt;
}

template <class Place>
void embed(const Sources& sources, const std::vector<ListedFigure>& listed, Place& place) {
  for (const ListedFigure& figure : listed) {
    if (auto found = embedded(sources, figure))
      place.figures.push_back(std::move(*found));
    else
      place.missing.push_back(figure.caption);
  }
}

}  // namespace

std::string data_uri(const std::string& content) {
  const std::string type = content.starts_with("<") ? "image/svg+xml" : "image/png";
  return "data:" + type + ";base64," + dem::base64(content.data(), content.size());
}

std::vector<PaperFigure> paper_figures(const Sources& sources) {
  std::vector<PaperFigure> all;
  for (const ListedPaperFigure& listed : listed_paper_figures()) {
    PaperFigure figure{.number = listed.number, .heading = listed.heading, .figures = {}};
    embed(sources, listed.figures, figure);
    all.push_back(std::move(figure));
  }
  return all;
}

std::vector<ReportSection> report_sections(const Sources& sources) {
  std::vector<ReportSection> all;
  for (const ListedSection& listed : listed_sections()) {
    ReportSection section{.id = listed.id, .heading = listed.heading, .text = listed.text, .figures = {}};
    embed(sources, listed.figures, section);
    all.push_back(std::move(section));
  }
  return all;
}

}  // namespace fiberchain::compare
