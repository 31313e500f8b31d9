#pragma once

#include <Eigen/Core>

#include "dem/math/vec.hpp"

// Eigen's view of the small vectors, for the Jacobian.
namespace fiberchain::dem::tangent_detail {

template <int Dim>
struct Sizes {
  static constexpr int d = Dim, s = spin_size<Dim>, local = d + 2 * s;
  using Displacement = Eigen::Matrix<double, d, 1>;
  using Rotation = Eigen::Matrix<double, s, 1>;
  using DisplacementRows = Eigen::Matrix<double, d, local>;
  using RotationRows = Eigen::Matrix<double, s, local>;
  using RotationMatrix = Eigen::Matrix<double, s, s>;
  using Hessian = Eigen::Matrix<double, d + s, d + s>;
};

template <int N>
Eigen::Matrix<double, N, 1> eigen(const Vec<double, N>& v) {
  return Eigen::Map<const Eigen::Matrix<double, N, 1>>(v.c);
}

inline Eigen::Matrix3d skew(const Vec<double, 3>& v) {
  return Eigen::Matrix3d{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}};
}

/// Matrix C(v) with C(v) w = v x w; in the plane a force against a lever arm, a row.
inline Eigen::Matrix<double, 1, 2> cross_matrix(const Vec<double, 2>& v) { return {-v[1], v[0]}; }
inline Eigen::Matrix3d cross_matrix(const Vec<double, 3>& v) { return skew(v); }

/// Matrix B(v) with B(v) a = a x v for a spin a.
inline Eigen::Matrix<double, 2, 1> spun_matrix(const Vec<double, 2>& v) { return {-v[1], v[0]}; }
inline Eigen::Matrix3d spun_matrix(const Vec<double, 3>& v) { return -skew(v); }

}  // namespace fiberchain::dem::tangent_detail
