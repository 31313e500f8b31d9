#pragma once

#include <Eigen/Dense>
#include <vector>

namespace fiberchain::dem {

/// Square blocks of the couplings along a chain: sphere i with itself and with its two neighbors.
template <int Size>
struct BlockTridiagonal {
  using Block = Eigen::Matrix<double, Size, Size>;
  using Vector = Eigen::Matrix<double, Size, 1>;

  std::vector<Block> lower;     ///< row i, column i - 1; lower[0] is not used
  std::vector<Block> diagonal;
  std::vector<Block> upper;     ///< row i, column i + 1; the last is not used

  explicit BlockTridiagonal(int blocks) : lower(blocks), diagonal(blocks), upper(blocks) { set_zero(); }

  int blocks() const { return static_cast<int>(diagonal.size()); }

  void set_zero() {
    for (int i = 0; i < blocks(); ++i) {
      lower[i].setZero();
      diagonal[i].setZero();
      upper[i].setZero();
    }
  }
};

/// Solves in place by block elimination, cost linear in the number of blocks; the matrix is overwritten.
/// Pivoting stays inside a block, which suffices where the leading parts of the chain are themselves stable.
/// A singular block leaves non-finite numbers in the solution: the caller checks.
template <int Size>
void solve_in_place(BlockTridiagonal<Size>& A, std::vector<Eigen::Matrix<double, Size, 1>>& b) {
  const int n = A.blocks();
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      A.diagonal[i].noalias() -= A.lower[i] * A.upper[i - 1];
      b[i].noalias() -= A.lower[i] * b[i - 1];
    }
    const Eigen::PartialPivLU<typename BlockTridiagonal<Size>::Block> lu(A.diagonal[i]);
    b[i] = lu.solve(b[i]).eval();
    if (i + 1 < n) A.upper[i] = lu.solve(A.upper[i]).eval();
  }
  for (int i = n - 2; i >= 0; --i) b[i].noalias() -= A.upper[i] * b[i + 1];
}

}  // namespace fiberchain::dem
