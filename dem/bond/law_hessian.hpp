#pragma once

#include <Eigen/Core>
#include <cmath>

#include "dem/bond/law.hpp"
#include "dem/bond/matrices.hpp"

namespace fiberchain::dem::tangent_detail {

/// (gamma cot(gamma) - 1) / gamma^2 <= 0
inline double shear_bowl(double gamma) {
  const double g2 = gamma * gamma;
  return gamma > 1e-2 ? (gamma / std::tan(gamma) - 1) / g2 : -(1 + g2 / 15) / 3;
}

/// l^2 Hess(gamma^2/2) in polar coordinates about the mid-frame's axis:
/// I - e e^T - gamma (e e_gamma^T + e_gamma e^T) + (gamma cot(gamma) - 1) e_phi e_phi^T
template <int Dim>
Eigen::Matrix<double, Dim, Dim> shear_hessian(const Vec<double, Dim>& rho, const ShearAngle<double>& shear) {
  using Vector = Eigen::Matrix<double, Dim, 1>;
  const double across = across_squared(rho);
  const Vector e = eigen(rho) / shear.length;
  Vector perp = eigen(rho);
  perp[0] = 0;
  const Vector bent =
      shear.ratio / shear.length * (rho[0] * perp - across * Vector::Unit(0));  // gamma e_gamma
  Eigen::Matrix<double, Dim, Dim> hessian = Eigen::Matrix<double, Dim, Dim>::Identity() - e * e.transpose() -
                                            e * bent.transpose() - bent * e.transpose();
  if constexpr (Dim == 3) {
    const double gamma = shear.ratio * std::sqrt(across);
    const double scale = shear_bowl(gamma) * shear.ratio * shear.ratio;
    hessian.template bottomRightCorner<2, 2>() +=
        scale * (across * Eigen::Matrix2d::Identity() - perp.tail(2) * perp.tail(2).transpose());
  }
  return hessian;
}

/// Adds the second derivative of U_c by (rho, Omega).
inline void add_coupling_hessian(const BondCoupling<double>& c, const BondKinematics<double, 3>& k,
                                 Sizes<3>::Hessian& H) {
  enum { y = 1, z, twist, about_y, about_z };
  const Vec<double, 3>&rho = k.separation, &Omega = k.rotation;
  const auto add = [&H](int i, int j, double value) {
    H(i, j) += value;
    if (i != j) H(j, i) += value;
  };
  add(y, twist, -c.shear * Omega[1]);
  add(z, twist, c.arc_shear - c.shear * Omega[2]);
  add(y, about_y, -c.shear * Omega[0]);
  add(z, about_z, -c.shear * Omega[0]);
  add(twist, twist, c.bend * bend_squared(Omega) - 2 * c.arc_twist * Omega[2]);
  add(twist, about_y, 2 * Omega[0] * c.bend * Omega[1] - c.shear * rho[1]);
  add(twist, about_z, 2 * Omega[0] * (c.bend * Omega[2] - c.arc_twist) - c.shear * rho[2]);
  add(about_y, about_y, Omega[0] * Omega[0] * c.bend - c.arc_bend);
  add(about_z, about_z, Omega[0] * Omega[0] * c.bend);
}

/// Second derivative of U by (rho, Omega).
template <int Dim>
typename Sizes<Dim>::Hessian law_hessian(const BondParameters<double>& bond,
                                         const BondKinematics<double, Dim>& k) {
  using S = Sizes<Dim>;
  using Matrix = Eigen::Matrix<double, S::d, S::d>;
  const ShearAngle<double> shear = shear_angle(k.separation);
  const double l = shear.length, l0 = bond.rest_length;
  const double N = tension(bond, l - bond.unbent_length, bend_squared(k.rotation));
  const typename S::Displacement e = eigen(k.separation) / l;
  const typename S::Rotation slope =
      2 * l0 * bond.chord * eigen(scale_spin(0.0, 1.0, k.rotation));  // d(l-l_r)/dOmega
  const Matrix radial = e * e.transpose();
  typename S::Hessian H;
  H.template topLeftCorner<S::d, S::d>() =
      bond.stretch * radial + N / l * (Matrix::Identity() - radial) +
      bond.shear * l0 * l0 / (l * l) * shear_hessian(k.separation, shear);
  H.template topRightCorner<S::d, S::s>() = bond.stretch * e * slope.transpose();
  H.template bottomLeftCorner<S::s, S::d>() = bond.stretch * slope * e.transpose();
  Vec<double, S::s> ones;
  for (double& one : ones.c) one = 1;
  H.template bottomRightCorner<S::s, S::s>() = bond.stretch * slope * slope.transpose();
  H.template bottomRightCorner<S::s, S::s>().diagonal() +=
      eigen(scale_spin(bond.twist, bending_coefficient(bond, N), ones));
  if constexpr (Dim == 3) add_coupling_hessian(bond.coupling, k, H);
  return H;
}

}  // namespace fiberchain::dem::tangent_detail
