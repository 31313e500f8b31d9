#pragma once

#include "dem/math/small_matrix.hpp"
#include "dem/motion/moving_sphere.hpp"
#include "dem/motion/physics.hpp"

namespace fiberchain::dem {

/// The undisturbed flow at one step. Nothing in scenes without fluid.
template <Physics P, class Real, bool = P.fluid>
struct LocalFlow {};

template <Physics P, class Real>
struct LocalFlow<P, Real, true> {
  Square<Real, P.dimension> gradient;  ///< A [1/s]
  Spin<Real, P.dimension> spin;        ///< 1/2 curl u [1/s]
};

/// From the values of A, row by row.
template <Physics P, class Real>
LocalFlow<P, Real> local_flow(const Real* gradient) {
  LocalFlow<P, Real> flow;
  if constexpr (P.fluid) {
    constexpr int Dim = P.dimension;
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) flow.gradient[i][j] = gradient[i * Dim + j];
    }
    const auto& A = flow.gradient;
    const Real half = Real(0.5);
    if constexpr (Dim == 2) {
      flow.spin = {half * (A[1][0] - A[0][1])};
    } else {
      flow.spin = {half * (A[2][1] - A[1][2]), half * (A[0][2] - A[2][0]), half * (A[1][0] - A[0][1])};
    }
  }
  return flow;
}

}  // namespace fiberchain::dem
