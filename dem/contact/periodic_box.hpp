#pragma once

#include <cmath>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Periods along the axes [m] and one over them [1/m]; both 0 along axes that are not periodic.
struct PeriodicBox {
  double length[3], inverse[3];
};

PeriodicBox periodic_box(const Vec<double, 3>& length);

/// Throws InvalidInput where a period is shorter than twice the `reach` [m] of a body: it would meet more
/// than one image of another.
void check_minimum_image(const Vec<double, 3>& length, double reach);

/// A separation to the nearest image of the other end.
template <class Real>
Vec<Real, 3> nearest_image(const PeriodicBox& periods, Vec<Real, 3> r) {
  using std::nearbyint;  // of packs: their own
  for (int c = 0; c < 3; ++c)
    r[c] = r[c] - Real(periods.length[c]) * nearbyint(r[c] * Real(periods.inverse[c]));
  return r;
}

}  // namespace fiberchain::dem
