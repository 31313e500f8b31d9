#pragma once

#include "compare/measure/peaks.hpp"
#include "dem/model/fiber.hpp"

// The incremental form's summed stretch against the bond's length, along a ring-down.
namespace fiberchain::compare {

struct StretchComparison {
  double stretch;  ///< largest difference of the summed stretch from l - l_0, over the largest stretch of any
                   ///< bond
  double tip;  ///< largest distance over L between the free ends of the march by increments and of that whose
               ///< stretch is taken from the length at every step
  double damping;  ///< relative difference of xi_f between the two
};

/// A cantilever let go from its equilibrium under P L^2/(E I) = `load`, marched with dt = `step_ratio` t_b.
StretchComparison compare_stretch(const dem::Fiber& fiber, double load, double step_ratio, PeakRange peaks);

}  // namespace fiberchain::compare
