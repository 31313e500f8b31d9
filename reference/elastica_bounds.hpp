#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiberchain::reference::detail {

/// Lower bound, within 6 %, of w = ln tan(phi/2) at the free end of the Elastica: the larger of -load/2
/// (from w'' <= load) and the one from phi <= phi_tip cosh(sqrt(load)) (sin(phi) <= phi).
inline double elastica_tip_bound(double load) {
  const double root = std::sqrt(load);
  const double vertical = root > 30 ? std::log(std::numbers::pi / 2) - root
                                    : std::log(std::tan(std::numbers::pi / (4 * std::cosh(root))));
  return std::max(-load / 2, vertical);
}

}  // namespace fiberchain::reference::detail
