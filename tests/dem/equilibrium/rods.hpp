#pragma once

#include <numbers>
#include <random>

#include "dem/chain/rod_shapes.hpp"
#include "dem/equilibrium/rod_path.hpp"

// Rods of odd numbers for the tests of this folder.
namespace fiberchain::dem::test {

inline Fiber rod_fiber(int bonds, BondModel bond = BondModel::corrected) {
  Fiber fiber{.material = isotropic_material(3.1e6, 0.17, 1370), .diameter = 0.0013, .aspect_ratio = bonds};
  fiber.bond_model = bond;
  fiber.mass = MassModel::cylinder;
  return fiber;
}

/// A hinge about z, held in the directions given.
inline RodSupport hinge_about_z(int sphere, std::array<bool, 3> hold = {true, true, true}) {
  return {.sphere = sphere, .hold_displacement = hold, .hold_rotation = {true, true, false}};
}

inline Vec<double, 3> random_vector(std::mt19937& numbers, double size) {
  std::uniform_real_distribution<double> part(-size, size);
  const double x = part(numbers), y = part(numbers), z = part(numbers);
  return {x, y, z};
}

inline double tip_distance(const Poses<3>& a, const Poses<3>& b) {
  return norm(a.back().position - b.back().position);
}

}  // namespace fiberchain::dem::test
