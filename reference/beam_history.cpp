#include "reference/beam_history.hpp"

#include <cmath>

#include "reference/errors.hpp"

namespace fiberchain::reference {

void require_times(const std::vector<double>& times) {
  double previous = -1;
  for (const double time : times) {
    if (!(time >= 0 && std::isfinite(time))) throw InvalidArgument("times", time, "finite, 0 or more");
    if (!(time > previous)) throw InvalidArgument("times", time, "each later than the one before");
    previous = time;
  }
}

}  // namespace fiberchain::reference
