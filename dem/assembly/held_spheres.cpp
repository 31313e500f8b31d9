#include "dem/assembly/held_spheres.hpp"

#include <algorithm>

#include "dem/assembly/assembly_state.hpp"

// A step of what is held, and its start.
namespace fiberchain::dem {

bool HeldSpheres::is_solved(const Assembly::State& s) const {
  return s.options.integrator == Integrator::leapfrog_stiff;
}

std::vector<HeldChange> HeldSpheres::changes(const HeldFiber& fiber,
                                             const std::vector<MovingSphere<double, 3>>& spheres,
                                             bool back) const {
  std::vector<HeldChange> all;
  for (const int n : fiber.spheres) {
    const Held& held = spheres_[n];
    const Grip& grip = grips_[held.grip];
    const Motion& motion = motions_[held.grip];
    if (!motion.active || !grip.holds()) continue;
    if (all.empty() || all.back().sphere != held.at.sphere) all.push_back({.sphere = held.at.sphere});
    const MovingSphere<double, 3>& s = spheres[held.at.sphere];
    const Vec<double, 3>& x = s.pose.position;
    const Vec<double, 3> next = motion.center_next + rotate(motion.turn_next, held.body),
                         last = motion.center_before + rotate(motion.turn_before, held.body),
                         v = (1 / step_) * (next - x), v_before = (1 / step_) * (x - last);
    for (int c = 0; c < 3; ++c) {
      if (grip.place[c])
        all.back().is[c] = true, all.back().change[c] = v[c] - (back ? v_before[c] : s.velocity[c]);
      if (grip.turn[c])
        all.back().is[3 + c] = true, all.back().change[3 + c] =
                                         motion.spin[c] - (back ? motion.spin_before[c] : s.spin[c]);
    }
  }
  return all;
}

std::vector<MovingSphere<double, 3>> HeldSpheres::spheres_of(const Assembly::State& s, const HeldFiber& fiber,
                                                             const BlockSnapshot& snapshot) const {
  const GroupKind& kind = s.kinds[fiber.group];
  const FiberBlock& block = s.blocks[fiber.block];
  std::vector<MovingSphere<double, 3>> spheres;
  for (int i = 0; i < kind.spheres(); ++i) {
    spheres.push_back(block.sphere(kind, snapshot, fiber.lane, i));
    spheres.back().velocity = s.rows.velocity(block.first(fiber.lane) + i);
    spheres.back().spin = s.rows.spin(block.first(fiber.lane) + i);
  }
  return spheres;
}

void HeldSpheres::before_start(const Assembly::State& s) {
  if (!is_solved(s)) return;
  for (HeldFiber& fiber : fibers_) {
    const FiberBlock& block = s.blocks[fiber.block];
    const GroupKind& kind = s.kinds[fiber.group];
    fiber.before =
        spheres_of(s, fiber, block.snapshot(kind, s.rows, s.loads.of(s.part_of(block)), s.gradient.data()));
    const std::vector<HeldChange> held = changes(fiber, fiber.before, true);
    if (held.empty()) {
      fiber.before.clear();
      continue;
    }
    fiber.kick = held_kick(kind, fiber.before, held, KickMatrix::springs,
                           bond_parts(kind, block.histories(), fiber.lane));
  }
}

void HeldSpheres::start(Assembly::State& s) {
  for (HeldFiber& fiber : fibers_) {
    if (!is_solved(s) || fiber.before.empty()) continue;
    const std::int64_t first = s.first_row(fiber.group, fiber.fiber);
    for (std::size_t i = 0; i < fiber.before.size(); ++i) {
      double* own = s.rows.velocity_row(first + static_cast<std::int64_t>(i));
      for (int c = 0; c < 3; ++c) {
        own[c] = fiber.before[i].velocity[c] - 0.5 * fiber.kick.change[i][c];
        own[spin_offset + c] = fiber.before[i].spin[c] - 0.5 * fiber.kick.change[i][3 + c];
      }
    }
  }
  set_speeds(s);
}

void HeldSpheres::set_speeds(Assembly::State& s) const {
  for (const Held& held : spheres_) {
    const Grip& grip = grips_[held.grip];
    const Motion& motion = motions_[held.grip];
    if (!motion.active || !grip.holds()) continue;
    const Vec<double, 3> last = motion.center_before + rotate(motion.turn_before, held.body),
                         v = (1 / step_) * (s.rows.position(held.row) - last);
    double* own = s.rows.velocity_row(held.row);
    for (int c = 0; c < 3; ++c) {
      if (grip.place[c]) own[c] = v[c];
      if (grip.turn[c]) own[spin_offset + c] = motion.spin_before[c];
    }
  }
}

void HeldSpheres::add_loads(int part, LoadRange loads) const {
  for (const int n : loaded_in_part_[part]) {
    const Held& held = spheres_[n];
    const double part_now = motions_[held.grip].load;
    double* load = loads.rows + (held.row - loads.first) * load_size;
    for (int c = 0; c < 3; ++c) {
      load[c] += part_now * grips_[held.grip].force[c];
      load[moment_offset + c] += part_now * grips_[held.grip].moment[c];
    }
  }
}

void HeldSpheres::add_loads(const Assembly::State& s, const std::set<std::int64_t>& but,
                            std::vector<double>& loads) const {
  if (!any()) return;
  std::vector<double> own(loads.size(), 0);
  for (int part = 0; part < s.contacts.parts().count(); ++part) add_loads(part, {own.data(), 0});
  for (const Held& held : spheres_) {
    if (but.contains(held.row)) continue;
    for (int c = 0; c < load_size; ++c) {
      double& more = own[held.row * load_size + c];
      loads[held.row * load_size + c] += more;
      more = 0;  // a sphere of several grips comes again
    }
  }
}

void HeldSpheres::before_step(const Assembly::State& s, std::size_t number) {
  const bool solved = is_solved(s);
  const FiberBlock& block = s.blocks[number];
  const GroupKind& kind = s.kinds[block.group()];
  BlockSnapshot snapshot;
  if (solved) block.snapshot(kind, s.rows, s.loads.of(s.part_of(block)), s.gradient.data(), snapshot, true);
  for (const int f : of_block_[number]) {
    HeldFiber& fiber = fibers_[f];
    fiber.before.clear();
    if (solved) {
      fiber.before = spheres_of(s, fiber, snapshot);
      fiber.kick = held_kick(kind, fiber.before, changes(fiber, fiber.before, false), KickMatrix::bonds,
                             bond_parts(kind, snapshot.history.data(), fiber.lane));
      continue;
    }
    fiber.before.resize(static_cast<std::size_t>(kind.spheres()));
    for (const int n : fiber.spheres) {
      const std::int64_t row = spheres_[n].row;
      MovingSphere<double, 3>& own = fiber.before[spheres_[n].at.sphere];
      own = {};
      own.pose.position = s.rows.position(row), own.velocity = s.rows.velocity(row),
      own.spin = s.rows.spin(row);
      if (!s.rows.oriented()) continue;
      const double* q = s.rows.orientation.data() + row * quaternion_size;
      own.pose.orientation = {q[0], {q[1], q[2], q[3]}};
    }
  }
}

void HeldSpheres::put(Assembly::State& s, std::int64_t row, const HeldFiber& fiber, int sphere,
                      const MovingSphere<double, 3>& before, const SixNumbers& change) const {
  double *place = s.rows.position_row(row), *motion = s.rows.velocity_row(row);
  Vec<double, 3> spin{};
  for (int c = 0; c < 3; ++c) {
    motion[c] = before.velocity[c] + change[c];
    place[c] = before.pose.position[c] + step_ * motion[c];
    motion[spin_offset + c] = spin[c] = before.spin[c] + change[3 + c];
  }
  for (const int n : fiber.spheres) {  // to the bit where the grip has it
    const Held& held = spheres_[n];
    const Motion& own = motions_[held.grip];
    if (held.at.sphere != sphere || !own.active) continue;
    const Vec<double, 3> next = own.center_next + rotate(own.turn_next, held.body);
    for (int c = 0; c < 3; ++c) {
      if (grips_[held.grip].place[c]) place[c] = next[c];
    }
  }
  if (!s.rows.oriented()) return;
  const Quaternion<double> q = cayley_turn((0.5 * step_) * spin, before.pose.orientation);
  double* turned = s.rows.orientation.data() + row * quaternion_size;
  turned[0] = q.w;
  for (int c = 0; c < 3; ++c) turned[1 + c] = q.v[c];
}

void HeldSpheres::account(Held& held, const SixNumbers& impulse, const MovingSphere<double, 3>& before,
                          const SixNumbers& change) const {
  const Grip& grip = grips_[held.grip];
  const Motion& motion = motions_[held.grip];
  held.place = before.pose.position;
  held.force = (step_ * motion.load) * grip.force, held.moment = (step_ * motion.load) * grip.moment;
  held.work = 0;
  for (int c = 0; c < 3; ++c) {
    if (motion.active && grip.place[c]) held.force[c] += impulse[c];
    if (motion.active && grip.turn[c]) held.moment[c] += impulse[3 + c];
    held.work += held.force[c] * (before.velocity[c] + 0.5 * change[c]) +
                 held.moment[c] * (before.spin[c] + 0.5 * change[3 + c]);
  }
}

double HeldSpheres::after_explicit(Assembly::State& s, HeldFiber& fiber) {
  const GroupKind& kind = s.kinds[fiber.group];
  std::vector<HeldChange> held = changes(fiber, fiber.before, false);
  double fastest = 0;
  for (std::size_t from = 0, to = 0; from < fiber.spheres.size(); from = to) {
    const int sphere = spheres_[fiber.spheres[from]].at.sphere;
    while (to < fiber.spheres.size() && spheres_[fiber.spheres[to]].at.sphere == sphere) ++to;
    const std::int64_t row = spheres_[fiber.spheres[from]].row;
    const MovingSphere<double, 3>& before = fiber.before[sphere];
    const Vec<double, 3> v = s.rows.velocity(row), w = s.rows.spin(row);
    SixNumbers change, impulse{};
    for (int c = 0; c < 3; ++c) change[c] = v[c] - before.velocity[c], change[3 + c] = w[c] - before.spin[c];
    const auto own = std::ranges::find(held, sphere, &HeldChange::sphere);
    if (own != held.end()) {
      const double m = kind.share(sphere) * kind.mass, J = kind.share(sphere) * kind.inertia;
      for (int c = 0; c < 6; ++c) {
        if (!own->is[c]) continue;
        impulse[c] = (c < 3 ? m : J) * (own->change[c] - change[c]);
        change[c] = own->change[c];
      }
      put(s, row, fiber, sphere, before, change);
      const Vec<double, 3> now = s.rows.velocity(row);
      fastest = std::max(fastest, dot(now, now));
    }
    for (std::size_t n = from; n < to; ++n) account(spheres_[fiber.spheres[n]], impulse, before, change);
  }
  return fastest;
}

double HeldSpheres::after_solved(Assembly::State& s, HeldFiber& fiber) {
  const std::int64_t first = s.first_row(fiber.group, fiber.fiber);
  double fastest = 0;
  for (int i = 0; i < static_cast<int>(fiber.before.size()); ++i) {
    put(s, first + i, fiber, i, fiber.before[i], fiber.kick.change[i]);
    const Vec<double, 3> now = s.rows.velocity(first + i);
    fastest = std::max(fastest, dot(now, now));
  }
  for (const int n : fiber.spheres) {
    Held& held = spheres_[n];
    const int i = held.at.sphere;
    account(held, fiber.kick.impulse[i], fiber.before[i], fiber.kick.change[i]);
  }
  return fastest;
}

double HeldSpheres::after_step(Assembly::State& s, std::size_t block) {
  double fastest = 0;
  for (const int f : of_block_[block])
    fastest = std::max(fastest, is_solved(s) ? after_solved(s, fibers_[f]) : after_explicit(s, fibers_[f]));
  return fastest;
}

}  // namespace fiberchain::dem
