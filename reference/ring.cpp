#include "reference/ring.hpp"

#include <cmath>
#include <limits>

#include "reference/errors.hpp"

namespace fiberchain::reference {

TipState end_moment_tip(double moment) {
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("moment", moment, -largest, largest);
  if (moment == 0) return {0, 0, 0};
  const double half = moment / 2;
  const double y = std::sin(half) * (std::sin(half) / half);
  // 1 - sin(m)/m cancels for small m: its series m^2/6 - m^4/120 + m^6/5040 - ... is used there.
  const double m2 = moment * moment;
  const double series = m2 / 6 * (1 - m2 / 20 * (1 - m2 / 42 * (1 - m2 / 72)));
  const double x = std::abs(moment) < 0.1 ? series : 1 - std::sin(moment) / moment;
  return {y, x, moment};
}

}  // namespace fiberchain::reference
