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

const std::vector<std::string> kColumns = {"step",         "simulated_time", "contacts",    "height",
                                           "bending_mean", "overlap_mean",   "overlap_peak"};

/// Terms of the balance that a run knows: those stored, and where energy is accounted all.
std::vector<EnergyMechanism> known_terms(bool accounted) {
  std::vector<EnergyMechanism> terms;
  std::ranges::copy_if(energy_mechanisms, std::back_inserter(terms), [&](const EnergyMechanism& term) {
    return accounted || term.role == EnergyRole::stored;
  });
  return terms;
}

/// Rows of a frame that the next fiber takes.
struct FrameEnd {
  std::size_t sphere = 0, bond = 0;
  std::int32_t fiber = 0;
  std::vector<std::int64_t> group_begin = {};  ///< first sphere of each group of the assembly
};

/// What does not move of a fiber, and where its rows begin; the rest of them is at rest in one place.
void put_fiber(TrajectoryFrame& frame, const Fiber& fiber, const V& place, FrameEnd& end) {
  const double radius = sphere_radius(fiber);
  for (int i = 0; i <= fiber.aspect_ratio; ++i, ++end.sphere) {
    if (i > 0) frame.bonds[end.bond++] = {static_cast<std::int64_t>(end.sphere) - 1, {}, 0};
    frame.position[end.sphere] = place;
    frame.velocity[end.sphere] = {};
    frame.radius[end.sphere] = radius;
    frame.fiber[end.sphere] = end.fiber;
  }
  ++end.fiber;
}

/// One to be inserted later.
void put_absent(TrajectoryFrame& frame, const Fiber& fiber, const V& place, FrameEnd& end) {
  put_fiber(frame, fiber, place, end);
  frame.absent += fiber.aspect_ratio + 1;
}

/// One that found no room.
void put_missing(TrajectoryFrame& frame, const Fiber& fiber, const V& place, FrameEnd& end) {
  for (int i = 0; i <= fiber.aspect_ratio; ++i)
    frame.missing.push_back(static_cast<std::int64_t>(end.sphere) + i);
  put_fiber(frame, fiber, place, end);
}

/// The fibers of a group that are there.
void put_group(TrajectoryFrame& frame, const Assembly& assembly, int group, FrameEnd& end) {
  const Fiber& fiber = assembly.chain(group).fiber;
  const auto spheres = static_cast<std::size_t>(fiber.aspect_ratio) + 1, bonds = spheres - 1;
  end.group_begin.push_back(static_cast<std::int64_t>(end.sphere));
  const FrameEnd begin = end;
  for (int f = 0; f < assembly.fibers(group); ++f) put_fiber(frame, fiber, {}, end);
  assembly.visit(group, [&](int f, const ChainState<3>& state, const std::vector<BondState>& states) {
    const std::size_t sphere = begin.sphere + static_cast<std::size_t>(f) * spheres,
                      bond = begin.bond + static_cast<std::size_t>(f) * bonds;
    for (std::size_t i = 0; i < spheres; ++i) {
      frame.position[sphere + i] = state.poses[i].position;
      frame.velocity[sphere + i] = state.velocity[i];
    }
    for (std::size_t i = 0; i < bonds; ++i) {
      frame.bonds[bond + i].force = states[i].force;
      frame.bonds[bond + i].bending_angle = states[i].bending_angle;
    }
  });
}

/// The sphere of a frame that an assembly has by this number: groups are as long in both, between them are
/// fibers that found no room.
std::int64_t sphere_in_frame(const Assembly& assembly, const FrameEnd& end, std::int64_t number) {
  int group = assembly.groups() - 1;
  while (assembly.first_sphere(group, 0) > number) --group;
  return end.group_begin[static_cast<std::size_t>(group)] + number - assembly.first_sphere(group, 0);
}

void put_contacts(TrajectoryFrame& frame, const Assembly& assembly, const FrameEnd& end) {
  frame.has_contacts = true;
  for (const ContactState& contact : assembly.contact_forces()) {
    FrameContact row{.first = sphere_in_frame(assembly, end, contact.key.first.number),
                     .second = contact.key.second.number + 1,
                     .kind = ContactKind::wall,
                     .point = contact.point,
                     .normal = contact.normal,
                     .force = contact.force};
    if (is_of_fiber(contact.key.second)) {
      row.second = sphere_in_frame(assembly, end, contact.key.second.number);
      const auto fiber_of = [&](std::int64_t sphere) {
        return frame.fiber[static_cast<std::size_t>(sphere)];
      };
      row.kind = fiber_of(row.first) == fiber_of(row.second) ? ContactKind::same_fiber : ContactKind::fibers;
    }
    frame.contacts.push_back(row);
  }
}

