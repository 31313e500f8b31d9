#include "reference/friction.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

// 1/m + R^2/J of a solid sphere, times m: what an impulse does to the slip
constexpr double slip_per_impulse = 3.5;

}  // namespace

double sliding_slip_restitution(double slip, double approach, double friction, double restitution) {
  require_positive("slip", std::abs(slip));
  require_positive("speed of approach", approach);
  require_between("friction", friction, 0, largest);
  require_between("restitution", restitution, 0, 1);
  return 1 - slip_per_impulse * friction * (1 + restitution) * approach / std::abs(slip);
}

FrictionImpact friction_impact(const ObliqueMotion& before, double approach, double friction,
                               double restitution) {
  require_positive("speed of approach", approach);
  require_between("friction", friction, 0, largest);
  require_between("restitution", restitution, 0, 1);
  const double slip = before.tangential + before.surface_spin;
  const double sliding = friction * (1 + restitution) * approach,
               sticking = std::abs(slip) / slip_per_impulse;
  const bool slides = sliding < sticking;
  const double impulse = std::copysign(slides ? sliding : sticking, slip);  // over the mass
  return {{before.tangential - impulse, before.surface_spin - (slip_per_impulse - 1) * impulse}, slides};
}

std::array<PlanarMotion, 2> sliding_impact(const ElasticBody& first, const ElasticBody& second,
                                           double friction, double restitution,
                                           const PlanarMotion& first_motion,
                                           const PlanarMotion& second_motion) {
  const double approach = first_motion.velocity[0] - second_motion.velocity[0];
  const double turning = std::isinf(second.radius) ? 0 : second.radius * second_motion.spin;
  const double slip =
      second_motion.velocity[1] - turning - first_motion.velocity[1] - first.radius * first_motion.spin;
  require_positive("speed of approach", approach);
  require_positive("slip", std::abs(slip));
  require_between("friction", friction, 0, largest);
  require_between("restitution", restitution, 0, 1);
  const double across = (1 + restitution) * approach / (1 / first.mass + 1 / second.mass);
  const double along = std::copysign(friction * across, slip);  // on the first
  const auto pushed = [&](PlanarMotion motion, const ElasticBody& body, double sign) {
    motion.velocity[0] -= sign * across / body.mass;
    motion.velocity[1] += sign * along / body.mass;
    if (!std::isinf(body.radius)) motion.spin += (slip_per_impulse - 1) * along / (body.mass * body.radius);
    return motion;
  };
  return {pushed(first_motion, first, 1), pushed(second_motion, second, -1)};
}

SphereOnSlope sphere_on_slope(double angle, double friction, double gravity) {
  require_between("angle", angle, 0, std::numbers::pi / 2);
  require_between("friction", friction, 0, largest);
  require_positive("gravity", gravity);
  const double along = gravity * std::sin(angle), across = gravity * std::cos(angle);
  if (along > slip_per_impulse * friction * across) {
    return {true, along - friction * across, (slip_per_impulse - 1) * friction * across};
  }
  return {false, along * (1 - 1 / slip_per_impulse), along * (1 - 1 / slip_per_impulse)};
}

double rolling_deceleration(double rolling_friction, double gravity) {
  require_between("rolling friction", rolling_friction, 0, largest);
  require_positive("gravity", gravity);
  return rolling_friction * gravity * (1 - 1 / slip_per_impulse);
}

}  // namespace fiberchain::reference
