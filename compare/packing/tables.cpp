#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/run/samples.hpp"
#include "compare/packing/study.hpp"

namespace fiberchain::compare {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

const std::vector<std::string> kAsked = {
    "bond_damping", "rolling_friction", "stiffness", "fibers", "side", "sides", "seed", "step_factor"};

dem::NamedRow asked_row(const PackingCase& c) {
  return {{"bond_damping", c.bond_damping},
          {"rolling_friction", c.rolling_friction},
          {"stiffness", c.stiffness},
          {"fibers", std::int64_t{c.fibers}},
          {"side", c.side},
          {"sides", std::string(c.periodic ? "periodic" : "walls")},
          {"seed", static_cast<std::int64_t>(c.seed)},
          {"step_factor", c.step_ratio}};
}

dem::NamedRow with(dem::NamedRow row, const dem::NamedRow& rest) {
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

dem::NamedRow bending_row(const PackingRun& run) {
  if (run.status != "finished") return {};
  const BendingParts p = bending_parts(run.history);
  return {{"bending_peak", p.peak},       {"bending_peak_time", p.peak_time},
          {"bending_trough", p.trough},   {"bending_trough_time", p.trough_time},
          {"bending_plateau", p.plateau}, {"bending_unrest", p.unrest}};
}

dem::NamedRow end_row(const PackingRun& run) {
  if (run.status != "finished") return {};
  const PackingSample& last = run.history.back();
  return {{"height", last.height},
          {"solid_fraction", last.solid_fraction},
          {"coordination", last.coordination},
          {"contacts_per_fiber", run.end.contacts_per_fiber},
          {"neighbors_per_fiber", run.end.neighbors_per_fiber},
          {"wall_contacts_per_fiber", run.end.wall_contacts},
          {"overlap_largest", run.end.largest_overlap},
          {"order_parameter", run.end.orientation.order},
          {"order_along_up", run.end.orientation.order_along_up}};
}

dem::NamedRow sample_row(const PackingSample& s) {
  return {{"simulated_time", s.time},
          {"bending_mean", s.bending_angle},
          {"bending_angle", s.largest_bending},
          {"mean_height", s.mean_height},
          {"height", s.height},
          {"vertical_speed", s.vertical_speed},
          {"speed", s.speed},
          {"solid_fraction", s.solid_fraction},
          {"coordination", s.coordination},
          {"order_along_up", s.order},
          {"kinetic_energy", s.energy.kinetic}};
}

const std::vector<std::string> kSample = {
    "simulated_time", "bending_mean",   "bending_angle", "mean_height",    "height",        "vertical_speed",
    "speed",          "solid_fraction", "coordination",  "order_along_up", "kinetic_energy"};

}  // namespace

dem::Table run_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(kAsked, {"bending_peak",
                              "bending_peak_time",
                              "bending_trough",
                              "bending_trough_time",
                              "bending_plateau",
                              "bending_unrest",
                              "height",
                              "solid_fraction",
                              "coordination",
                              "contacts_per_fiber",
                              "neighbors_per_fiber",
                              "wall_contacts_per_fiber",
                              "overlap_largest",
                              "order_parameter",
                              "order_along_up",
                              "time_step",
                              "step_set_by",
                              "steps",
                              "run_time",
                              "status"}));
  for (const PackingRun& run : runs) {
    dem::NamedRow row = with(with(asked_row(run.asked), bending_row(run)), end_row(run));
    table.append(with(std::move(row), {{"time_step", run.step},
                                       {"step_set_by", run.step_set_by},
                                       {"steps", run.steps},
                                       {"run_time", run.run_time},
                                       {"status", run.status}}));
  }
  return table;
}

dem::Table stage_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(joined(kAsked, {"stage"}), kSample));
  for (const PackingRun& run : runs) {
    for (const PackingStage stage : kPackingStages) {
      const auto found = find_stage(run.history, stage);
      const dem::NamedRow row = with(asked_row(run.asked), {{"stage", std::string(name(stage))}});
      table.append(found ? with(row, sample_row(run.history[*found])) : row);
    }
  }
  return table;
}

