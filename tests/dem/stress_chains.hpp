#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/dem/free_motion.hpp"

/// Chains for the stress tests.
namespace marching {

inline dem::Fiber fiber_of(int aspect_ratio, double nu, double damping,
                           dem::BondModel bond = dem::BondModel::paper) {
  return {dem::isotropic_material(3.7e5, nu, 431), 0.0262, aspect_ratio, bond, damping};
}

template <int Dim>
dem::ChainBatch<Dim> lone_block(const dem::Chain<Dim>& chain, double dt, dem::BondForm form,
                                bool solved = false) {
  return dem::ChainBatch<Dim>({chain}, {false, false}, {dt}, {0.0},
                              {.dimension = Dim,
                               .form = form,
                               .damped = dem::damped(chain.fiber),
                               .settling_damping = false,
                               .curved = false,
                               .solved = solved ? dem::Solved::dashpots : dem::Solved::nothing},
                              dem::best_instruction_set());
}

/// Largest component of velocity and l times spin; infinite if one is no number. By components: the square of
/// a denormal number is zero.
template <int Dim>
double largest_speed(const dem::ChainBatch<Dim>& block, const dem::Fiber& fiber) {
  double largest = 0;
  const auto count = [&](double speed) {
    largest =
        std::max(largest, std::isfinite(speed) ? std::abs(speed) : std::numeric_limits<double>::infinity());
  };
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const auto sphere = block.sphere(0, i);
    for (const double v : sphere.velocity.c) count(v);
    for (const double w : sphere.spin.c) count(dem::bond_length(fiber) * w);
  }
  return largest;
}

}  // namespace marching
