#include "dem/contact/laws/dmt.hpp"

#include <numbers>

#include "dem/contact/effective_body.hpp"
#include "dem/model/contact_properties.hpp"

namespace fiberchain::dem {

Dmt::Parameters<double> Dmt::parameters(const EffectiveBody& e, const ContactProperties& properties,
                                        double step) {
  return {HertzMindlin::parameters(e, properties, step), pull_off(e, properties)};
}

double Dmt::pull_off(const EffectiveBody& e, const ContactProperties& properties) {
  return 2 * std::numbers::pi * properties.work_of_adhesion * e.radius;
}

ContactStiffness Dmt::stiffness(const EffectiveBody& e, const ContactProperties& properties, double overlap) {
  return HertzMindlin::stiffness(e, properties, overlap);
}

}  // namespace fiberchain::dem
