#include "dem/contact/laws/hertz_mindlin.hpp"

#include <cmath>

#include "dem/contact/contact_body.hpp"
#include "dem/contact/restitution.hpp"

namespace fiberchain::dem {

HertzMindlin::Parameters<double> HertzMindlin::parameters(const EffectiveBody& e,
                                                          const ContactProperties& properties, double step) {
  const double zeta = damping_ratio_for(properties.restitution);
  Parameters<double> p{};
  p.normal = 4.0 / 3 * e.youngs_modulus * std::sqrt(e.radius);
  p.tangential = 8 * e.shear_modulus * std::sqrt(e.radius);
  p.normal_damping = 2 * zeta * std::sqrt(5.0 / 4 * e.mass * p.normal);
  p.tangential_damping = 2 * zeta * std::sqrt(5.0 / 6 * e.mass * p.tangential);
  p.friction = properties.friction;
  p.rolling = properties.rolling_friction * e.radius;
  p.rolling_limit = e.inertia / step;
  p.extrapolation = 0.5;
  return p;
}

ContactStiffness HertzMindlin::stiffness(const EffectiveBody& e, const ContactProperties& properties,
                                         double overlap) {
  const double contact_radius = std::sqrt(e.radius * overlap),
               zeta = damping_ratio_for(properties.restitution);
  const double normal = 2 * e.youngs_modulus * contact_radius,
               tangential = properties.friction > 0 ? 8 * e.shear_modulus * contact_radius : 0;
  const auto dashpot = [&](double stiffness) { return 2 * zeta * std::sqrt(5.0 / 6 * e.mass * stiffness); };
  return {normal, tangential, dashpot(normal), dashpot(tangential)};
}

}  // namespace fiberchain::dem
