#include "dem/contact/restitution_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/smooth_contacts.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {

double restitution_error(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                         double speed, double step) {
  constexpr int phases = 8;
  const EffectiveBody both = crossed_body(a, b);
  const ContactLaw& law = law_of(properties);
  double worst = 0;
  for (int i = 0; i < phases; ++i) {
    const double found = law.restitution(both, properties, speed, step, (i + 0.5) / phases);
    const double off = std::abs(found - properties.restitution);
    if (!(off <= worst)) worst = off;  // keeps not-a-number
    if (std::isnan(worst)) break;
  }
  return worst;
}

double step_for_restitution(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                            double speed, double allowed, double high) {
  if (!(allowed > 0))
    throw InvalidInput(fmt::format("restitution error = {} is not allowed: above 0", allowed));
  constexpr double shorter = 0.97, smallest = 0.1;
  // the error wanders by the moments of touch: the step below has to do as well
  const auto holds = [&](double step) { return restitution_error(a, b, properties, speed, step) <= allowed; };
  double step = high;
  for (bool here = holds(step); step > smallest * high; step *= shorter) {
    const bool below = holds(shorter * step);
    if (here && below) return step;
    here = below;
  }
  return smallest * high;
}

}  // namespace fiberchain::dem
