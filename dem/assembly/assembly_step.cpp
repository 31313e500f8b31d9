#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/assembly/assembly_state.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/stiff_limits.hpp"

// The time step of an assembly: bonds and motion, contacts, the Verlet criterion.
namespace fiberchain::dem {
namespace {

/// Steps between two searches for spheres that have blown up.
constexpr int steps_between_checks = 256;

/// Overlap over the smaller radius, path of a step over the smallest: beyond them a body may be on the other
/// side of another before contacts have stopped it.
constexpr double deepest_passable = 1, longest_passable = 0.5;

RelativeMotion<double, 3> motion_between(const Vec<double, 3>& v1, const Vec<double, 3>& w1,
                                         const Vec<double, 3>& v2, const Vec<double, 3>& w2) {
  return {v2 - v1, 0.5 * (w1 + w2), w2 - w1};
}

/// Work of a kick on what a bond that is solved for adds to the mass matrix [J].
double solved_work(const MarchParameters<double, 3>& p, const MovingSphere<double, 3>& a,
                   const MovingSphere<double, 3>& b, const RelativeMotion<double, 3>& after) {
  const Vec<double, 3> r = b.pose.position - a.pose.position;
  const RelativeMotion<double, 3> before = motion_between(a.velocity, a.spin, b.velocity, b.spin);
  const RelativeMotion<double, 3> change{after.velocity - before.velocity, after.mean_spin - before.mean_spin,
                                         after.relative_spin - before.relative_spin};
  constexpr Physics physics{.dimension = 3,
                            .form = BondForm::total,
                            .damped = true,
                            .settling_damping = false,
                            .curved = false,
                            .solved = Solved::bonds};
  const auto action = dashpot_action(solved_dashpots<physics, double>(p), r, unit(r), change);
  const Vec<double, 3> w = 0.5 * (before.mean_spin + after.mean_spin);
  return dot(action.force, 0.5 * (before.velocity + after.velocity) - cross(w, r)) +
         0.5 * dot(action.moment, before.relative_spin + after.relative_spin);
}

}  // namespace

void Assembly::State::rebuild_neighbor_list() {
  contacts.rebuild_neighbor_list(rows, time(), pool);
  displacement_budget = 0.5 * contacts.skin();
}

/// Bounds the displacements by the speeds and checks the Verlet criterion once they may violate it. Returns
/// whether it was checked.
bool Assembly::State::update_neighbor_list() {
  const double longest = *std::ranges::max_element(paths);
  longest_path = std::max(longest_path, longest + step * contacts.fastest_wall(time()));
  contacts.add_displacements(paths, time());
  displacement_budget -= longest;
  if (contacts.walls_moved_far(time())) {
    rebuild_neighbor_list();
  } else if (displacement_budget > 0) {
    return false;
  } else {
    displacement_budget = contacts.update_neighbor_list(rows, pool);
  }
  sort_where_mixed();
  return true;
}

/// Energy dissipated by the fluid in a step [J]: the work of all other forces less the change of kinetic
/// energy.
double Assembly::State::fluid_dissipation(const FiberBlock& block, const BlockSnapshot& before) const {
  const GroupKind& kind = kinds[block.group()];
  double dissipated = 0;
  for (int lane = 0; lane < block.lanes(); ++lane) {
    for (int i = 0; i < kind.spheres(); ++i) {
      const MovingSphere<double, 3> s = block.sphere(kind, before, lane, i);
      const double m = kind.share(i) * kind.mass, J = kind.share(i) * kind.inertia;
      const Vec<double, 3> v = rows.velocity(block.first(lane) + i), w = rows.spin(block.first(lane) + i);
      for (int c = 0; c < 3; ++c) {
        const double mean = 0.5 * (s.velocity[c] + v[c]), mean_spin = 0.5 * (s.spin[c] + w[c]);
        dissipated += mean * (step * s.force[c] - m * (v[c] - s.velocity[c])) +
                      mean_spin * (step * s.moment[c] - J * (w[c] - s.spin[c]));
      }
      if (i == 0 || options.integrator == Integrator::leapfrog) continue;
      const std::int64_t row = block.first(lane) + i;
      dissipated -= solved_work(kind.parameters, block.sphere(kind, before, lane, i - 1), s,
                                motion_between(rows.velocity(row - 1), rows.spin(row - 1), v, w));
    }
  }
  return dissipated;
}

/// Distance from the end of a block to the rows that are prefetched during its step; 0 where all rows fit the
/// caches.
std::int64_t Assembly::State::rows_ahead(std::int64_t end) const {
  constexpr std::int64_t two_parts = 2 * cache_sized_part;  // those whose contacts come next, on two threads
  return rows.count > 2 * two_parts ? std::min(two_parts, rows.count - end) : 0;
}

double Assembly::State::step_block(std::size_t number, LoadRange own_loads, LaneArray& own_scratch) {
  FiberBlock& block = blocks[number];
  const FiberBlock* next =
      number + 1 < blocks.size() && blocks[number + 1].group() == block.group() ? &block + 1 : nullptr;
  const GroupKind& kind = kinds[block.group()];
  const std::int64_t ahead = rows_ahead(block.end(kind));
  if (options.account_energy) block.account(kind, rows, own_scratch);
  if (held.in_block(number)) {
    held.before_step(*this, number);
    const double fastest = block.step(kind, rows, own_loads, own_scratch, gradient.data(), next, ahead);
    return std::max(fastest, held.after_step(*this, number));
  }
  if (!options.account_energy || !domain.fluid)
    return block.step(kind, rows, own_loads, own_scratch, gradient.data(), next, ahead);
  BlockSnapshot before;
  block.snapshot(kind, rows, own_loads, gradient.data(), before, true);
  const double fastest = block.step(kind, rows, own_loads, own_scratch, gradient.data(), next, ahead);
  block.add_fluid_dissipation(fluid_dissipation(block, before));
  return fastest;
}

void Assembly::State::move_part(int part, int thread) {
  double fastest = 0;
  const LoadRange own = loads.of(part);
  for (int b = part_blocks[part]; b < part_blocks[part + 1]; ++b)
    fastest = std::max(fastest, step_block(b, own, scratch[thread]));
  loads.give_back(part, thread);
  paths[part] = step * std::sqrt(fastest);
}

void Assembly::State::has_moved() {
  ++steps;
  contacts.move_walls();
  if (held.any()) {
    held.end_kick();
    held.grasp(*this);
  }
  set_gradient();
}

/// Bonds and motion of all fibers.
void Assembly::State::move() {
  pool.parallel_for(contacts.parts().count(), [&](int k, int thread) { move_part(k, thread); });
  has_moved();
  watch.lap(&StepTimes::bonds_and_motion);
}

/// Loads of all contacts.
void Assembly::State::touch() {
  contacts.work_out(rows, time(), loads, pool);
  for (int k = 0; held.any() && k < contacts.parts().count(); ++k) held.add_loads(k, loads.of(k));
  watch.lap(&StepTimes::contacts);
}

void Assembly::State::touch_and_keep() {
  ContactMemory before = contacts.memory();
  touch();
  last_forces = contacts.last_forces(std::move(before), rows, time());
}

/// Both, part by part: a part is moved while its rows are still in the cache from its contacts.
void Assembly::State::touch_and_move() {
  const double now = time();
  wavefront.run(
      pool, contacts.reach(),
      [&](int k, int thread) {
        const TimedPart timed(watch.on, part_times[k].contacts);
        contacts.work_out(k, rows, now, loads.take(k, thread));
      },
      [&](int k, int thread) {
        const TimedPart timed(watch.on, part_times[k].bonds_and_motion);
        contacts.reduce_halo_forces(k, loads.of(k));
        if (held.any()) held.add_loads(k, loads.of(k));
        move_part(k, thread);
      });
  contacts.end_forces(now);
  has_moved();
  watch.lap(part_times);
}

/// False where positions are no longer finite.
bool Assembly::State::march_some(int count, ContactForces at_end) {
  last_forces.reset();
  watch.lap(nullptr);
  if (watch.on) pool.measure_idle_times();
  for (int n = 0; n < count; ++n) {
    n == 0 ? move() : touch_and_move();
    account_parted();
    try {
      settle_breaks();
      if (update_neighbor_list()) watch.lap(&StepTimes::search);
    } catch (const InvalidInput&) {
      for (int k = 0; k < contacts.parts().count(); ++k)
        loads.take(k, 0);  // the search for the cause needs loads
      return false;
    }
  }
  at_end == ContactForces::kept ? touch_and_keep() : touch();
  account_parted();
  return true;
}

/// Contacts push apart what overlaps by its center's side: beyond it, they push through.
void Assembly::State::check_passage(std::int64_t from) const {
  const bool through = contacts.deepest() > deepest_passable;
  if (!through && !(longest_path > longest_passable * smallest_radius())) return;
  throw Diverged(fmt::format(
      "bodies may have passed through each other or through a wall, {} the fastest, between steps {} and {} "
      "(dt = {:.6g} s, t = {:.6g} s): {}; likely cause: contacts too soft for these speeds, a wall that "
      "closes or comes upon "
      "spheres, or a step too long",
      place_of(fastest_sphere()), from, steps, step, time(),
      through ? fmt::format("an overlap reached {:.3g} of the smaller radius, allowed {:g}",
                            contacts.deepest(), deepest_passable)
              : fmt::format("a sphere moved by {:.3g} of the smallest radius in a step, allowed {:g}",
                            longest_path / smallest_radius(), longest_passable)));
}

/// Stops where bonds that are solved for turn in a step, or are drawn out, beyond what steps bear
/// (stiff_limits.hpp).
void Assembly::State::check_stiff(std::int64_t from) {
  std::vector<BondExtremes> extremes(kinds.size());
  for (FiberBlock& block : blocks) {
    BondExtremes& most = extremes[block.group()];
    const BondExtremes own = block.take_extremes();
    most.relative_speed = std::max(most.relative_speed, own.relative_speed);
    most.length = std::max(most.length, own.length);
  }
  for (std::size_t g = 0; g < kinds.size(); ++g) {
    const Fiber& fiber = kinds[g].chain.fiber;
    const double l = bond_length(fiber), turn = step * extremes[g].relative_speed / l,
                 tension = bond_stiffness(fiber).stretch * (extremes[g].length - l),
                 bearable = kinds[g].bearable_tension;
    largest_turn = std::max(largest_turn, turn);
    if (turn <= dem::largest_turn && tension <= bearable) continue;
    throw Diverged(fmt::format(
        "the run cannot be trusted, {} the fastest: between steps {} and {} (dt = {:.6g} s, t = {:.6g} s) a "
        "bond {}; "
        "likely cause: a step too long for these speeds",
        place_of(fastest_sphere()), from, steps, step, time(),
        turn > dem::largest_turn
            ? fmt::format("turned by {:.3g} rad in a step, allowed {:g}", turn, dem::largest_turn)
            : fmt::format("had a tension of {:.3g} N, which bonds that are solved for bear up to {:.3g} N",
                          tension, bearable)));
  }
}

std::int64_t Assembly::State::fastest_sphere() const {
  std::int64_t fastest = 0;
  double most = -1;
  for (std::int64_t i = 0; i < rows.count; ++i) {
    const double speed = norm(rows.velocity(i));
    if (speed > most) fastest = i, most = speed;
  }
  return fastest;
}

double Assembly::State::smallest_radius() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const GroupKind& kind : kinds) smallest = std::min(smallest, sphere_radius(kind.chain.fiber));
  return smallest;
}

void Assembly::State::march(std::int64_t count, ContactForces at_end) {
  for (std::int64_t done = 0; done < count;) {
    const std::int64_t from = steps, now = std::min<std::int64_t>(steps_between_checks, count - done);
    const bool finite =
        march_some(static_cast<int>(now), done + now == count ? at_end : ContactForces::not_kept);
    const std::int64_t sphere = broken();
    if (sphere >= 0 || !finite) fail(std::max<std::int64_t>(sphere, 0), from);
    if (!options.allow_passage) check_passage(from);
    if (options.integrator == Integrator::leapfrog_stiff) check_stiff(from);
    done += steps - from;
  }
}

}  // namespace fiberchain::dem
