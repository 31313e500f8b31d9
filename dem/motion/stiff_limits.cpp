#include "dem/motion/stiff_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fiberchain::dem {
namespace {

/// Tension that the wave with phase k between neighbors bears. Displacement w (in units of l) and rotation p
/// of the spheres: shear |2 sin(k/2) w - cos(k/2) p|^2, bending |2 sin(k/2) p|^2; a tension adds
/// N l |2 sin(k/2) w|^2.
double tension_of_wave(const Fiber& fiber, double dt, double surplus, double k) {
  const BondStiffness K = bond_stiffness(fiber);
  const double l = bond_length(fiber), s = 2 * std::sin(k / 2), c = std::cos(k / 2);
  const double b = dt * dt * surplus, shear = b * K.shear * l * l;
  const double ww = sphere_mass(fiber) * l * l + shear * s * s, wp = -shear * s * c,
               pp = sphere_inertia(fiber) + shear * c * c + b * K.bend * s * s;
  return 4 * (ww - wp * wp / pp) / (dt * dt * l * s * s);
}

}  // namespace

double largest_tension(const Fiber& fiber, double dt, double beta) {
  check(fiber);
  constexpr int waves = 256;  // the worst is long where the step is: phases in equal ratios
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= waves; ++i) {
    const double k = std::numbers::pi * std::pow(1e-3, static_cast<double>(i) / waves);
    least = std::min(least, tension_of_wave(fiber, dt, beta - 0.25, k));
  }
  return least;
}

double free_bending_period(const Fiber& fiber) {
  check(fiber);
  constexpr double root = 4.730040744862704;  // of cos x cosh x = 1
  const double bonds = fiber.aspect_ratio;
  return 2 * std::numbers::pi * (bonds / root) * (bonds / root) * bond_length(fiber) *
         std::sqrt(sphere_mass(fiber) / bond_stiffness(fiber).bend);
}

double step_for_tension(const Fiber& fiber, double tension, double beta) {
  if (!(tension > 0)) return std::numeric_limits<double>::infinity();
  double low = 0, high = bond_time_step(fiber);
  while (largest_tension(fiber, high, beta) > tension && high < 1e12 * bond_time_step(fiber)) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (largest_tension(fiber, middle, beta) > tension ? low : high) = middle;
  }
  return low;
}

}  // namespace fiberchain::dem
