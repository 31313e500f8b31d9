#include <algorithm>
#include <numbers>

#include "compare/rod_packing/rod_packing.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow asked_rods(const RodPackingCase& c) {
  return {{"surface", std::string(c.smooth ? "smooth" : "spheres")},
          {"rod_aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"spacing", static_cast<double>(c.spacing)},
          {"rod_friction", c.friction},
          {"fibers", std::int64_t{c.fibers}},
          {"rod_pressure", c.pressure}};
}

bool is_same_kind(const RodPackingCase& a, RodPackingCase b) {
  b.seed = a.seed;
  return a == b;
}

dem::NamedRow kind_row(const RodPackingKind& kind) {
  const double r = kind.asked.aspect_ratio;
  return joined(asked_rods(kind.asked),
                {{"seeds", static_cast<std::int64_t>(kind.solid_fraction.count)},
                 {"rod_fraction", kind.solid_fraction.mean},
                 {"rod_fraction_interval", dem::known(half_width(kind.solid_fraction))},
                 {"rod_fraction_by_aspect", r * kind.solid_fraction.mean},
                 {"rod_contacts", kind.coordination.mean},
                 {"rod_contacts_interval", dem::known(half_width(kind.coordination))},
                 {"rod_contact_ratio", kind.contact_ratio.mean}});
}

}  // namespace

std::vector<RodPackingKind> rod_packing_kinds(const std::vector<RodPacking>& packings) {
  std::vector<RodPackingKind> kinds;
  for (const RodPacking& first : packings) {
    const auto same = [&](const RodPackingKind& kind) { return is_same_kind(kind.asked, first.asked); };
    if (std::ranges::any_of(kinds, same)) continue;
    std::vector<double> fractions, contacts, ratios;
    for (const RodPacking& p : packings) {
      if (p.status != "finished" || !is_same_kind(p.asked, first.asked)) continue;
      fractions.push_back(p.solid_fraction);
      contacts.push_back(p.coordination);
      ratios.push_back(p.contact_ratio);
    }
    if (fractions.empty()) continue;
    RodPackingKind kind{first.asked, spread_of(fractions), spread_of(contacts), spread_of(ratios)};
    kind.asked.seed = 0;
    kinds.push_back(kind);
  }
  if (kinds.empty()) throw InputError("no packing of rods finished");
  return kinds;
}

dem::Table rod_packing_table(const std::vector<RodPacking>& packings) {
  return tabulate(packings, [](const RodPacking& p) {
    return joined(asked_rods(p.asked), {{"seed", static_cast<std::int64_t>(p.asked.seed)},
                                        {"spheres", p.nodes},
                                        {"rod_fraction", p.solid_fraction},
                                        {"rod_contacts", p.coordination},
                                        {"rod_sine", p.sine},
                                        {"rod_contact_ratio", p.contact_ratio},
                                        {"rod_cube", p.edge},
                                        {"rod_overlap", p.overlap},
                                        {"run_time", p.run_time},
                                        {"status", p.status}});
  });
}

dem::Table rod_packing_kind_table(const std::vector<RodPacking>& packings) {
  return tabulate(rod_packing_kinds(packings), kind_row);
}

Figure rod_packing_figure(const std::vector<RodPacking>& packings) {
  Figure figure{"Packings of stiff rods without friction",
                {"aspect ratio {/:Italic r}", true},
                {"φ {/:Italic r}, half of the contacts of a rod"},
                {}};
  Series fraction{"φ {/:Italic r}, smooth rods", {}, {}, Mark::points},
      bumpy{"φ {/:Italic r}, spheres in a row", {}, {}, Mark::points},
      contacts{"half of the contacts, smooth rods", {}, {}, Mark::points};
  double least = 1e9, most = 0;
  for (const RodPackingKind& kind : rod_packing_kinds(packings)) {
    const double r = kind.asked.aspect_ratio;
    (kind.asked.smooth ? fraction : bumpy).add(r, r * kind.solid_fraction.mean);
    if (kind.asked.smooth) contacts.add(r, kind.coordination.mean / 2);
    least = std::min(least, r), most = std::max(most, r);
  }
  Series quoted{"5.4 (Philipse)", {least, most}, {5.4, 5.4}, Mark::line, Dash::dashed};
  Series random{"10 contacts at random places", {}, {}, Mark::line};
  for (double r = least; r < 1.02 * most; r *= 1.1)
    random.add(r, 10 * r / excluded_volume_ratio(r, std::numbers::pi / 4));
  for (const Series& series : {fraction, bumpy, contacts, quoted, random}) {
    if (!series.x.empty()) figure.series.push_back(series);
  }
  return figure;
}

}  // namespace fiberchain::compare
