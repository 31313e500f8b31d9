#include "dem/contact/periodic_box.hpp"

#include <fmt/format.h>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

PeriodicBox periodic_box(const Vec<double, 3>& length) {
  PeriodicBox periods{};
  for (int c = 0; c < 3; ++c) {
    if (length[c] > 0) periods.length[c] = length[c], periods.inverse[c] = 1 / length[c];
  }
  return periods;
}

void check_minimum_image(const Vec<double, 3>& length, double reach) {
  for (const double period : length.c) {
    if (period > 0 && period < 2 * reach) {
      throw InvalidInput(
          fmt::format("period = {:g} m is not allowed: it must be at least {:g} m, twice what spheres see of "
                      "each other",
                      period, 2 * reach));
    }
  }
}

}  // namespace fiberchain::dem
