#pragma once

#include <string>

#include "dem/model/fiber.hpp"

namespace fiberchain::compare {

/// Strain up to which stretch and shear of a rod are linear in their forces, as the bond law takes them:
/// beyond, the answer is that of a formula and of no material.
inline constexpr double largest_linear_strain = 0.1;

/// Largest strain that stretch or shear can have under an end load P L^2/(E I): P over the smaller of E A and
/// G A, both of the bond's.
/// @param weight of the fiber, beside the load [N]
double strain_bound(const dem::Fiber& fiber, double load, double weight = 0);

/// Empty up to largest_linear_strain, else what to think of an answer.
std::string strain_warning(double strain);

}  // namespace fiberchain::compare
