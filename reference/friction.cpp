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
