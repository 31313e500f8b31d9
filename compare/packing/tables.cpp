#include <algorithm>
#include <cmath>

#include "compare/packing/study.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/run/samples.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow asked_row(const PackingCase& c) {
  return {{"bond_damping", c.bond_damping},
          {"rolling_friction", c.rolling_friction},
          {"stiffness", c.stiffness},
          {"contact_modulus", c.contact_modulus},
          {"fibers", std::int64_t{c.fibers}},
          {"side", c.side},
          {"sides", std::string(c.periodic ? "periodic" : "walls")},
          {"seed", static_cast<std::int64_t>(c.seed)},
          {"step_factor", c.step_ratio}};
}

dem::NamedRow bending_row(const BendingParts& p) {
  return {{"bending_peak", p.peak},       {"bending_peak_time", p.peak_time},
          {"bending_trough", p.trough},   {"bending_trough_time", p.trough_time},
          {"bending_plateau", p.plateau}, {"bending_unrest", p.unrest}};
}

dem::NamedRow end_row(const PackingSample& last, const PackingEnd& end) {
  return {{"height", last.height},
          {"solid_fraction", last.solid_fraction},
          {"coordination", last.coordination},
          {"contacts_per_fiber", end.contacts_per_fiber},
          {"neighbors_per_fiber", end.neighbors_per_fiber},
          {"wall_contacts_per_fiber", end.wall_contacts},
          {"overlap_largest", end.largest_overlap},
          {"overlap_mean", end.overlap_mean},
          {"overlap_peak", end.overlap_peak},
          {"order_parameter", end.orientation.order},
          {"order_along_up", end.orientation.order_along_up}};
}

dem::NamedRow march_row(const PackingRun& run) {
  return {{"time_step", run.step},
          {"step_set_by", run.step_set_by},
          {"steps", run.steps},
          {"run_time", run.run_time},
          {"status", run.status}};
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

using Names = std::vector<std::string>;

Names asked_names(const Names& rest) { return joined(names_of(asked_row({})), rest); }

}  // namespace

dem::Table run_table(const std::vector<PackingRun>& runs) {
  const dem::NamedRow found = joined(bending_row({}), end_row({}, {}));
  dem::Table table(asked_names(names_of(joined(found, march_row({})))));
  for (const PackingRun& run : runs) {
    dem::NamedRow row = asked_row(run.asked);
    if (run.status == "finished") {
      row =
          joined(joined(row, bending_row(bending_parts(run.history))), end_row(run.history.back(), run.end));
    }
    table.append(joined(row, march_row(run)));
  }
  return table;
}

dem::Table stage_table(const std::vector<PackingRun>& runs) {
  dem::Table table(asked_names(joined(Names{"stage"}, names_of(sample_row({})))));
  for (const PackingRun& run : runs) {
    for (const PackingStage stage : kPackingStages) {
      const auto found = find_stage(run.history, stage);
      const dem::NamedRow row = joined(asked_row(run.asked), {{"stage", std::string(name(stage))}});
      table.append(found ? joined(row, sample_row(run.history[*found])) : row);
    }
  }
  return table;
}

dem::Table history_table(const std::vector<PackingRun>& runs) {
  dem::Table table(asked_names(names_of(sample_row({}))));
  for (const PackingRun& run : runs) {
    for (const PackingSample& sample : run.history)
      table.append(joined(asked_row(run.asked), sample_row(sample)));
  }
  return table;
}

dem::Table density_table(const std::vector<PackingRun>& runs) {
  dem::Table table(asked_names({"slab_low", "slab_high", "solid_fraction"}));
  for (const PackingRun& run : runs) {
    for (std::size_t k = 0; k < run.end.solid_fractions.size(); ++k) {
      table.append(joined(asked_row(run.asked), {{"slab_low", run.end.edges[k]},
                                                 {"slab_high", run.end.edges[k + 1]},
                                                 {"solid_fraction", run.end.solid_fractions[k]}}));
    }
  }
  return table;
}

dem::Table orientation_table(const std::vector<PackingRun>& runs) {
  dem::Table table(asked_names({"polar_low", "polar_high", "over_isotropic_start", "over_isotropic"}));
  for (const PackingRun& run : runs) {
    const auto& start = run.start.against_isotropic;
    const auto& end = run.end.orientation.against_isotropic;
    const double width = std::acos(0.0) / static_cast<double>(start.size());
    for (std::size_t k = 0; k < start.size(); ++k) {
      const auto low = static_cast<double>(k) * width;
      table.append(joined(asked_row(run.asked), {{"polar_low", low},
                                                 {"polar_high", low + width},
                                                 {"over_isotropic_start", start[k]},
                                                 {"over_isotropic", end.empty() ? nan : end[k]}}));
    }
  }
  return table;
}

dem::Table energy_table(const PackingRun& accounted) {
  dem::Table table(joined(Names{"simulated_time"}, dem::energy_columns(true)));
  for (const PackingSample& sample : accounted.history) {
    table.append(
        joined(dem::NamedRow{{"simulated_time", sample.time}}, dem::energy_cells(sample.energy, true)));
  }
  return table;
}

namespace {

dem::NamedRow spread_row(const Spread& s) {
  return {{"seeds", static_cast<std::int64_t>(s.count)}, {"mean", s.mean},   {"half_width", half_width(s)},
          {"standard_deviation", s.deviation},           {"least", s.least}, {"most", s.most}};
}

dem::NamedRow group_row(const PackingCase& c) {
  dem::NamedRow row = asked_row(c);
  std::erase_if(row, [](const auto& cell) { return cell.first == "seed"; });
  return row;
}

bool any_finished(const SeedGroup& group) {
  return std::ranges::any_of(group.runs, [](const PackingRun* run) { return run->status == "finished"; });
}

dem::Table empty_spreads() {
  const dem::NamedRow part{{"part", std::string()}};
  return dem::Table(names_of(joined(joined(group_row({}), part), spread_row({}))));
}

void append_spread(dem::Table& table, const SeedGroup& group, const char* part, const Spread& spread) {
  table.append(joined(joined(group_row(group.asked), {{"part", std::string(part)}}), spread_row(spread)));
}

constexpr std::pair<const char*, double BendingParts::*> kParts[] = {
    {"peak", &BendingParts::peak}, {"trough", &BendingParts::trough}, {"plateau", &BendingParts::plateau}};

}  // namespace

dem::Table spread_table(const std::vector<PackingRun>& runs) {
  dem::Table table = empty_spreads();
  for (const SeedGroup& group : seed_groups(runs)) {
    if (!any_finished(group)) continue;
    const BendingSpread s = bending_spread(group);
    append_spread(table, group, "peak", s.peak);
    append_spread(table, group, "trough", s.trough);
    append_spread(table, group, "plateau", s.plateau);
  }
  return table;
}

dem::Table comparison_table(const std::vector<PackingRun>& runs) {
  dem::Table table = empty_spreads();
  const std::vector<SeedGroup> groups = seed_groups(runs);
  for (const SeedGroup& group : groups) {
    if (&group == &groups.front() || !any_finished(group) || !any_finished(groups.front())) continue;
    for (const auto& [part, member] : kParts) {
      append_spread(table, group, part, paired_difference(group, groups.front(), member));
    }
  }
  return table;
}

}  // namespace fiberchain::compare
