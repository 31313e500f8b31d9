#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/held_spheres.hpp"
#include "dem/model/invalid_key.hpp"

// Grips: which spheres they have, where those lie, how grips move.
namespace fiberchain::dem {
namespace {

/// Spin that turns one orientation into another within a step, as spheres turn (cayley_turn) [1/s].
Vec<double, 3> spin_between(const Quaternion<double>& from, const Quaternion<double>& to, double step) {
  const Quaternion<double> turn = to * conjugate(from);
  return (2 / (step * turn.w)) * turn.v;
}

bool overlap(const Wall& one, const Wall& other) {
  return std::max(one.active_from, other.active_from) < std::min(one.active_until, other.active_until);
}

/// Whether both hold a component at the same time.
bool collide(const Grip& one, const Grip& other) {
  if (!overlap(one.body, other.body)) return false;
  for (int c = 0; c < 3; ++c) {
    if ((one.place[c] && other.place[c]) || (one.turn[c] && other.turn[c])) return true;
  }
  return false;
}

void check(const Grip& grip, const std::vector<FiberGroup>& groups) {
  const auto refuse = [&](const std::string& words) {
    throw InvalidKey("held", fmt::format("{}{}", grip.body.name.empty() ? "" : grip.body.name + ": ", words));
  };
  if (grip.spheres.empty()) refuse("no sphere to hold or load is not allowed");
  if (grip.body.motion.drive)
    refuse("a force that drives what holds spheres is not allowed: they are loaded");
  for (const SphereAddress& at : grip.spheres) {
    const bool there = at.group >= 0 && at.group < std::ssize(groups) && at.fiber >= 0 &&
                       at.fiber < std::ssize(groups[at.group].fibers) && at.sphere >= 0 &&
                       at.sphere < std::ssize(groups[at.group].chain.poses);
    if (!there)
      refuse(fmt::format("sphere {} of fiber {} of group {} is not allowed: it is not there", at.sphere,
                         at.fiber, at.group));
  }
}

}  // namespace

HeldSpheres::HeldSpheres(std::vector<Grip> grips, const std::vector<FiberGroup>& groups, double step)
    : grips_(std::move(grips)), step_(step), motions_(grips_.size()), records_(grips_.size()) {
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    check(grips_[g], groups);
    for (const SphereAddress& at : grips_[g].spheres)
      spheres_.push_back({.grip = static_cast<int>(g), .at = at});
  }
  std::vector<int> order(spheres_.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<int>(n);
  const auto place = [&](int n) {
    const SphereAddress& at = spheres_[n].at;
    return std::array{at.group, at.fiber, at.sphere};
  };
  std::ranges::stable_sort(order, {}, place);
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Held& held = spheres_[order[n]];
    for (std::size_t m = n; m-- > 0 && spheres_[order[m]].at == held.at;) {
      const int other = spheres_[order[m]].grip;
      if (other != held.grip && !collide(grips_[other], grips_[held.grip])) continue;
      throw InvalidKey("held", fmt::format("sphere {} of fiber {} is held twice at a time", held.at.sphere,
                                           held.at.fiber));
    }
    if (fibers_.empty() || fibers_.back().group != held.at.group || fibers_.back().fiber != held.at.fiber)
      fibers_.push_back({.group = held.at.group, .fiber = held.at.fiber, .spheres = {}});
    fibers_.back().spheres.push_back(order[n]);
  }
}

void HeldSpheres::locate(const Assembly::State& s) {
  if (!any()) return;
  of_block_.assign(s.blocks.size(), {});
  loaded_in_part_.assign(s.contacts.parts().count(), {});
  for (std::size_t f = 0; f < fibers_.size(); ++f) {
    HeldFiber& fiber = fibers_[f];
    const Assembly::State::Slot slot = s.slot(fiber.group, fiber.fiber);
    fiber.block = slot.block, fiber.lane = slot.lane;
    of_block_[slot.block].push_back(static_cast<int>(f));
    for (const int n : fiber.spheres) {
      Held& held = spheres_[n];
      held.row = s.first_row(fiber.group, fiber.fiber) + held.at.sphere;
      if (grips_[held.grip].loads())
        loaded_in_part_[s.contacts.parts().of(static_cast<std::int32_t>(held.row))].push_back(n);
    }
  }
}

HeldSpheres::Motion HeldSpheres::motion_at(const Grip& grip, double time) const {
  Motion motion;
  motion.active = is_active(grip.body, time);
  motion.load = grip.load_at(time);
  if (!motion.active || !grip.holds()) return motion;
  const WallPose before = pose_at(grip.body, time - step_), now = pose_at(grip.body, time),
                 next = pose_at(grip.body, time + step_);
  motion.center_next = next.center_now(), motion.center_before = before.center_now();
  motion.turn_next = next.turn, motion.turn_before = before.turn;
  if (!next.turned) return motion;
  motion.spin = spin_between(now.turn, next.turn, step_);
  motion.spin_before = spin_between(before.turn, now.turn, step_);
  return motion;
}

void HeldSpheres::grasp(const Assembly::State& s) {
  std::vector<bool> comes(grips_.size());
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    const bool was = motions_[g].active;
    motions_[g] = motion_at(grips_[g], s.time());
    comes[g] = motions_[g].active && !was;
  }
  for (Held& held : spheres_) {
    if (!comes[held.grip]) continue;
    const WallPose pose = pose_at(grips_[held.grip].body, s.time());
    held.body = rotate(conjugate(pose.turn), s.rows.position(held.row) - pose.center_now());
  }
}

}  // namespace fiberchain::dem
