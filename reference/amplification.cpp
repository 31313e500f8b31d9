#include "reference/amplification.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "reference/chain_strains.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::MatrixXcd;
using std::numbers::pi;

/// Round-off of |z| on the unit circle stays below this: strains and velocities, scaled to energies, have no
/// repeated root with a single vector (the rigid motions' root 1 has one vector each).
constexpr double round_off = 1e-10;

/// Strains e = B u with spring and dashpot of each, B possibly of one wave.
struct Strains {
  MatrixXcd b;
  Eigen::VectorXd spring, dashpot, inertia;
};

/// Spectral radius of (e, v) -> (e + dt B v+, v+), in the variables sqrt(spring) e and sqrt(inertia) v.
double radius(const Strains& s, ExplicitScheme scheme, double dt) {
  const MatrixXcd scaled = s.b * s.inertia.cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXcd root = s.spring.cwiseSqrt().asDiagonal() * scaled;
  const MatrixXcd damping = scaled.adjoint() * s.dashpot.asDiagonal() * scaled;
  const Eigen::Index strains = root.rows(), speeds = root.cols();
  const MatrixXcd one = MatrixXcd::Identity(speeds, speeds);
  MatrixXcd keep = one - dt * damping, push = -dt * root.adjoint();
  if (scheme == ExplicitScheme::damped_in_step) {
    const Eigen::PartialPivLU<MatrixXcd> implicit(one + dt / 2 * damping);
    keep = implicit.solve(one - dt / 2 * damping);
    push = implicit.solve(push);
  }
  MatrixXcd step(strains + speeds, strains + speeds);
  step << MatrixXcd::Identity(strains, strains) + dt * root * push, dt * root * keep, push, keep;
  const Eigen::ComplexEigenSolver<MatrixXcd> solver(step, false);
  if (solver.info() != Eigen::Success) throw NoConvergence("eigenvalues of the amplification matrix");
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

/// Strains of one wave about the middle of a bond, u_i ~ exp(i phase (i - 1/2)).
Strains wave_strains(const LinearChain& chain, ChainMotion motion, double phase) {
  const std::complex<double> difference(0, 2 * std::sin(phase / 2));
  const auto single = [&](double spring, double dashpot, double inertia) {
    return Strains{MatrixXcd::Constant(1, 1, difference), Eigen::VectorXd::Constant(1, spring),
                   Eigen::VectorXd::Constant(1, dashpot), Eigen::VectorXd::Constant(1, inertia)};
  };
  const BondCoefficients &k = chain.stiffness, &c = chain.dashpot;
  if (motion == ChainMotion::axial) return single(k.stretch, c.stretch, chain.mass);
  if (motion == ChainMotion::twist) return single(k.twist, c.twist, chain.inertia);
  MatrixXcd b(2, 2);
  b << difference, -chain.spacing * std::cos(phase / 2), 0, difference;
  return {b, Eigen::Vector2d(k.shear, k.bend), Eigen::Vector2d(c.shear, c.bend),
          Eigen::Vector2d(chain.mass, chain.inertia)};
}

/// Last step at which `stable` holds, between 0 and the end of the doubling that finds the first where it
/// does not.
double last_stable(double guess, const std::function<bool(double)>& stable) {
  double low = 0, high = guess;
  while (stable(high)) low = high, high *= 2;
  while (high - low > 1e-13 * high) {
    const double middle = (low + high) / 2;
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

double wave_limit(const LinearChain& chain, ExplicitScheme scheme, ChainMotion motion, double phase) {
  return last_stable(bond_time(chain), [&](double dt) {
    return wave_radius(chain, scheme, motion, phase, dt) <= 1 + round_off;
  });
}

/// Least limit over the phase: the waves sampled, then the least of them by sections around it.
double least_wave_limit(const LinearChain& chain, ExplicitScheme scheme) {
  constexpr int samples = 32;
  const auto limit = [&](double phase) { return wave_limit(chain, scheme, ChainMotion::bending, phase); };
  int best = 0;
  std::vector<double> at;
  for (int i = 0; i <= samples; ++i) {
    at.push_back(limit(pi * i / samples));
    if (at[i] < at[best]) best = i;
  }
  double low = pi * std::max(best - 1, 0) / samples, high = pi * std::min(best + 1, samples) / samples;
  double least = at[best];
  while (high - low > 1e-4) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const double at_a = limit(a), at_b = limit(b);
    least = std::min({least, at_a, at_b});
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  return least;
}

/// Weights of M, C and K in P(z).
struct Pencil {
  double inertia, dashpot, spring;
};

Pencil pencil(ExplicitScheme scheme, double dt, double z) {
  const double damping = scheme == ExplicitScheme::lagged_dashpots ? z - 1 : (z * z - 1) / 2;
  return {(z - 1) * (z - 1), dt * damping, dt * dt * z};
}

/// Whether P is positive definite on the bending motions: elimination along the chain, sphere by sphere.
bool bending_is_definite(const LinearChain& chain, ChainEnds ends, const Pencil& p) {
  const BondCoefficients &k = chain.stiffness, &c = chain.dashpot;
  const Eigen::DiagonalMatrix<double, 2> weight(p.dashpot * c.shear + p.spring * k.shear,
                                                p.dashpot * c.bend + p.spring * k.bend);
  Eigen::Matrix2d behind, ahead;  // strains of the bond by its second and its first sphere
  behind << 1, -chain.spacing / 2, 0, 1;
  ahead << -1, -chain.spacing / 2, 0, -1;
  const Eigen::Matrix2d mass =
      Eigen::Vector2d(p.inertia * chain.mass, p.inertia * chain.inertia).asDiagonal();
  const Eigen::Matrix2d first = ahead.transpose() * weight * ahead,
                        second = behind.transpose() * weight * behind;
  const Eigen::Matrix2d between = behind.transpose() * weight * ahead;
  const auto definite = [](const Eigen::Matrix2d& m) { return m(0, 0) > 0 && m.determinant() > 0; };
  const bool held = ends == ChainEnds::clamped_free;
  const auto mass_of = [&](int sphere) -> Eigen::Matrix2d {
    return (sphere == 0 || sphere == chain.bonds ? chain.end_share : 1.0) * mass;
  };
  Eigen::Matrix2d left = mass_of(0) + first;  // what elimination leaves of a sphere
  if (!held && !definite(left)) return false;
  for (int sphere = 1; sphere <= chain.bonds; ++sphere) {
    Eigen::Matrix2d own = mass_of(sphere) + second;
    if (sphere < chain.bonds) own += first;
    if (sphere > 1 || !held) own -= between * left.inverse() * between.transpose();
    if (!definite(own)) return false;
    left = own;
  }
  return true;
}

/// Whether P is positive definite on all motions, so that every real root lies right of z.
bool is_definite(const LinearChain& chain, ExplicitScheme scheme, ChainEnds ends, bool planar, double dt,
                 double z) {
  const Pencil p = pencil(scheme, dt, z);
  const int n = chain.bonds;
  // largest eigenvalue of the strains of a rod: 4 sin^2 of these; with half masses at the ends below 4
  const double angle = chain.end_share != 1              ? pi / 2
                       : ends == ChainEnds::clamped_free ? (2 * n - 1) * pi / (4.0 * n + 2)
                                                         : n * pi / (2.0 * n + 2);
  const double rod = 4 * std::sin(angle) * std::sin(angle);
  const BondCoefficients &k = chain.stiffness, &c = chain.dashpot;
  const auto definite = [&](double m, double dashpot, double spring) {
    return p.inertia * m + rod * (p.dashpot * dashpot + p.spring * spring) > 0;
  };
  return definite(chain.mass, c.stretch, k.stretch) &&
         (planar || definite(chain.inertia, c.twist, k.twist)) && bending_is_definite(chain, ends, p);
}

}  // namespace

double wave_radius(const LinearChain& chain, ExplicitScheme scheme, ChainMotion motion, double phase,
                   double dt) {
  validate(chain);
  require_between("phase", phase, 0, pi);
  require_positive("dt", dt);
  return radius(wave_strains(chain, motion, phase), scheme, dt);
}

double chain_radius(const LinearChain& chain, ExplicitScheme scheme, ChainMotion motion, ChainEnds ends,
                    double dt) {
  validate(chain);
  require_between("bonds (dense modes)", chain.bonds, 1, 100);
  require_positive("dt", dt);
  const detail::ChainStrains s = detail::chain_strains(chain, motion, ends);
  return radius({s.b.cast<std::complex<double>>(), s.spring, s.dashpot, s.inertia}, scheme, dt);
}

double growth_per_step(const LinearChain& chain, ExplicitScheme scheme, ChainEnds ends, double dt,
                       bool planar) {
  validate(chain);
  require_positive("dt", dt);
  const auto definite = [&](double z) { return is_definite(chain, scheme, ends, planar, dt, z); };
  if (definite(-1)) return 1;
  double right = -1, left = -2;
  while (!definite(left)) right = left, left *= 2;
  while (right - left > 1e-14 * -left) {
    const double middle = (left + right) / 2;
    (definite(middle) ? left : right) = middle;
  }
  return -right;
}

double endless_stable_step(const LinearChain& chain, ExplicitScheme scheme, bool planar) {
  validate(chain);
  // along and about the chain neighbors moving against each other are the first to grow
  double least = std::min(wave_limit(chain, scheme, ChainMotion::axial, pi), least_wave_limit(chain, scheme));
  if (!planar) least = std::min(least, wave_limit(chain, scheme, ChainMotion::twist, pi));
  return least;
}

double finite_stable_step(const LinearChain& chain, ExplicitScheme scheme, ChainEnds ends, bool planar) {
  validate(chain);
  return last_stable(bond_time(chain),
                     [&](double dt) { return is_definite(chain, scheme, ends, planar, dt, -1); });
}

double rayleigh_step(const ChainMaterial& material) {
  linear_chain(material);  // refuses what makes no sense
  const double shear_modulus = material.modulus / (2 * (1 + material.poisson_ratio));
  return pi * material.radius * std::sqrt(material.density / shear_modulus) /
         (0.1631 * material.poisson_ratio + 0.8766);
}

}  // namespace fiberchain::reference