/// Room for all fibers of the scene, those of batches to come included.
void resize(TrajectoryFrame& frame, const PackingScene& scene, const Assembly& assembly) {
  std::size_t spheres = 0, fibers = 0;
  const auto add = [&](const Fiber& fiber, std::int64_t count) {
    spheres += static_cast<std::size_t>(count) * (static_cast<std::size_t>(fiber.aspect_ratio) + 1);
    fibers += static_cast<std::size_t>(count);
  };
  for (int g = 0; g < groups_at_start(scene); ++g) add(assembly.chain(g).fiber, assembly.fibers(g));
  for (int n = 1; n < scene.batches.number; ++n) {
    for (const auto& [chain, count] : batch_counts(scene, n)) add(chain.fiber, count);
  }
  frame.position.resize(spheres), frame.velocity.resize(spheres), frame.radius.resize(spheres);
  frame.fiber.resize(spheres), frame.bonds.resize(spheres - fibers);
  frame.absent = 0;
  frame.missing.clear();
  frame.has_contacts = false;
  frame.contacts.clear();
  frame.walls.clear();
}

}  // namespace

V upward(const PackingScene& scene) {
  const V& gravity = scene.domain.gravity;
  const double size = norm(gravity);
  return size > 0 ? (-1 / size) * gravity : V{0, 0, 1};
}

std::vector<WallSurface> wall_surfaces(const PackingScene& scene) {
  return wall_surfaces(scene.domain.walls, scene.scene_box.low, scene.scene_box.high);
}

bool walls_stay(const PackingScene& scene, double from, double to) {
  if (std::isnan(from) || std::isnan(to)) return false;
  return std::ranges::all_of(scene.domain.walls, [&](const Wall& wall) {
    return is_at_rest(wall) && is_active(wall, from) == is_active(wall, to);
  });
}

RunMoment measure(const Assembly& assembly, const PackingScene& scene, std::vector<double>& room) {
  constexpr double fraction = 0.95;
  const V up = upward(scene);
  assembly.coordinates(up, room);
  const AssemblySample sample = assembly.sample();
  return {.step = assembly.steps(),
          .time = assembly.time(),
          .contacts = assembly.touching(),
          .height = quantile(room, fraction) - floor_of(scene, up),
          .bending_mean = sample.bending_mean(),
          .overlap_mean = sample.overlap_mean(),
          .overlap_peak = assembly.deepest_overlap(),
          .energy = sample.energy,
          .pieces = assembly.pieces()};
}

RunMoment measure(const Assembly& assembly, const PackingScene& scene) {
  std::vector<double> room;
  return measure(assembly, scene, room);
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

bool bonds_break(const PackingScene& scene) {
  return std::ranges::any_of(scene.kinds, [](const PackingFiberKind& kind) {
    return kind.fiber.strength && kind.fiber.strength->any();
  });
}

Table run_log_table(const PackingScene& scene) {
  std::vector<std::string> columns = kColumns;
  if (bonds_break(scene)) columns.push_back("pieces");
  const std::vector<std::string> energies = energy_columns(scene.account_energy);
  columns.insert(columns.end(), energies.begin(), energies.end());
  columns.insert(columns.end(), {"step_rate", "time_left"});
  return Table(columns);
}

Table run_log_row(const RunMoment& moment, const PackingScene& scene, double step_rate, double time_left) {
  NamedRow row = {{"step", moment.step},
                  {"simulated_time", moment.time},
                  {"contacts", moment.contacts},
                  {"height", moment.height},
                  {"bending_mean", moment.bending_mean},
                  {"overlap_mean", moment.overlap_mean},
                  {"overlap_peak", moment.overlap_peak},
                  {"step_rate", known(step_rate)},
                  {"time_left", known(time_left)}};
  if (bonds_break(scene)) row.emplace_back("pieces", moment.pieces);
  const NamedRow energies = energy_cells(moment.energy, scene.account_energy);
  row.insert(row.end(), energies.begin(), energies.end());
  Table table = run_log_table(scene);
  table.append(row);
  return table;
}

void fill_frame(const Assembly& assembly, const PackingScene& scene,
                const std::vector<std::int64_t>& inserted, TrajectoryFrame& frame) {
  frame.time = assembly.time();
  frame.step = assembly.steps();
  frame.low = scene.scene_box.low;
  frame.high = scene.scene_box.high;
  for (int a = 0; a < 3; ++a) frame.periodic[a] = scene.domain.period[a] > 0;
  resize(frame, scene, assembly);
  FrameEnd end;
  int group = 0;
  while (group < groups_at_start(scene)) put_group(frame, assembly, group++, end);
  std::size_t later = 0;
  for (int n = 1; n < scene.batches.number; ++n) {
    for (const auto& [chain, count] : batch_counts(scene, n)) {
      const bool is_in = later < inserted.size();
      const std::int64_t fibers = is_in ? inserted[later++] : 0;
      if (fibers > 0) put_group(frame, assembly, group++, end);
      for (std::int64_t f = fibers; f < count; ++f) {
        is_in ? put_missing(frame, chain.fiber, scene.scene_box.low, end)
              : put_absent(frame, chain.fiber, scene.scene_box.low, end);
      }
    }
  }
  if (scene.output.contacts) put_contacts(frame, assembly, end);
  for (const Wall& wall : assembly.walls()) frame.walls.push_back(frame_wall(wall, assembly.time()));
}

TrajectoryFrame frame_of(const Assembly& assembly, const PackingScene& scene,
                         const std::vector<std::int64_t>& inserted) {
  TrajectoryFrame frame{};
  fill_frame(assembly, scene, inserted, frame);
  return frame;
}

}  // namespace fiberchain::dem
