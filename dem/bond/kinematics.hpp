#pragma once

#include <cmath>

#include "dem/bond/pose.hpp"
#include "dem/math/near_one.hpp"

// Strain of a bond in its mid-frame, the mean of the two sphere orientations, so that nothing changes
// when the chain is numbered from its other end.
namespace fiberchain::dem {

template <class Real, int Dim>
struct BondKinematics {
  Frame<Real, Dim> frame;        ///< mid-frame R_m
  Vec<Real, Dim> separation;     ///< rho = R_m^T (x_2 - x_1) [m]
  Spin<Real, Dim> rotation;      ///< Omega, rotation vector of sphere 2 against sphere 1, mid-frame [rad]
  Spin<Real, Dim> half_tangent;  ///< g = tan(|Omega| / 4) Omega / |Omega|; needed in space only
};

/// Rest orientation of a bond's ends against their spheres, for chains that are not straight at rest.
template <class Real, int Dim>
struct NaturalEnds;

template <class Real>
struct NaturalEnds<Real, 2> {
  Real first, second;  ///< angles [rad]
};

template <class Real>
struct NaturalEnds<Real, 3> {
  Quaternion<Real> first, second;
};

template <class Real>
Real turned(const Real& orientation, const Real& offset) {
  return orientation + offset;
}

template <class Real>
Quaternion<Real> turned(const Quaternion<Real>& orientation, const Quaternion<Real>& offset) {
  return orientation * offset;
}

template <class Real>
BondKinematics<Real, 2> bond_kinematics(const Pose<Real, 2>& first, const Pose<Real, 2>& second) {
  using std::cos;
  using std::sin;
  const Real mean = Real(0.5) * (first.orientation + second.orientation);
  const Frame<Real, 2> frame{{cos(mean), sin(mean)}};
  const Real theta = second.orientation - first.orientation;
  return {frame, frame.to_local(second.position - first.position), {theta}, {Real(0.0)}};
}

template <class Real>
BondKinematics<Real, 3> bond_kinematics(const Pose<Real, 3>& first, const Pose<Real, 3>& second) {
  const Quaternion<Real>&a = first.orientation, &b = second.orientation;
  const Quaternion<Real> relative = conjugate(a) * b;  // cos(|Omega|/2), sin(|Omega|/2) n
  const Vec<Real, 3> g = (Real(1.0) / (Real(1.0) + relative.w)) * relative.v;
  const Vec<Real, 3> Omega = (Real(4.0) * atan_ratio(dot(g, g))) * g;
  const Frame<Real, 3> frame{normalized(Quaternion<Real>{a.w + b.w, a.v + b.v})};
  return {frame, frame.to_local(second.position - first.position), Omega, g};
}

}  // namespace fiberchain::dem
