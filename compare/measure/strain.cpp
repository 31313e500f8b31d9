#include "compare/measure/strain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fiberchain::compare {

double strain_bound(const dem::Fiber& fiber, double load, double weight) {
  return (std::abs(dem::load_force(fiber, load)) + weight) /
         std::min(dem::axial_stiffness(fiber), dem::shear_stiffness(fiber));
}

std::string strain_warning(double strain) {
  if (strain <= largest_linear_strain) return "";
  return fmt::format(
      "stretch or shear up to {:.2g}: beyond {:g} their linear laws are a rod's no more, and tip and "
      "departure mean nothing",
      strain, largest_linear_strain);
}

}  // namespace fiberchain::compare
