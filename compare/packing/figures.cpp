#include <algorithm>

#include "compare/packing/study.hpp"

namespace fiberchain::compare {
namespace {

using Runs = std::vector<const PackingRun*>;

Series curve(const PackingRun& run, double PackingSample::*of, std::string label, int color) {
  Series s{std::move(label), {}, {}, Mark::line, Dash::solid, color};
  for (const PackingSample& sample : run.history) s.add(sample.time, sample.*of);
  return s;
}

/// Least and most over the runs at each sample, where all have it, and their mean.
std::pair<Series, Series> spread(const Runs& runs, double PackingSample::*of, int color) {
  Series band{"", {}, {}, Mark::band, Dash::solid, color}, mean{"", {}, {}, Mark::line, Dash::solid, color};
  std::size_t samples = runs.front()->history.size();
  for (const PackingRun* run : runs) samples = std::min(samples, run->history.size());
  for (std::size_t i = 0; i < samples; ++i) {
    const auto value = [&](const PackingRun* run) { return run->history[i].*of; };
    const auto [least, most] = std::ranges::minmax_element(runs, {}, value);
    const double time = runs.front()->history[i].time;
    double sum = 0;
    for (const PackingRun* run : runs) sum += value(run);
    band.add(time, value(*most));
    band.y_low.push_back(value(*least));
    mean.add(time, sum / static_cast<double>(runs.size()));
  }
  return {band, mean};
}

/// Without friction.
bool of_damping(const PackingCase& c, const PackingCase& first) {
  return c.stiffness == 1 && c.step_ratio == 1 && c.rolling_friction == first.rolling_friction;
}

/// At the first damping.
bool of_friction(const PackingCase& c, const PackingCase& first) {
  return c.stiffness == 1 && c.step_ratio == 1 && c.bond_damping == first.bond_damping;
}

/// Fig 12 for the cases that are chosen: a curve each; where there are several seeds their mean, least and
/// most.
Figure bending_figure(const std::vector<PackingRun>& runs,
                      bool (*chosen)(const PackingCase&, const PackingCase&), std::string title) {
  Figure figure{std::move(title), {"time (s)"}, {"mean bending angle of a bond (rad)"}, {}};
  int color = 0;
  for (const SeedGroup& group : seed_groups(runs)) {
    if (!chosen(group.asked, runs.front().asked)) continue;
    if (group.runs.size() == 1) {
      figure.series.push_back(
          curve(*group.runs[0], &PackingSample::bending_angle, label_of(group.asked), color++));
      continue;
    }
    auto [band, mean] = spread(group.runs, &PackingSample::bending_angle, color++);
    mean.label = label_of(group.asked);
    figure.series.push_back(std::move(band)), figure.series.push_back(std::move(mean));
  }
  return figure;
}

Figure height_figure(const std::vector<PackingRun>& runs) {
  Figure figure{"Height of the packing", {"time (s)"}, {"mean height of the spheres (m)"}, {}};
  int color = 0;
  for (const PackingRun& run : runs) {
    figure.series.push_back(curve(run, &PackingSample::mean_height, label_of(run.asked), color++));
  }
  return figure;
}

Figure density_figure(const std::vector<PackingRun>& runs) {
  Figure figure{"Packings at rest", {"solid fraction"}, {"height over the floor (m)"}, {}};
  int color = 0;
  for (const PackingRun& run : runs) {
    Series s{label_of(run.asked), {}, {}, Mark::line, Dash::solid, color++};
    for (std::size_t k = 0; k < run.end.solid_fractions.size(); ++k)
      s.add(run.end.solid_fractions[k], (run.end.edges[k] + run.end.edges[k + 1]) / 2);
    figure.series.push_back(std::move(s));
  }
  return figure;
}

Figure orientation_figure(const std::vector<PackingRun>& runs) {
  Figure figure{"Directions of the bonds",
                {"angle against the vertical (degrees)"},
                {"share over that of isotropic bonds"},
                {}};
  const auto add = [&](const std::vector<double>& profile, std::string label, Dash dash, int color) {
    Series s{std::move(label), {}, {}, Mark::line_and_points, dash, color};
    const double width = 90 / static_cast<double>(profile.size());
    for (std::size_t k = 0; k < profile.size(); ++k)
      s.add((static_cast<double>(k) + 0.5) * width, profile[k]);
    figure.series.push_back(std::move(s));
  };
  int color = 0;
  add(runs.front().start.against_isotropic, "at the start", Dash::dashed, color++);
  for (const PackingRun& run : runs) {
    if (run.status == "finished")
      add(run.end.orientation.against_isotropic, label_of(run.asked), Dash::solid, color++);
  }
  return figure;
}

Figure energy_figure(const PackingRun& accounted) {
  Figure figure{"Where the energy goes, " + label_of(accounted.asked), {"time (s)"}, {"energy (J)"}, {}};
  const std::pair<const char*, double (*)(const dem::EnergyBalance&)> parts[] = {
      {"total", [](const dem::EnergyBalance& e) { return total(e); }},
      {"gravity", [](const dem::EnergyBalance& e) { return e.gravity; }},
      {"kinetic", [](const dem::EnergyBalance& e) { return e.kinetic; }},
      {"bonds", [](const dem::EnergyBalance& e) { return e.bonds; }},
      {"taken by contacts, normal", [](const dem::EnergyBalance& e) { return e.contact_normal; }},
      {"taken by contacts, along the surface",
       [](const dem::EnergyBalance& e) { return e.contact_tangential; }},
      {"taken by bonds", [](const dem::EnergyBalance& e) { return e.bond_damping + e.bond_friction; }}};
  int color = 0;
  for (const auto& [label, part] : parts) {
    Series s{label, {}, {}, Mark::line, Dash::solid, color++};
    for (const PackingSample& sample : accounted.history) s.add(sample.time, part(sample.energy));
    figure.series.push_back(std::move(s));
  }
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> packing_figures(const std::vector<PackingRun>& figure_runs,
                                                            const std::vector<PackingRun>& spread_runs) {
  std::vector<std::pair<std::string, Figure>> figures;
  const auto add = [&](const char* name, Figure figure) {
    if (!figure.series.empty()) figures.emplace_back(name, std::move(figure));
  };
  add("fig-12-damping", bending_figure(figure_runs, of_damping, "Fig 12: bond damping"));
  add("fig-12-friction", bending_figure(figure_runs, of_friction, "Fig 12: rolling friction of the bonds"));
  add("fig-12-damping-seeds",
      bending_figure(spread_runs, of_damping, "Fig 12: bond damping, mean, least and most of the seeds"));
  add("fig-12-friction-seeds",
      bending_figure(spread_runs, of_friction,
                     "Fig 12: rolling friction of the bonds, mean, least and most of the seeds"));
  if (figure_runs.empty()) return figures;
  add("packing-height", height_figure(figure_runs));
  add("packing-density", density_figure(figure_runs));
  add("packing-orientation", orientation_figure(figure_runs));
  for (const PackingRun& run : figure_runs) {
    if (run.asked.accounted) add("packing-energy", energy_figure(run));
  }
  return figures;
}

}  // namespace fiberchain::compare
