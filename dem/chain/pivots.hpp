#pragma once

#include <Eigen/Eigenvalues>

#include "dem/chain/block_tridiagonal.hpp"

// What the pivots of the block elimination along a chain tell about its matrix (Sylvester's law of inertia).
namespace fiberchain::dem {

/// Negative eigenvalues of a symmetric matrix. Most have none, which Cholesky says at a fraction of the cost.
template <int Size>
int negative_eigenvalues(const Eigen::Matrix<double, Size, Size>& A) {
  if (A.llt().info() == Eigen::Success) return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(A, Eigen::EigenvaluesOnly);
  return static_cast<int>((solver.eigenvalues().array() < 0).count());
}

/// Negative eigenvalues of the symmetric part of A: those of the pivots of its block elimination.
template <int Size>
int negative_pivots(const BlockTridiagonal<Size>& A) {
  using B = typename BlockTridiagonal<Size>::Block;
  int count = 0;
  B before;
  for (int i = 0; i < A.blocks(); ++i) {
    B pivot = 0.5 * (A.diagonal[i] + A.diagonal[i].transpose());
    if (i > 0) {
      const B coupling = 0.5 * (A.lower[i] + A.upper[i - 1].transpose());
      const B scaled = before.partialPivLu().solve(coupling.transpose());
      pivot.noalias() -= coupling * scaled;
      pivot = (0.5 * (pivot + pivot.transpose())).eval();
    }
    // rows of different units: scaled to a unit diagonal, which keeps the signs
    const auto scale = pivot.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse().eval();
    count += negative_eigenvalues<Size>(scale.asDiagonal() * pivot * scale.asDiagonal());
    before = pivot;
  }
  return count;
}

/// Whether the determinant of A, symmetric or not, is negative.
template <int Size>
bool negative_determinant(const BlockTridiagonal<Size>& A) {
  using B = typename BlockTridiagonal<Size>::Block;
  bool negative = false;
  B before;
  for (int i = 0; i < A.blocks(); ++i) {
    B pivot = A.diagonal[i];
    if (i > 0) pivot.noalias() -= A.lower[i] * before;
    const auto scale = pivot.rowwise().norm().cwiseMax(1e-300).cwiseInverse().eval();
    negative ^= (scale.asDiagonal() * pivot).eval().partialPivLu().determinant() < 0;
    if (i + 1 < A.blocks()) before = pivot.partialPivLu().solve(A.upper[i]).eval();
  }
  return negative;
}

}  // namespace fiberchain::dem
