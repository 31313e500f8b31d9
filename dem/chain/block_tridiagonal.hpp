#pragma once

#include <Eigen/Dense>
#include <vector>

namespace fiberchain::dem {

/// Square blocks of the couplings along a chain: sphere i with itself and with its two neighbors.
template <int Size>
struct BlockTridiagonal {
  using Block = Eigen::Matrix<double, Size, Size>;
  using Vector = Eigen::Matrix<double, Size, 1>;

  std::vector<Block> lower;  ///< row i, column i - 1; lower[0] is not used
  std::vector<Block> diagonal;
  std::vector<Block> upper;  ///< row i, column i + 1; the last is not used

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

/// Block elimination along the chain, kept for many right-hand sides; cost linear in the number of blocks.
/// Pivoting stays inside a block, which suffices where the leading parts of the chain are themselves stable.
/// A singular block leaves non-finite numbers in the solution: the caller checks.
template <int Size>
class ChainFactors {
 public:
  using Vector = Eigen::Matrix<double, Size, 1>;

  explicit ChainFactors(const BlockTridiagonal<Size>& A) : lower_(A.lower), upper_(A.blocks()) {
    lu_.reserve(A.blocks());
    for (int i = 0; i < A.blocks(); ++i) {
      typename BlockTridiagonal<Size>::Block diagonal = A.diagonal[i];
      if (i > 0) diagonal.noalias() -= A.lower[i] * upper_[i - 1];
      lu_.emplace_back(diagonal);
      if (i + 1 < A.blocks()) upper_[i] = lu_[i].solve(A.upper[i]);
    }
  }

  void solve_in_place(std::vector<Vector>& b) const {
    const int n = static_cast<int>(lu_.size());
    for (int i = 0; i < n; ++i) {
      if (i > 0) b[i].noalias() -= lower_[i] * b[i - 1];
      b[i] = lu_[i].solve(b[i]).eval();
    }
    for (int i = n - 2; i >= 0; --i) b[i].noalias() -= upper_[i] * b[i + 1];
  }

 private:
  std::vector<typename BlockTridiagonal<Size>::Block> lower_, upper_;
  std::vector<Eigen::PartialPivLU<typename BlockTridiagonal<Size>::Block>> lu_;
};

template <int Size>
void solve_in_place(const BlockTridiagonal<Size>& A, std::vector<Eigen::Matrix<double, Size, 1>>& b) {
  ChainFactors<Size>(A).solve_in_place(b);
}

/// A x
template <int Size>
std::vector<Eigen::Matrix<double, Size, 1>> product(const BlockTridiagonal<Size>& A,
                                                    const std::vector<Eigen::Matrix<double, Size, 1>>& x) {
  const int n = A.blocks();
  std::vector<Eigen::Matrix<double, Size, 1>> y(n);
  for (int i = 0; i < n; ++i) {
    y[i].noalias() = A.diagonal[i] * x[i];
    if (i > 0) y[i].noalias() += A.lower[i] * x[i - 1];
    if (i + 1 < n) y[i].noalias() += A.upper[i] * x[i + 1];
  }
  return y;
}

}  // namespace fiberchain::dem
