#include "compare/material/study.hpp"

#include <algorithm>
#include <numbers>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::Cell cell(const std::optional<double>& value) { return value ? dem::Cell{*value} : dem::Cell{}; }

dem::NamedRow row_of(const ModePoint& p) {
  return {{"damper", std::string(name(p.damper))},
          {"mode", std::int64_t{p.mode}},
          {"root_frequency", p.root.frequency / (2 * std::numbers::pi)},
          {"damping_marched", p.marched.damping},
          {"damping_root", p.root.damping},
          {"damping_difference", p.marched.damping / p.root.damping - 1},
          {"damping_half_loss", p.root.half_loss_factor},
          {"damping_series", cell(p.series)},
          {"time_step", p.marched.time_step},
          {"steps", static_cast<std::int64_t>(p.marched.steps)}};
}

dem::NamedRow row_of(const TwoModes& run) {
  return {{"damper", std::string(name(run.damper))},
          {"mode", std::int64_t{2}},
          {"damping_marched", run.in_company},
          {"damping_root", run.root},
          {"damping_difference", run.in_company / run.root - 1}};
}

dem::Table history_table(const std::vector<TwoModes>& runs) {
  dem::Table table({"time", "viscous_y", "flat_y"});
  const auto &viscous = runs[0].history, &flat = runs[1].history;
  for (std::size_t i = 0; i < std::min(viscous.time.size(), flat.time.size()); i += 20) {
    table.append(
        {{"time", viscous.time[i] / runs[0].period}, {"viscous_y", viscous.y[i]}, {"flat_y", flat.y[i]}});
  }
  return table;
}

dem::NamedRow row_of(const CyclePoint& p) {
  return {{"damper", std::string(name(p.damper))},
          {"drive_frequency", p.loop.frequency},
          {"cycle_loss", p.loop.loss},
          {"cycle_loss_formula", p.formula}};
}

dem::NamedRow row_of(const WirePoint& p) {
  return {{"metal", p.metal.name},
          {"diameter", p.diameter},
          {"first_frequency", p.frequency},
          {"thermoelastic_peak", p.peak},
          {"branch_count", std::int64_t{p.branches}},
          {"damping_root", p.root},
          {"damping_series", p.series},
          {"damping_marched", cell(p.marched)}};
}

dem::NamedRow row_of(const PackingRun& run) {
  const PackingSample& end = run.history.back();
  return {{"damper", damper_of(run.asked)},
          {"seed", static_cast<std::int64_t>(run.asked.seed)},
          {"bond_damping", run.asked.bond_damping},
          {"loss_factor", run.asked.loss_factor},
          {"time_step", run.step},
          {"steps", run.steps},
          {"run_time", run.run_time},
          {"settle_time", settle_time(run)},
          {"speed", end.speed},
          {"solid_fraction", end.solid_fraction},
          {"coordination", end.coordination},
          {"bending_angle", end.bending_angle},
          {"status", run.status}};
}

}  // namespace

ThreeFibers study_fibers(int aspect_ratio) { return three_fibers(metal_values("aluminium"), aspect_ratio); }

MaterialPart mode_part(const MaterialPlan& plan, const Jobs& jobs) {
  const ThreeFibers fibers = study_fibers(plan.aspect_ratio);
  const auto points = mode_points(fibers, plan.modes, jobs);
  return {tabulate(points, [](const ModePoint& p) { return row_of(p); }),
          {},
          {{"materials", mode_figure(fibers, points)}}};
}

MaterialPart two_mode_part(const MaterialPlan& plan, const Jobs&) {
  const auto runs = two_modes(with_loss_factor(study_fibers(plan.aspect_ratio), 0.02), 8);
  return {tabulate(runs, [](const TwoModes& run) { return row_of(run); }),
          {{"materials-two-modes-history", history_table(runs)}},
          {{"materials-two-modes", two_mode_figure(runs)}}};
}

MaterialPart cycle_part(const MaterialPlan& plan, const Jobs&) {
  const ThreeFibers fibers = study_fibers(plan.aspect_ratio);
  const double f = first_frequency(fibers.elastic);
  const auto points = cycle_points(fibers, logarithmic_values(f / 10, 1e3 * f, 17));
  const ThreeFibers lossy = with_loss_factor(fibers, 0.1);
  return {tabulate(points, [](const CyclePoint& p) { return row_of(p); }),
          {},
          {{"materials-cycle", cycle_figure(fibers, points)},
           {"materials-loops", loop_figure(lossy.flat, lossy.viscous, first_frequency(lossy.elastic))}}};
}

MaterialPart wire_part(const MaterialPlan& plan, const Jobs& jobs) {
  WireSweep sweep;
  sweep.aspect_ratio = plan.aspect_ratio, sweep.diameters = logarithmic_values(1e-6, 1e-2, plan.diameters);
  const auto points = wire_points(sweep, jobs);
  return {tabulate(points, [](const WirePoint& p) { return row_of(p); }),
          {},
          {{"materials-wires", wire_figure(points)}}};
}

MaterialPart packing_part(const MaterialPlan& plan, const Jobs& jobs) {
  const auto runs = run_packings(damped_packings(plan.packing), {.samples = 100}, jobs);
  const auto failed = std::ranges::count_if(runs, [](const PackingRun& r) { return r.status != "finished"; });
  return {tabulate(runs, [](const PackingRun& run) { return row_of(run); }),
          {},
          {{"materials-packing", damped_packing_figure(runs)}},
          static_cast<int>(failed)};
}

}  // namespace fiberchain::compare
