#include "dem/model/domain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiberchain::dem {

bool is_active(const Wall& wall, double time) { return time >= wall.active_from && time < wall.active_until; }

namespace {

/// By which it has turned about its axis [rad].
double angle_at(const Wall& wall, double time) {
  const double steady = wall.motion.angular_velocity * time;
  return wall.motion.course ? steady + wall.motion.course->angle.at(time) : steady;
}

}  // namespace

bool is_at_rest(const Wall& wall) { return norm(wall.velocity) == 0 && !wall.motion.moves(); }

bool turns_visibly(const Wall& wall) {
  const std::optional<WallAxis>& about = wall.motion.about;
  return about && !wall.shape.is_round_about(about->point, about->axis);
}

bool is_invariant_along(const Wall& wall, int axis) {
  if (!wall.shape.is_invariant_along(axis)) return false;
  return !turns_visibly(wall) || std::abs(wall.motion.about->axis[axis]) > 1 - 1e-12;
}

WallPose pose_at(const Wall& wall, double time) {
  const WallMotion& motion = wall.motion;
  WallPose pose;
  pose.center = motion.about ? motion.about->point : wall.shape.point();
  pose.shift = time * wall.velocity;
  if (!motion.moves()) return pose;
  if (motion.oscillation) pose.shift = pose.shift + motion.oscillation->at(time) * motion.oscillation->axis;
  if (motion.course) pose.shift = pose.shift + motion.course->place.at(time) * motion.course->axis;
  if (motion.drive) pose.shift = pose.shift + motion.drive->shift * motion.drive->axis;
  if (motion.about) {
    constexpr double around = 2 * std::numbers::pi;
    pose.turned = true;
    pose.turn = rotation(std::remainder(angle_at(wall, time), around) * motion.about->axis);
  }
  return pose;
}

WallVelocity velocity_at(const Wall& wall, double time) {
  const WallMotion& motion = wall.motion;
  WallVelocity all{wall.velocity, {}};
  if (!motion.moves()) return all;
  Vec<double, 3>& v = all.velocity;
  if (motion.oscillation) v = v + motion.oscillation->rate_at(time) * motion.oscillation->axis;
  if (motion.course) v = v + motion.course->place.rate_at(time) * motion.course->axis;
  if (motion.drive) v = v + motion.drive->speed * motion.drive->axis;
  if (motion.about) {
    const double rate = motion.angular_velocity + (motion.course ? motion.course->angle.rate_at(time) : 0);
    all.spin = rate * motion.about->axis;
  }
  return all;
}

double largest_speed(const Wall& wall, double reach) {
  const WallMotion& motion = wall.motion;
  double speed = norm(wall.velocity), rate = std::abs(motion.angular_velocity);
  if (motion.oscillation) speed += motion.oscillation->largest_rate();
  if (motion.course) {
    speed += motion.course->place.largest_rate();
    rate += motion.course->angle.largest_rate();
  }
  if (motion.drive) speed += std::abs(motion.drive->speed);
  return speed + rate * reach;
}

double distance_from_axis(const Wall& wall, const Vec<double, 3>& place) {
  const std::optional<WallAxis>& about = wall.motion.about;
  return about ? norm(cross(place - about->point, about->axis)) : 0;
}

double gap_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.moved(pose_at(wall, time)).nearest(place).distance;
}

Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.moved(pose_at(wall, time)).nearest(place).direction;
}

bool are_same(const Wall& one, const Wall& other) {
  if (one.shape.type().name != other.shape.type().name) return false;
  if (!(std::max(one.active_from, other.active_from) < std::min(one.active_until, other.active_until)))
    return false;
  // no two shapes of a kind have the same gaps from seven places that lie in no plane and on no circle
  constexpr double spread = 0.37;  // [m]
  for (int n = 0; n < 7; ++n) {
    const Vec<double, 3> place{spread * std::cos(1.3 * n), spread * std::sin(1.9 * n + 0.4),
                               spread * std::cos(2.7 * n + 1.1)};
    for (const double time : {0.0, 1.0}) {
      const double a = gap_to(one, place, time), b = gap_to(other, place, time);
      if (std::abs(a - b) > 1e-9 * (std::abs(a) + std::abs(b))) return false;
    }
  }
  return true;
}

}  // namespace fiberchain::dem
