#pragma once

#include "dem/bond/dashpot.hpp"
#include "dem/math/small_matrix.hpp"
#include "dem/math/unroll.hpp"

// The dashpots of a bond as a matrix on the velocities and spins of its two spheres.
namespace fiberchain::dem {

/// Velocities, then spins, of one sphere.
template <int Dim>
inline constexpr int motions = Dim + spin_size<Dim>;

/// Minus the dashpots' force and moment on the spheres is C (v_1, w_1, v_2, w_2); symmetric, semi-definite:
/// first = C_11, second = C_22, coupling = C_12.
template <class Real, int Dim>
struct DashpotMatrix {
  Square<Real, motions<Dim>> first, second, coupling;
};

template <class Real, int Dim>
void scale(DashpotMatrix<Real, Dim>& matrix, const Real& factor) {
  for (Square<Real, motions<Dim>>* part : {&matrix.first, &matrix.second, &matrix.coupling}) {
    FIBERCHAIN_UNROLL
    for (int i = 0; i < motions<Dim>; ++i) {
      FIBERCHAIN_UNROLL
      for (int j = 0; j < motions<Dim>; ++j) (*part)[i][j] = factor * (*part)[i][j];
    }
  }
}

/// X with X w = w x r, as Dim rows of spin_size columns.
template <class Real>
void spin_arm(const Vec<Real, 2>& r, Real (&X)[2][1]) {
  X[0][0] = -r[1];
  X[1][0] = r[0];
}

template <class Real>
void spin_arm(const Vec<Real, 3>& r, Real (&X)[3][3]) {
  FIBERCHAIN_UNROLL
  for (int i = 0; i < 3; ++i) X[i][i] = Real(0.0);
  X[0][1] = r[2], X[0][2] = -r[1], X[1][0] = -r[2];
  X[1][2] = r[0], X[2][0] = r[1], X[2][1] = -r[0];
}

/// With the sliding V - mean_spin x r: C = G^T D G, D = c_t I + (c_n - c_t) e e^T and the same of the
/// rotations.
template <class Real, int Dim>
DashpotMatrix<Real, Dim> dashpot_matrix(const BondParameters<Real>& bond, const Vec<Real, Dim>& r,
                                        const Vec<Real, Dim>& e) {
  constexpr int S = spin_size<Dim>, N = motions<Dim>;
  Real X[Dim][S];
  spin_arm(r, X);
  Square<Real, N> own = zero_matrix<Real, N>(), coupling = own;
  const Real along = bond.dash_stretch - bond.dash_shear, about = bond.dash_twist - bond.dash_bend;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < Dim; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < Dim; ++j) {
      const Real force = along * e[i] * e[j] + (i == j ? bond.dash_shear : Real(0.0));
      own[i][j] = force;
      coupling[i][j] = -force;
    }
    FIBERCHAIN_UNROLL
    for (int j = 0; j < S; ++j) {
      const Real half = Real(0.5) * bond.dash_shear * X[i][j];
      own[i][Dim + j] = own[Dim + j][i] = half;
      coupling[i][Dim + j] = half;
      coupling[Dim + j][i] = -half;
    }
  }
  FIBERCHAIN_UNROLL
  for (int i = 0; i < S; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < S; ++j) {
      Real arms = Real(0.0);
      FIBERCHAIN_UNROLL
      for (int k = 0; k < Dim; ++k) arms = arms + X[k][i] * X[k][j];
      const Real shear = Real(0.25) * bond.dash_shear * arms;
      Real bend = i == j ? bond.dash_bend : Real(0.0);
      if constexpr (Dim == 3) bend = bend + about * e[i] * e[j];
      own[Dim + i][Dim + j] = shear + bend;
      coupling[Dim + i][Dim + j] = shear - bend;
    }
  }
  Square<Real, N> second = own;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < Dim; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < S; ++j) second[i][Dim + j] = second[Dim + j][i] = -own[i][Dim + j];
  }
  return {own, second, coupling};
}

}  // namespace fiberchain::dem
