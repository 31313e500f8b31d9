#include "dem/run/samples.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dem/analysis/observables.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

/// Height of the lowest corner of the scene box [m].
double floor_of(const PackingScene& scene, const V& up) {
  double lowest = 0;
  for (int a = 0; a < 3; ++a)
    lowest += std::min(up[a] * scene.scene_box.low[a], up[a] * scene.scene_box.high[a]);
  return lowest;
}

double bending_mean(const Assembly& assembly) {
  Mean mean;
  for (int g = 0; g < assembly.groups(); ++g) {
    for (const auto& bonds : assembly.bonds(g)) {
      for (const BondState& bond : bonds) mean.sum += bond.bending_angle, ++mean.count;
    }
  }
  return mean.value();
}

const std::vector<std::string> kColumns = {"step", "simulated_time", "contacts", "height", "bending_mean"};
/// Terms of the balance that a run knows: those stored, and where energy is accounted all.
std::vector<EnergyMechanism> known_terms(bool accounted) {
  std::vector<EnergyMechanism> terms;
  std::ranges::copy_if(energy_mechanisms, std::back_inserter(terms), [&](const EnergyMechanism& term) {
    return accounted || term.role == EnergyRole::stored;
  });
  return terms;
}

/// A fiber that is not there: all spheres at one point, at rest.
void add_nobody(TrajectoryFrame& frame, const Fiber& fiber, const V& place) {
  const std::int32_t number = frame.fiber.empty() ? 0 : frame.fiber.back() + 1;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    if (i > 0) frame.bonds.push_back({static_cast<std::int64_t>(frame.position.size()) - 1, {}, 0});
    frame.position.push_back(place);
    frame.velocity.push_back({});
    frame.radius.push_back(sphere_radius(fiber));
    frame.fiber.push_back(number);
  }
}

/// One to be inserted later.
void add_absent(TrajectoryFrame& frame, const Fiber& fiber, const V& place) {
  add_nobody(frame, fiber, place);
  frame.absent += fiber.aspect_ratio + 1;
}

/// One that found no room.
void add_missing(TrajectoryFrame& frame, const Fiber& fiber, const V& place) {
  for (int i = 0; i <= fiber.aspect_ratio; ++i)
    frame.missing.push_back(static_cast<std::int64_t>(frame.position.size()) + i);
  add_nobody(frame, fiber, place);
}

void add_fiber(TrajectoryFrame& frame, const ChainState<3>& state, const std::vector<BondState>& bonds,
               double radius) {
  const std::int32_t number = frame.fiber.empty() ? 0 : frame.fiber.back() + 1;
  auto sphere = static_cast<std::int64_t>(frame.position.size());
  for (const BondState& bond : bonds) {
    frame.bonds.push_back({sphere++, bond.force, bond.bending_angle});
  }
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    frame.position.push_back(state.poses[i].position);
    frame.velocity.push_back(state.velocity[i]);
    frame.radius.push_back(radius);
    frame.fiber.push_back(number);
  }
}

}  // namespace

V upward(const PackingScene& scene) {
  const V& gravity = scene.domain.gravity;
  const double size = norm(gravity);
  return size > 0 ? (-1 / size) * gravity : V{0, 0, 1};
}

RunMoment measure(const Assembly& assembly, const PackingScene& scene) {
  const V up = upward(scene);
  return {assembly.steps(),       assembly.time(),
          assembly.touching(),    heights(assembly.placed(), up).quantile - floor_of(scene, up),
          bending_mean(assembly), assembly.energy()};
}

std::vector<std::string> energy_columns(bool accounted) {
  std::vector<std::string> columns;
  for (const EnergyMechanism& term : known_terms(accounted)) columns.emplace_back(term.column);
  if (accounted) columns.emplace_back(energy_total.column);
  return columns;
}

NamedRow energy_cells(const EnergyBalance& energy, bool accounted) {
  NamedRow row;
  for (const EnergyMechanism& term : known_terms(accounted))
    row.emplace_back(term.column, energy.*term.value);
  if (accounted) row.emplace_back(energy_total.column, total(energy));
  return row;
}

Table run_log_table(const PackingScene& scene) {
  std::vector<std::string> columns = kColumns;
  const std::vector<std::string> energies = energy_columns(scene.account_energy);
  columns.insert(columns.end(), energies.begin(), energies.end());
  columns.insert(columns.end(), {"step_rate", "time_left"});
  return Table(columns);
}

Table run_log_row(const RunMoment& moment, const PackingScene& scene, double step_rate, double time_left) {
  NamedRow row = {
      {"step", moment.step},          {"simulated_time", moment.time},       {"contacts", moment.contacts},
      {"height", moment.height},      {"bending_mean", moment.bending_mean}, {"step_rate", known(step_rate)},
      {"time_left", known(time_left)}};
  const NamedRow energies = energy_cells(moment.energy, scene.account_energy);
  row.insert(row.end(), energies.begin(), energies.end());
  Table table = run_log_table(scene);
  table.append(row);
  return table;
}

TrajectoryFrame frame_of(const Assembly& assembly, const PackingScene& scene,
                         const std::vector<std::int64_t>& inserted) {
  TrajectoryFrame frame{};
  frame.time = assembly.time();
  frame.step = assembly.steps();
  frame.low = scene.scene_box.low;
  frame.high = scene.scene_box.high;
  for (int a = 0; a < 3; ++a) frame.periodic[a] = scene.domain.period[a] > 0;
  const auto spheres = static_cast<std::size_t>(assembly.spheres());
  frame.position.reserve(spheres), frame.velocity.reserve(spheres), frame.radius.reserve(spheres);
  frame.fiber.reserve(spheres), frame.bonds.reserve(spheres);
  int group = 0;
  const auto add_group = [&] {
    const double radius = sphere_radius(assembly.chain(group).fiber);
    assembly.visit(group++, [&](const ChainState<3>& state, const std::vector<BondState>& bonds) {
      add_fiber(frame, state, bonds, radius);
    });
  };
  while (group < groups_at_start(scene)) add_group();
  std::size_t later = 0;
  for (int n = 1; n < scene.batches.number; ++n) {
    for (const auto& [chain, count] : batch_counts(scene, n)) {
      const bool is_in = later < inserted.size();
      const std::int64_t fibers = is_in ? inserted[later++] : 0;
      if (fibers > 0) add_group();
      for (std::int64_t f = fibers; f < count; ++f) {
        is_in ? add_missing(frame, chain.fiber, scene.scene_box.low)
              : add_absent(frame, chain.fiber, scene.scene_box.low);
      }
    }
  }
  return frame;
}

}  // namespace fiberchain::dem
