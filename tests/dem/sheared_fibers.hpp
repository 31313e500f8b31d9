#pragma once

#include <cmath>
#include <numbers>

#include "dem/flow/inertialess.hpp"

// Straight fibers in shear.
namespace sheared_fibers {

namespace dem = fiberchain::dem;

inline constexpr double pi = std::numbers::pi;
inline constexpr double kRadius = 0.0131, kViscosity = 0.83, kRate = 1.7;

/// A fiber of n spheres for which 3 pi mu rate L^4 / (E I) is `number`, L = 2 R n.
inline dem::Fiber fiber_of(int n, double number, double bond_damping = 0) {
  const double L = 2 * kRadius * n, I = pi * std::pow(kRadius, 4) / 4;
  const double E = 3 * pi * kViscosity * kRate * std::pow(L, 4) / (I * number);
  return {dem::isotropic_material(E, 0.17, 431.0), 2 * kRadius, n - 1, dem::BondModel::paper, bond_damping};
}

inline dem::Fluid shear(dem::Hydrodynamics hydrodynamics = dem::Hydrodynamics::free_draining) {
  return {kViscosity, {dem::simple_shear(kRate)}, hydrodynamics};
}

/// Centered at the origin along the unit vector (cos a, 0, sin a), in the plane along x.
template <int Dim>
dem::FlowCase<Dim> straight_case(const dem::Fiber& fiber, const dem::Fluid& fluid, double a = 0) {
  dem::FlowCase<Dim> flow{dem::straight_chain<Dim>(fiber), {}, fluid, {}};
  flow.start = flow.chain.poses;
  const dem::Vec<double, Dim> middle = 0.5 * flow.start.back().position;
  for (auto& pose : flow.start) {
    pose.position = pose.position - middle;
    if constexpr (Dim == 3) {
      const auto turn = dem::rotation(dem::Vec<double, 3>{0, -a, 0});
      pose.position = dem::rotate(turn, pose.position);
      pose.orientation = turn * pose.orientation;
    }
  }
  return flow;
}

/// Of the spheroid that turns as a chain of n spheres, Jeffery (1922).
inline double chain_aspect(int n) { return std::sqrt((n * n + 1) / 2.0); }
inline double jeffery_period(double aspect) { return 2 * pi * (aspect + 1 / aspect) / kRate; }

}  // namespace sheared_fibers
