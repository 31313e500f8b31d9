#include "dem/contact/laws/jkr.hpp"

#include <cmath>
#include <numbers>

#include "dem/contact/effective_body.hpp"
#include "dem/model/contact_properties.hpp"

namespace fiberchain::dem {
namespace {

/// a_0^2/R*, a_0^3 = pi w R*^2 / (8 E*).
double depth_of(const EffectiveBody& e, const ContactProperties& properties) {
  const double cube =
      std::numbers::pi * properties.work_of_adhesion * e.radius * e.radius / (8 * e.youngs_modulus);
  return std::pow(cube, 2.0 / 3) / e.radius;
}

}  // namespace

Jkr::Parameters<double> Jkr::parameters(const EffectiveBody& e, const ContactProperties& properties,
                                        double step) {
  return {HertzMindlin::parameters(e, properties, step), depth_of(e, properties),
          std::numbers::pi * properties.work_of_adhesion * e.radius / 8};
}

ContactStiffness Jkr::stiffness(const EffectiveBody& e, const ContactProperties& properties, double overlap) {
  // Hertz's of the same contact radius, which is the larger one
  const double depth = depth_of(e, properties), u = root_of_radius(overlap / depth);
  return HertzMindlin::stiffness(e, properties, depth * std::pow(u, 4));
}

double Jkr::pull_off(const EffectiveBody& e, const ContactProperties& properties) {
  return 1.5 * std::numbers::pi * properties.work_of_adhesion * e.radius;
}

double Jkr::reach(const EffectiveBody& e, const ContactProperties& properties) {
  return 3 * depth_of(e, properties);
}

}  // namespace fiberchain::dem
