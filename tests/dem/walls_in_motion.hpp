#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "dem/assembly/assembly.hpp"

/// What the tests of walls that move share.
namespace walls_in_motion {

namespace dem = fiberchain::dem;

inline constexpr double g = 9.81, pi = std::numbers::pi;

inline void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

inline dem::Fiber fiber_with(int aspect_ratio, double youngs_modulus = 2.6e6) {
  dem::Fiber fiber{dem::isotropic_material(youngs_modulus, 0.17, 1130), 1.66e-3, aspect_ratio};
  fiber.bond_damping = 0.2;
  return fiber;
}

}  // namespace walls_in_motion