dem::Table history_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(kAsked, kSample));
  for (const PackingRun& run : runs) {
    for (const PackingSample& sample : run.history)
      table.append(with(asked_row(run.asked), sample_row(sample)));
  }
  return table;
}

dem::Table density_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(kAsked, {"slab_low", "slab_high", "solid_fraction"}));
  for (const PackingRun& run : runs) {
    for (std::size_t k = 0; k < run.end.solid_fractions.size(); ++k) {
      table.append(with(asked_row(run.asked), {{"slab_low", run.end.edges[k]},
                                               {"slab_high", run.end.edges[k + 1]},
                                               {"solid_fraction", run.end.solid_fractions[k]}}));
    }
  }
  return table;
}

dem::Table orientation_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(kAsked, {"polar_low", "polar_high", "over_isotropic_start", "over_isotropic"}));
  for (const PackingRun& run : runs) {
    const auto& start = run.start.against_isotropic;
    const auto& end = run.end.orientation.against_isotropic;
    const double width = std::acos(0.0) / static_cast<double>(start.size());
    for (std::size_t k = 0; k < start.size(); ++k) {
      const auto low = static_cast<double>(k) * width;
      table.append(with(asked_row(run.asked), {{"polar_low", low},
                                               {"polar_high", low + width},
                                               {"over_isotropic_start", start[k]},
                                               {"over_isotropic", end.empty() ? kMissing : end[k]}}));
    }
  }
  return table;
}

dem::Table energy_table(const PackingRun& booked) {
  dem::Table table(joined({"simulated_time"}, dem::energy_columns(true)));
  for (const PackingSample& sample : booked.history) {
    table.append(with({{"simulated_time", sample.time}}, dem::energy_cells(sample.energy, true)));
  }
  return table;
}

namespace {

const std::vector<std::string> kSpread = {"seeds", "mean", "half_width", "standard_deviation",
                                          "least", "most"};

dem::NamedRow spread_row(const Spread& s) {
  return {{"seeds", static_cast<std::int64_t>(s.count)}, {"mean", s.mean},   {"half_width", half_width(s)},
          {"standard_deviation", s.deviation},           {"least", s.least}, {"most", s.most}};
}

const std::vector<std::string> kGroup = {"bond_damping", "rolling_friction", "stiffness", "fibers", "side",
                                         "sides",        "step_factor"};

dem::NamedRow group_row(const PackingCase& c) {
  dem::NamedRow row = asked_row(c);
  std::erase_if(row, [](const auto& cell) { return cell.first == "seed"; });
  return row;
}

bool any_finished(const SeedGroup& group) {
  return std::ranges::any_of(group.runs, [](const PackingRun* run) { return run->status == "finished"; });
}

}  // namespace

dem::Table spread_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(joined(kGroup, {"part"}), kSpread));
  for (const SeedGroup& group : seed_groups(runs)) {
    if (!any_finished(group)) continue;
    const BendingSpread s = bending_spread(group);
    const std::pair<const char*, const Spread*> parts[] = {
        {"peak", &s.peak}, {"trough", &s.trough}, {"plateau", &s.plateau}};
    for (const auto& [part, spread] : parts) {
      table.append(with(with(group_row(group.asked), {{"part", std::string(part)}}), spread_row(*spread)));
    }
  }
  return table;
}

dem::Table comparison_table(const std::vector<PackingRun>& runs) {
  dem::Table table(joined(joined(kGroup, {"part"}), kSpread));
  const std::vector<SeedGroup> groups = seed_groups(runs);
  const std::pair<const char*, double BendingParts::*> parts[] = {
      {"peak", &BendingParts::peak}, {"trough", &BendingParts::trough}, {"plateau", &BendingParts::plateau}};
  for (const SeedGroup& group : groups) {
    if (&group == &groups.front() || !any_finished(group) || !any_finished(groups.front())) continue;
    for (const auto& [part, member] : parts) {
      table.append(with(with(group_row(group.asked), {{"part", std::string(part)}}),
                        spread_row(paired_difference(group, groups.front(), member))));
    }
  }
  return table;
}

}  // namespace fiberchain::compare
