#include "dem/assembly/assembly_state.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dem/model/errors.hpp"
#include "dem/motion/half_step.hpp"
#include "dem/motion/kernels/chain_lane.hpp"

namespace fiberchain::dem {
namespace {

/// The rows of `from` at the beginning of larger ones.
SphereStorage grown(const SphereStorage& from, std::int64_t count, bool oriented) {
  SphereStorage rows(count, oriented);
  const auto copy = [&](const LaneArray& source, LaneArray& target, int numbers) {
    std::copy_n(source.data(), from.count * numbers, target.data());
  };
  copy(from.position_radius, rows.position_radius, position_radius_size);
  copy(from.motions, rows.motions, velocity_spin_size);
  if (oriented && from.count > 0) copy(from.orientation, rows.orientation, orientation_size);
  return rows;
}

/// What the dashpots of a bond take at this moment [W].
double dashpot_power(const BondParameters<double>& law, const MovingSphere<double, 3>& a, const MovingSphere<double, 3>& b) {
  const Vec<double, 3> r = b.pose.position - a.pose.position;
  const RelativeMotion<double, 3> motion{b.velocity - a.velocity, 0.5 * (a.spin + b.spin), b.spin - a.spin};
  const BondLoads<double, 3> loads = act_at_middle(r, dashpot_action(law, r, unit(r), motion));
  return power_taken(loads, motion.velocity, a.spin, b.spin);
}

/// Fibers side by side at most.
constexpr int widest_block = 8;

/// Their numbers are int32, with some to pad lanes.
constexpr std::int64_t most_spheres = 2'000'000'000;

/// Steps between two looks at all spheres.
constexpr int kStepsBetweenLooks = 256;

}  // namespace

std::int64_t Assembly::State::first_sphere(int group, int fiber) const {
  const Slot at = slot(group, fiber);
  return blocks[at.block].first(at.lane);
}

int Assembly::State::add(const std::vector<FiberGroup>& groups) {
  std::int64_t count = rows.count;
  for (const FiberGroup& group : groups) count += static_cast<std::int64_t>(group.fibers.size()) * group.chain.poses.size();
  if (count > most_spheres) throw InvalidInput(fmt::format("spheres = {} is not allowed: at most {}", count, most_spheres));
  contacts.check_periods(groups);
  const bool oriented = options.orientations || packing_law(options).from_poses;
  std::int64_t row = rows.count;
  rows = grown(rows, count, oriented);
  const int first_new = static_cast<int>(blocks.size());
  std::size_t scratch_size = scratch.empty() ? 0 : scratch[0].size();
  for (const FiberGroup& group : groups) {
    const int number = static_cast<int>(kinds.size());
    kinds.push_back(group_kind(group.chain, group.fibers.size(), options, domain, step));
    GroupKind& kind = kinds.back();
    fibers.push_back(static_cast<int>(group.fibers.size()));
    first_block.push_back(static_cast<int>(blocks.size()));
    contacts.add(group.chain.fiber, fibers.back());
    scratch_size = std::max(scratch_size, kind.kernel->scratch(group.chain.fiber.aspect_ratio));
    for (std::size_t f = 0; f < group.fibers.size(); f += static_cast<std::size_t>(kind.kernel->width)) {
      const std::size_t end = std::min(group.fibers.size(), f + kind.kernel->width);
      const std::vector<ChainState<3>> lanes(group.fibers.begin() + f, group.fibers.begin() + end);
      blocks.emplace_back(kind, number, static_cast<int>(blocks.size()) - first_block.back(), row, lanes, options.account_energy, rows);
      row = blocks.back().end(kind);
    }
    if (gradient.size() == 0) gradient = LaneArray(9 * kind.kernel->width);
  }
  scratch.clear();
  for (int t = 0; t < options.threads; ++t) scratch.emplace_back(scratch_size);
  set_gradient();
  own_times.resize(options.threads);
  const std::vector<double> loads_before = loads.all();
  contacts.begin(rows, partition_of_blocks(), time(), pool);
  loads = ForceBuffers(contacts.parts(), options.threads);
  loads.set(loads_before.data(), loads_before.size());
  displacement_budget = 0.5 * contacts.skin();
  wave = WavefrontSchedule(contacts.parts().count());
  paths.assign(contacts.parts().count(), 0);
  return first_new;
}

/// Whole blocks of any width, so that the cuts do not depend on it.
Partition Assembly::State::partition_of_blocks() {
  std::vector<std::int32_t> ends;
  for (std::size_t g = 0; g < kinds.size(); ++g) {
    for (int f = 0; f < fibers[g]; f += widest_block) {
      const int last = std::min(f + widest_block, fibers[g]) - 1;
      ends.push_back(static_cast<std::int32_t>(first_sphere(static_cast<int>(g), last)) + kinds[g].spheres());
    }
  }
  Partition parts = cache_sized_partition(ends);
  part_blocks.assign(1, 0);
  for (int k = 0; k < parts.count(); ++k) {
    int b = part_blocks.back();
    while (b < static_cast<int>(blocks.size()) && blocks[b].first(0) < parts.end(k)) ++b;
    part_blocks.push_back(b);
  }
  return parts;
}

void Assembly::State::start_blocks(int from) {
  for (std::size_t b = from; b < blocks.size(); ++b) {
    blocks[b].start(kinds[blocks[b].group()], rows, loads.of(part_of(blocks[b])), gradient.data(), gradient_now());
  }
}

MovingSphere<double, 3> Assembly::State::sphere_now(const FiberBlock& block, const BlockSnapshot& snapshot, int lane, int i) const {
  const GroupKind& kind = kinds[block.group()];
  MovingSphere<double, 3> s = block.sphere(kind, snapshot, lane, i);
  move_half_step(s, EndLoad<double, 3>{}, kind.chain.fiber, kind.drag, gradient_now(), step, false);
  return s;
}

Gradient Assembly::State::gradient_now() const {
  return domain.fluid ? gradient_at(domain.fluid->flow, time()) : Gradient{};
}

void Assembly::State::set_gradient() {
  if (!domain.fluid) return;
  const Gradient A = gradient_now();
  const std::size_t width = gradient.size() / 9;
  for (int n = 0; n < 9; ++n) std::fill_n(gradient.data() + n * width, width, A[n / 3][n % 3]);
}

void Assembly::State::rebuild_neighbor_list() {
  contacts.rebuild_neighbor_list(rows, time(), pool);
  displacement_budget = 0.5 * contacts.skin();
}

/// Speeds tell when a sphere may have moved so far that a pair is missing, or a wall. Whether lists were snapshot at.
bool Assembly::State::update_neighbor_list() {
  contacts.add_displacements(paths);
  if (contacts.walls_moved_far(time())) {
    rebuild_neighbor_list();
    return true;
  }
  displacement_budget -= *std::ranges::max_element(paths);
  if (displacement_budget > 0) return false;
  displacement_budget = contacts.follow(rows, pool);
  return true;
}

/// Kinetic energy and the work of all other forces tell what the fluid took.
double Assembly::State::fluid_taken(const FiberBlock& block, const BlockSnapshot& before) const {
  const GroupKind& kind = kinds[block.group()];
  double dissipated = 0;
  for (int lane = 0; lane < block.lanes(); ++lane) {
    for (int i = 0; i < kind.spheres(); ++i) {
      const MovingSphere<double, 3> s = block.sphere(kind, before, lane, i);
      const Vec<double, 3> v = rows.velocity(block.first(lane) + i), w = rows.spin(block.first(lane) + i);
      for (int c = 0; c < 3; ++c) {
        const double mean = 0.5 * (s.velocity[c] + v[c]), mean_spin = 0.5 * (s.spin[c] + w[c]);
        dissipated += mean * (step * s.force[c] - kind.mass * (v[c] - s.velocity[c])) +
                 mean_spin * (step * s.moment[c] - kind.inertia * (w[c] - s.spin[c]));
      }
    }
  }
  return dissipated;
}

/// From a block that ends there to the spheres whose rows are fetched meanwhile; 0 where none need be.
std::int64_t Assembly::State::rows_ahead(std::int64_t end) const {
  constexpr std::int64_t two_parts = 2 * cache_sized_part;  // contacts of the next part, the other thread's too, find them at hand
  return rows.count > 2 * two_parts ? std::min(two_parts, rows.count - end) : 0;
}

double Assembly::State::step_block(std::size_t number, LoadRange own_loads, LaneArray& own_scratch) {
  FiberBlock& block = blocks[number];
  const FiberBlock* next = number + 1 < blocks.size() && blocks[number + 1].group() == block.group() ? &block + 1 : nullptr;
  const GroupKind& kind = kinds[block.group()];
  const std::int64_t ahead = rows_ahead(block.end(kind));
  if (options.account_energy) block.account(kind, rows, own_scratch);
  if (!options.account_energy || !domain.fluid) return block.step(kind, rows, own_loads, own_scratch, gradient.data(), next, ahead);
  const BlockSnapshot before = block.snapshot(kind, rows, own_loads, gradient.data());
  const double fastest = block.step(kind, rows, own_loads, own_scratch, gradient.data(), next, ahead);
  block.add_fluid_taken(fluid_taken(block, before));
  return fastest;
}

void Assembly::State::move_part(int part, int thread) {
  double fastest = 0;
  const LoadRange own = loads.of(part);
  for (int b = part_blocks[part]; b < part_blocks[part + 1]; ++b) fastest = std::max(fastest, step_block(b, own, scratch[thread]));
  loads.give_back(part, thread);
  paths[part] = step * std::sqrt(fastest);
}

void Assembly::State::has_moved() {
  ++steps;
  set_gradient();
}

/// All fibers move.
void Assembly::State::move() {
  pool.each(contacts.parts().count(), [&](int k, int thread) { move_part(k, thread); });
  has_moved();
  watch.lap(&StepTimes::bonds_and_motion);
}

/// Loads of all contacts.
void Assembly::State::touch() {
  contacts.work_out(rows, time(), loads, pool);
  watch.lap(&StepTimes::contacts);
}

/// Both of these, part by part: what contacts have read and written is moved while it is at hand.
void Assembly::State::touch_and_move() {
  for (StepTimes& own : own_times) own = {};
  const double now = time();
  wave.run(
      pool, contacts.reach(),
      [&](int k, int thread) {
        const TimedPart timed(watch.on, own_times[thread].contacts);
        contacts.work_out(k, rows, now, loads.take(k, thread));
      },
      [&](int k, int thread) {
        const TimedPart timed(watch.on, own_times[thread].bonds_and_motion);
        contacts.reduce_halo_forces(k, loads.of(k));
        move_part(k, thread);
      });
  has_moved();
  watch.lap(own_times);
}

/// False where positions are no longer finite.
bool Assembly::State::march_some(int count) {
  watch.lap(nullptr);
  for (int n = 0; n < count; ++n) {
    n == 0 ? move() : touch_and_move();
    try {
      if (update_neighbor_list()) watch.lap(&StepTimes::search);
    } catch (const InvalidInput&) {
      for (int k = 0; k < contacts.parts().count(); ++k) loads.take(k, 0);  // who looks at the wreck finds some
      return false;
    }
  }
  touch();
  return true;
}

void Assembly::State::march(std::int64_t count) {
  for (std::int64_t done = 0; done < count;) {
    const std::int64_t from = steps;
    const bool finite = march_some(static_cast<int>(std::min<std::int64_t>(kStepsBetweenLooks, count - done)));
    const std::int64_t sphere = broken();
    if (sphere >= 0 || !finite) fail(std::max<std::int64_t>(sphere, 0), from);
    done += steps - from;
  }
}

/// First sphere that has blown up: not finite, or its bond ten times too long or short; -1 if none.
std::int64_t Assembly::State::broken() const {
  for (const FiberBlock& block : blocks) {
    const GroupKind& kind = kinds[block.group()];
    const double l = bond_length(kind.chain.fiber);
    for (int lane = 0; lane < block.lanes(); ++lane) {
      for (std::int64_t i = block.first(lane); i < block.first(lane) + kind.spheres(); ++i) {
        const Vec<double, 3> v = rows.velocity(i), w = rows.spin(i);
        const double sum = v[0] + v[1] + v[2] + w[0] + w[1] + w[2];
        const int bond = static_cast<int>(i - block.first(lane)) - 1;  // to the sphere before
        const bool bonded = bond >= 0 && !block.is_broken(kind, lane, bond);
        const double length = bonded ? norm(rows.position(i) - rows.position(i - 1)) : l + 0 * norm(rows.position(i));
        if (!std::isfinite(sum) || blown_up(length, l)) return i;
      }
    }
  }
  return -1;
}

void Assembly::State::fail(std::int64_t sphere, std::int64_t from) const {
  const bool walls_come = std::ranges::any_of(domain.walls, [](const Wall& w) { return w.from > 0 || norm(w.velocity) > 0; });
  int fiber = 0;
  for (const FiberBlock& block : blocks) {
    for (int lane = 0; lane < block.lanes(); ++lane, ++fiber) {
      const std::int64_t own = sphere - block.first(lane);
      if (own >= kinds[block.group()].spheres()) continue;
      throw Diverged(fmt::format("the run blew up: fiber {}, sphere {} between steps {} and {} (dt = {:.6g} s, t = {:.6g} s); "
                                 "likely cause: a step too long for the bonds or for how hard contacts press{}",
                                 fiber, own, from, steps, step, time(),
                                 walls_come ? ", or a wall that came upon spheres or moves into them" : ""));
    }
  }
  throw Diverged("the run blew up");
}

EnergyBalance Assembly::State::energy() const {
  EnergyBalance sum{};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const FiberBlock& block = blocks[b];
    const GroupKind& kind = kinds[block.group()];
    const BlockSnapshot now = snapshot(block);
    for (int lane = 0; lane < block.lanes(); ++lane) {
      ChainState<3> state;
      MovingSphere<double, 3> before{};
      for (int i = 0; i < kind.spheres(); ++i) {
        const MovingSphere<double, 3> s = sphere_now(block, now, lane, i);
        sum.kinetic += 0.5 * (kind.mass * dot(s.velocity, s.velocity) + kind.inertia * dot(s.spin, s.spin));
        sum.gravity -= dot(kind.weight, s.pose.position);
        state.poses.push_back(s.pose), state.velocity.push_back(s.velocity), state.spin.push_back(s.spin);
        // the kick that is centered on this moment has done half of its work
        if (options.account_energy && block.moved() && i > 0) sum.bond_damping += 0.5 * step * dashpot_power(kind.parameters.bond, before, s);
        before = s;
      }
      kind.law->add_stored_energy(kind.chain, state, kind.history_of(now.history.data(), lane, 0), kind.kernel->width,
                                  kind.kernel->history * kind.kernel->width, sum.bonds);
      if (!options.account_energy || !block.moved() || kind.law->dissipated == nullptr) continue;
      for (int i = 0; i + 1 < kind.spheres(); ++i) {  // in the last step, which is not accounted yet
        sum.bond_damping += kind.law->dissipated(kind.chain, state, i, kind.history_of(block.histories(), lane, i),
                                                 kind.kernel->width, step);
      }
    }
    sum.bond_damping += block.bond_damping();
    sum.bond_friction += block.bond_friction();
    sum.fluid += block.fluid_taken();
  }
  sum.contacts = contacts.stored_energy();
  const ContactAccount<double> dissipated = contacts.dissipated();
  sum.contact_normal = dissipated.normal_dashpot;
  sum.contact_tangential = dissipated.sliding;
  sum.contact_rolling = dissipated.rolling;
  sum.wall_work = contacts.wall_work();
  sum.inserted = inserted;
  return sum;
}

}  // namespace fiberchain::dem
