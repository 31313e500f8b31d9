#pragma once

#include <Eigen/Core>

#include "dem/bond/law.hpp"
#include "dem/bond/law_hessian.hpp"
#include "dem/bond/matrices.hpp"
#include "dem/bond/rotation_coefficients.hpp"

// The one bond Jacobian: derivative of bond_loads() by the motions of its two spheres, in closed form.
namespace fiberchain::dem {

/// Motions of one sphere: Dim displacements, then its spins.
template <int Dim>
inline constexpr int sphere_motions = Dim + spin_size<Dim>;

/// Rows: force and moment on the first sphere, then on the second. Columns: displacement and left
/// (global) rotation of the first, then of the second. [N/m, N, N m]
template <int Dim>
using BondTangent = Eigen::Matrix<double, 2 * sphere_motions<Dim>, 2 * sphere_motions<Dim>>;

namespace tangent_detail {

/// How the strain follows the local motions z = (delta r, a_1, a_2), all in the mid-frame.
template <int Dim>
struct StrainRates {
  typename Sizes<Dim>::RotationRows mid;      ///< spin of the mid-frame a_m
  typename Sizes<Dim>::DisplacementRows rho;  ///< delta rho = delta r - a_m x rho
  typename Sizes<Dim>::RotationRows Omega;    ///< delta Omega = S^-1 (a_2 - a_1)
  typename Sizes<Dim>::RotationMatrix inverse_S;
};

template <int Dim>
StrainRates<Dim> strain_rates(const BondKinematics<double, Dim>& k, const RotationCoefficients& q) {
  using S = Sizes<Dim>;
  using RotationMatrix = typename S::RotationMatrix;
  RotationMatrix first = 0.5 * RotationMatrix::Identity(), second = first,
                 inverse_S = RotationMatrix::Identity();
  if constexpr (Dim == 3) {
    const Eigen::Vector3d Omega = eigen(k.rotation);
    first += 0.5 * skew(k.half_tangent);
    second -= 0.5 * skew(k.half_tangent);
    inverse_S = q.c * Eigen::Matrix3d::Identity() + q.b * Omega * Omega.transpose();
  }
  StrainRates<Dim> rates;
  rates.inverse_S = inverse_S;
  rates.mid << S::RotationRows::Zero().template leftCols<S::d>(), first, second;
  rates.Omega << S::RotationRows::Zero().template leftCols<S::d>(), -inverse_S, inverse_S;
  rates.rho = -spun_matrix(k.separation) * rates.mid;
  rates.rho.template leftCols<S::d>() += Eigen::Matrix<double, S::d, S::d>::Identity();
  return rates;
}

/// Derivative of mu = S^-1 m + t/2 x g, the moment that is opposite on the two spheres.
template <int Dim>
typename Sizes<Dim>::RotationRows opposite_moment_rates(
    const BondKinematics<double, Dim>& k, const RotationCoefficients& q,
    const BondStress<double, Dim>& stress, const StrainRates<Dim>& rates,
    const typename Sizes<Dim>::RotationRows& moment_rates,
    const typename Sizes<Dim>::RotationRows& half_torque_rates) {
  typename Sizes<Dim>::RotationRows mu = rates.inverse_S * moment_rates;
  if constexpr (Dim == 3) {
    const Eigen::Vector3d Omega = eigen(k.rotation);
    const Vec<double, 3> half_torque = 0.5 * cross(k.separation, stress.force);
    const Eigen::Matrix3d g_rate = q.k * Eigen::Matrix3d::Identity() + 2 * q.k_w * Omega * Omega.transpose();
    mu += (conjugate_derivative(q, Omega, eigen(stress.moment)) + skew(half_torque) * g_rate) * rates.Omega -
          skew(k.half_tangent) * half_torque_rates;
  }
  return mu;
}

template <int Dim>
Eigen::Matrix<double, Dim, Dim> matrix(const Frame<double, Dim>& frame) {
  Eigen::Matrix<double, Dim, Dim> R;
  for (int i = 0; i < Dim; ++i) {
    Vec<double, Dim> unit{};
    unit[i] = 1;
    R.col(i) = eigen(frame.to_global(unit));
  }
  return R;
}

template <int Dim>
using LocalTangent = Eigen::Matrix<double, 2 * sphere_motions<Dim>, Sizes<Dim>::local>;

/// The derivative by z in the mid-frame. Loads turn with the frame: delta(R_m u) = R_m (a_m x u + delta u).
template <int Dim>
LocalTangent<Dim> local_tangent(const BondParameters<double>& bond, const BondKinematics<double, Dim>& k) {
  using S = Sizes<Dim>;
  constexpr int d = S::d, s = S::s;
  RotationCoefficients q{};
  if constexpr (Dim == 3) q = rotation_coefficients(dot(k.rotation, k.rotation));
  const BondStress<double, Dim> stress = bond_stress(bond, k.separation, k.rotation);
  const StrainRates<Dim> rates = strain_rates(k, q);
  const typename S::Hessian H = law_hessian(bond, k);
  const typename S::DisplacementRows force =
      H.template topLeftCorner<d, d>() * rates.rho + H.template topRightCorner<d, s>() * rates.Omega;
  const typename S::RotationRows moment =
      H.template bottomLeftCorner<s, d>() * rates.rho + H.template bottomRightCorner<s, s>() * rates.Omega;
  const typename S::RotationRows half_torque =
      0.5 * (cross_matrix(k.separation) * force - cross_matrix(stress.force) * rates.rho);
  const typename S::RotationRows mu = opposite_moment_rates(k, q, stress, rates, moment, half_torque);

  LocalTangent<Dim> J;
  J << spun_matrix(stress.force) * rates.mid + force, half_torque + mu,
      -(spun_matrix(stress.force) * rates.mid + force), half_torque - mu;
  if constexpr (Dim == 3) {
    const BondKinematics<double, 3> unturned{{{1, {0, 0, 0}}}, k.separation, k.rotation, k.half_tangent};
    const BondLoads<double, 3> loads = bond_loads(unturned, stress);
    J.template middleRows<s>(d) += spun_matrix(loads.moment_on_first) * rates.mid;
    J.template bottomRows<s>() += spun_matrix(loads.moment_on_second) * rates.mid;
  }
  return J;
}

}  // namespace tangent_detail

template <int Dim>
BondTangent<Dim> bond_tangent(const BondParameters<double>& bond, const BondKinematics<double, Dim>& k) {
  using namespace tangent_detail;
  constexpr int d = Dim, s = spin_size<Dim>, motions = d + s;
  const LocalTangent<Dim> J = local_tangent(bond, k);
  const Eigen::Matrix<double, d, d> R = matrix(k.frame);
  Eigen::Matrix<double, motions, motions> T = Eigen::Matrix<double, motions, motions>::Identity();
  T.template topLeftCorner<d, d>() = R;
  if constexpr (Dim == 3) T.template bottomRightCorner<3, 3>() = R;
  Eigen::Matrix<double, 2 * motions, Sizes<Dim>::local> rows;
  rows << T * J.template topRows<motions>(), T * J.template bottomRows<motions>();
  BondTangent<Dim> tangent;
  const Eigen::Matrix<double, 2 * motions, d> by_separation = rows.template leftCols<d>() * R.transpose();
  const auto turn = T.template bottomRightCorner<s, s>().transpose();
  tangent << -by_separation, rows.template middleCols<s>(d) * turn, by_separation,
      rows.template rightCols<s>() * turn;
  return tangent;
}

}  // namespace fiberchain::dem
