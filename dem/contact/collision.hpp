#pragma once

#include <limits>

#include "dem/contact/effective_body.hpp"
#include "dem/contact/laws/contact_action.hpp"
#include "dem/model/contact_properties.hpp"

namespace fiberchain::dem {

/// Speed after a head-on collision of two free bodies over the speed before, as the leapfrog of a packing
/// finds it at a step `dt` [s]: the bodies close in at `speed` [m/s] and stand `phase` of a step's path apart
/// at first. Not a number where they do not part. Of laws that adhere: the restitution set, off by the square
/// of what one kick of the largest pull is of their momentum; others that act across a gap are not looked at.
template <class Law>
double collision_restitution(const EffectiveBody& body, const ContactProperties& properties, double speed,
                             double dt, double phase) {
  if constexpr (Adheres<Law>) {
    const double kick = Law::pull_off(body, properties) * dt / (body.mass * speed);
    return properties.restitution - kick * kick;
  }
  if constexpr (Law::acts_beyond_touch) return properties.restitution;
  constexpr int most_steps = 100000;
  const auto parameters = Law::parameters(body, properties, dt);
  typename Law::template History<double> history{};
  TouchingPair<double> pair{{0, 0, 1}, 0, {0, 0, -speed}, {}, {}};
  double gap = phase * speed * dt;
  bool met = false;
  for (int n = 0; n < most_steps; ++n) {
    double& velocity = pair.velocity[2];
    gap += dt * velocity;
    if (gap < 0) {
      met = true;
      pair.overlap = -gap;
      velocity -= dt / body.mass * Law::template act<false>(parameters, pair, dt, history).force[2];
    } else if (met) {
      return velocity / speed;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fiberchain::dem
