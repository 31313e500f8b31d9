#pragma once

#include <vector>

#include "dem/model/fiber.hpp"
#include "dem/model/loads.hpp"

namespace fiberchain::dem {

/// Weight of every sphere under an acceleration of gravity [m/s^2] as dead loads. Of MassModel::cylinder it
/// is the fiber's own, second order in the bond's length; of MassModel::spheres the end spheres' outer halves
/// weigh beyond the fiber's length, which is first order: a cantilever under its own weight drops by
/// 4 / (3 r_f) of itself too much where it drops little, besides being lighter by a third.
template <int Dim>
std::vector<Load<Dim>> self_weight(const Fiber& fiber, const Vec<double, Dim>& gravity) {
  std::vector<Load<Dim>> loads;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const double mass = mass_share(fiber, i) * sphere_mass(fiber);
    loads.push_back({.sphere = i, .force = mass * gravity, .moment = {}});
  }
  return loads;
}

}  // namespace fiberchain::dem
