#include "compare/packing/softening.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/packing/study.hpp"

namespace fiberchain::compare {
namespace {

constexpr double kSide = 0.06;  // of the floor of 300 fibers, which are 0.04 long [m]

double fraction_of(const PackingRun& run) { return run.history.back().solid_fraction; }
double coordination_of(const PackingRun& run) { return run.history.back().coordination; }
double bending_of(const PackingRun& run) { return bending_parts(run.history).plateau; }
double mean_overlap_of(const PackingRun& run) { return run.end.overlap_mean; }
double peak_overlap_of(const PackingRun& run) { return run.end.overlap_peak; }

/// Over the runs of a group that finished; nothing where none has.
std::optional<Spread> spread_of_finished(const SeedGroup& group, double (*of)(const PackingRun&)) {
  std::vector<double> values;
  for (const PackingRun* run : group.runs) {
    if (run->status == "finished") values.push_back(of(*run));
  }
  if (values.empty()) return std::nullopt;
  return spread_of(values);
}

}  // namespace

std::vector<PackingCase> softening_cases(const SofteningPlan& plan) {
  std::vector<PackingCase> cases;
  for (const double modulus : plan.moduli) {
    for (int seed = 1; seed <= plan.seeds; ++seed) {
      cases.push_back({.bond_damping = 0.1,
                       .stiffness = plan.stiffness,
                       .contact_modulus = modulus,
                       .fibers = plan.fibers,
                       .side = kSide * std::sqrt(plan.fibers / 300.0),
                       .seed = static_cast<std::uint64_t>(seed),
                       .duration = plan.duration,
                       .periodic = true});
    }
  }
  return cases;
}

dem::Table softening_table(const std::vector<PackingRun>& runs) {
  dem::Table table({"contact_modulus", "stiffness", "fibers", "seeds", "solid_fraction",
                    "solid_fraction_deviation", "coordination", "coordination_deviation", "bending_plateau",
                    "bending_deviation", "overlap_mean", "overlap_peak"});
  for (const SeedGroup& group : seed_groups(runs)) {
    const auto fraction = spread_of_finished(group, fraction_of);
    if (!fraction) continue;
    const Spread coordination = *spread_of_finished(group, coordination_of),
                 bending = *spread_of_finished(group, bending_of);
    table.append({{"contact_modulus", group.asked.contact_modulus},
                  {"stiffness", group.asked.stiffness},
                  {"fibers", std::int64_t{group.asked.fibers}},
                  {"seeds", static_cast<std::int64_t>(fraction->count)},
                  {"solid_fraction", fraction->mean},
                  {"solid_fraction_deviation", fraction->deviation},
                  {"coordination", coordination.mean},
                  {"coordination_deviation", coordination.deviation},
                  {"bending_plateau", bending.mean},
                  {"bending_deviation", bending.deviation},
                  {"overlap_mean", spread_of_finished(group, mean_overlap_of)->most},
                  {"overlap_peak", spread_of_finished(group, peak_overlap_of)->most}});
  }
  return table;
}

Figure softening_figure(const std::vector<PackingRun>& runs) {
  Figure figure{"Packings of stiff fibers at rest, each seed and their means",
                {"Young's modulus of contacts over the fibers'", true},
                {"over the mean at the first modulus"},
                {}};
  const std::pair<const char*, double (*)(const PackingRun&)> parts[] = {
      {"solid fraction", fraction_of}, {"coordination", coordination_of}, {"mean bending angle", bending_of}};
  const std::vector<SeedGroup> groups = seed_groups(runs);
  for (int color = 0; const auto& [label, of] : parts) {
    const auto own = groups.empty() ? std::nullopt : spread_of_finished(groups.front(), of);
    if (!own) continue;
    Series means{label, {}, {}, Mark::line, Dash::solid, color},
        each{"", {}, {}, Mark::points, Dash::solid, color};
    for (const SeedGroup& group : groups) {
      const auto spread = spread_of_finished(group, of);
      if (!spread) continue;
      means.add(group.asked.contact_modulus, spread->mean / own->mean);
      for (const PackingRun* run : group.runs) {
        if (run->status == "finished") each.add(group.asked.contact_modulus, of(*run) / own->mean);
      }
    }
    figure.series.push_back(std::move(means)), figure.series.push_back(std::move(each));
    ++color;
  }
  return figure;
}

}  // namespace fiberchain::compare
