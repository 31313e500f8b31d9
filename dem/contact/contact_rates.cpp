#include "dem/contact/contact_rates.hpp"

#include <algorithm>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/smooth_contacts.hpp"

namespace fiberchain::dem {

ContactRates contact_rates(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                           double overlap, int neighbors) {
  EffectiveBody e = effective_body(a, b);
  const double stiffer = stiffness_ratio(a, b, true);  // smooth fibers side by side are the stiffest
  e.radius *= stiffer * stiffer;
  const ContactStiffness law = law_of(properties).stiffness(e, properties, overlap);
  const auto about_sphere = [&](double across, double tangential) {
    return std::max(
               {neighbors * (across + 2 * tangential) / 3, neighbors * 5.0 / 3 * tangential, 2 * across}) /
           e.mass;
  };
  return {about_sphere(law.normal, law.tangential),
          about_sphere(law.normal_dashpot, 0.5 * law.tangential_dashpot)};
}

}  // namespace fiberchain::dem
