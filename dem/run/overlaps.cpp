#include "dem/run/overlaps.hpp"

#include <fmt/format.h>

namespace fiberchain::dem {

bool presses_at_rest(const RunMoment& moment) { return moment.energy.kinetic < moment.energy.contacts; }

std::string impact_warning(const RunMoment& moment) {
  if (!(moment.overlap_peak > impact_overlap_limit)) return "";
  return fmt::format(
      "warning: a contact has overlapped by {:.2g} of the smaller radius; beyond {:g} contacts are too soft "
      "for what hits them: take a larger contacts.youngs_modulus, or slower fibers",
      moment.overlap_peak, impact_overlap_limit);
}

std::string rest_warning(const RunMoment& moment) {
  if (!presses_at_rest(moment) || !(moment.overlap_mean > rest_overlap_limit)) return "";
  return fmt::format(
      "warning: contacts at rest overlap by {:.2g} of the smaller radius on average; beyond {:g} they are "
      "too soft for what lies on them: take a larger contacts.youngs_modulus",
      moment.overlap_mean, rest_overlap_limit);
}

std::string expected_impact_in_words(double speed, double overlap) {
  return fmt::format("single spheres that meet at {:.3g} m/s overlap by {:.2g} of the smaller radius{}",
                     speed, overlap,
                     overlap > impact_overlap_limit
                         ? fmt::format("; warning: beyond {:g} contacts are too soft for it: take a larger "
                                       "contacts.youngs_modulus, or slower fibers",
                                       impact_overlap_limit)
                         : "");
}

}  // namespace fiberchain::dem
