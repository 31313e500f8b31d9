#include "reference/twisted_ring.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Waves = Eigen::Matrix<std::complex<double>, 6, 6>;

// In units of L and E I; components along the ring's tangent, toward its center and along its axis, which
// turn by Omega = kappa b along it.
constexpr double kappa = 2 * std::numbers::pi;

struct UniformRing {
  Vector3d director;  ///< d, the section's normal, tilted out of the plane by shear
  Vector3d strain;    ///< v
  Vector3d force, moment;
};

Matrix3d cross_of(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// Balanced ring whose sections turn by `twist` about d besides: u = kappa b + twist d.
UniformRing uniform_ring(double torsion, double stretch, double shear, double twist) {
  double tilt = 0, force = 0, along = 1;  // sin of the angle of d, F, v_t
  for (int i = 0; i < 200; ++i) {
    const double lean = std::sqrt(1 - tilt * tilt), before = force;
    const double m_t = (torsion * (kappa * tilt + twist) - kappa * tilt) * lean;
    force = kappa * m_t / along;
    const double pull = 1 + force * tilt * (stretch - shear);
    along = lean * pull;
    tilt = -force * shear / pull;
    if (std::abs(force - before) <= 1e-15 * std::abs(force)) break;
  }
  const Vector3d d{std::sqrt(1 - tilt * tilt), 0, tilt}, b{0, 0, 1};
  const Vector3d moment = torsion * (kappa * tilt + twist) * d + kappa * (b - tilt * d);
  return {d, {along, 0, 0}, force * b, moment};
}

/// Determinant for two waves: (2 i kappa + Omega x) of turn and moment; the force does not change, as its
/// equation dn' = 0 has no such solution.
double determinant(double torsion, double stretch, double shear, double twist) {
  const UniformRing ring = uniform_ring(torsion, stretch, shear, twist);
  const Matrix3d onto = ring.director * ring.director.transpose(), rest = Matrix3d::Identity() - onto;
  const Matrix3d bend = onto / torsion + rest, pull = stretch * onto + shear * rest;
  // rates of the place by the turn t: t x v - P (t x n)
  const Matrix3d place = -cross_of(ring.strain) + pull * cross_of(ring.force);
  Waves waves = Waves::Zero();
  const std::complex<double> wave(0, 2 * kappa);
  for (const int at : {0, 3}) {
    waves.block<3, 3>(at, at) = cross_of({0, 0, kappa}).cast<std::complex<double>>();
    waves.block<3, 3>(at, at).diagonal().array() += wave;
  }
  // turn' = A (m - t x M), m' = N x place
  waves.block<3, 3>(0, 0) -= (bend * cross_of(ring.moment)).cast<std::complex<double>>();
  waves.block<3, 3>(0, 3) -= bend.cast<std::complex<double>>();
  waves.block<3, 3>(3, 0) -= (cross_of(ring.force) * place).cast<std::complex<double>>();
  return waves.determinant().real();
}

}  // namespace

double twisted_ring_critical_turn(const TwistedRing& ring) {
  require_positive("length", ring.length);
  require_positive("bending", ring.bending);
  require_positive("torsion", ring.torsion);
  require_positive_or_infinite("axial", ring.axial);
  require_positive_or_infinite("shear", ring.shear);
  const double unit = ring.bending / (ring.length * ring.length);
  const double torsion = ring.torsion / ring.bending, stretch = unit / ring.axial, shear = unit / ring.shear;
  const double michell = 2 * std::numbers::pi * std::sqrt(3.0) / torsion;
  return detail::find_root([&](double twist) { return determinant(torsion, stretch, shear, twist); },
                           0.6 * michell, 1.2 * michell, {0, 1e-14, 200}, "a twisted ring's critical turn");
}

}  // namespace fiberchain::reference
