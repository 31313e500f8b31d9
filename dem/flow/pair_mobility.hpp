#pragma once

#include <Eigen/Core>
#include <array>

// What a sphere in creeping flow does to another of the same radius, in units of 1 / (8 pi mu) and R: exact
// averages over both spheres of the field of a force, torque or stresslet spread evenly over the surface
// (Faxen's laws).
namespace fiberchain::dem::pair {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// x from j to i: r > 0 its length, e its direction.
struct Line {
  double r;
  Vector e;
};

/// U_i of F_j; the lower one where the spheres overlap.
inline Matrix translation_by_force(const Line& l) {
  const Matrix ee = l.e * l.e.transpose();
  if (l.r < 2) return 4.0 / 3 * ((1 - 9.0 / 32 * l.r) * Matrix::Identity() + 3.0 / 32 * l.r * ee);
  const double q = 1 / (l.r * l.r);
  return ((1 + 2.0 / 3 * q) * Matrix::Identity() + (1 - 2 * q) * ee) / l.r;
}

/// (e x)
inline Matrix cross_matrix(const Vector& e) {
  Matrix m;
  m << 0, -e[2], e[1], e[2], 0, -e[0], -e[1], e[0], 0;
  return m;
}

/// U_i of T_j = T x e / r^2, and W_i of F_j, the same.
inline Matrix translation_by_torque(const Line& l) {
  const double size = l.r < 2 ? 0.5 * (l.r - 3.0 / 8 * l.r * l.r) : 1 / (l.r * l.r);
  return -size * cross_matrix(l.e);
}

/// W_i of T_j
inline Matrix spin_by_torque(const Line& l) {
  const Matrix ee = l.e * l.e.transpose();
  const double r = l.r, r3 = r * r * r;
  if (r < 2)
    return (1 - 27.0 / 32 * r + 5.0 / 64 * r3) * Matrix::Identity() + (9.0 / 32 * r - 3.0 / 64 * r3) * ee;
  return (3 * ee - Matrix::Identity()) / (2 * r3);
}

/// U_i of the force dipole S_j
inline Vector translation_by_dipole(const Line& l, const Matrix& S) {
  const Vector Se = S * l.e;
  const double s = l.e.dot(Se), q = 1 / (l.r * l.r);
  return 3 * q * (s * l.e + 8.0 / 15 * q * (2 * Se - 5 * s * l.e));
}

/// W_i of S_j
inline Vector spin_by_dipole(const Line& l, const Matrix& S) {
  return 3 / (l.r * l.r * l.r) * (S * l.e).cross(l.e);
}

/// Strain rate around i of S_j
inline Matrix strain_by_dipole(const Line& l, const Matrix& S) {
  const Vector Se = S * l.e;
  const double s = l.e.dot(Se), r3 = l.r * l.r * l.r;
  const Matrix P = l.e * Se.transpose() + Se * l.e.transpose(), I = Matrix::Identity(),
               ee = l.e * l.e.transpose();
  return 3 / r3 *
         (s * I + P - 5 * s * ee + 2.0 / (5 * l.r * l.r) * (2 * S - 10 * P - 5 * s * I + 35 * s * ee));
}

/// Of one sphere alone: velocity by force, spin by torque, strain rate by dipole.
inline constexpr double own_translation = 4.0 / 3, own_spin = 1, own_strain = 6.0 / 5;

/// Orthonormal basis of the symmetric traceless matrices.
inline std::array<Matrix, 5> strain_basis() {
  const double h = std::sqrt(0.5), k = std::sqrt(1.0 / 6);
  std::array<Matrix, 5> basis;
  basis.fill(Matrix::Zero());
  basis[0].diagonal() << h, -h, 0;
  basis[1].diagonal() << -k, -k, 2 * k;
  constexpr int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int n = 0; n < 3; ++n)
    basis[2 + n](pairs[n][0], pairs[n][1]) = basis[2 + n](pairs[n][1], pairs[n][0]) = h;
  return basis;
}

}  // namespace fiberchain::dem::pair
