#include "reference/amplification.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

#include "reference/chain_strains.hpp"
#include "reference/errors.hpp"
#include "reference/step_matrix.hpp"

namespace fiberchain::reference {
namespace {

using detail::StepStrains;
using Eigen::MatrixXcd;
using std::numbers::pi;

/// Round-off of |z| on the unit circle stays below this: strains and velocities, scaled to energies, have no
/// repeated root with a single vector (the rigid motions' root 1 has one vector each).
constexpr double round_off = 1e-10;

template <class Scalar>
double radius(const StepStrains<Scalar>& strains, const TimeScheme& scheme, double dt) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Solver = std::conditional_t<std::is_same_v<Scalar, double>, Eigen::EigenSolver<Matrix>,
                                    Eigen::ComplexEigenSolver<Matrix>>;
  const Solver solver(detail::step_matrix(strains, scheme, dt).step, false);
  if (solver.info() != Eigen::Success) throw NoConvergence("eigenvalues of the amplification matrix");
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

/// One more strain of every bond, that across it against the pull, whose spring is not in the matrix.
template <class Scalar>
void pull(StepStrains<Scalar>& s, const LinearChain& chain, double tension,
          const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& across) {
  const Eigen::Index old = s.b.rows(), more = across.rows();
  const auto grow = [&](Eigen::VectorXd& v, double value) {
    v.conservativeResize(old + more);
    v.tail(more).setConstant(value);
  };
  s.b.conservativeResize(old + more, Eigen::NoChange);
  s.b.bottomRows(more) = across;
  grow(s.spring, tension / chain.spacing);
  grow(s.solved, 0);
  grow(s.dashpot, 0);
}

void require_tension(double tension) {
  require_between("tension", tension, 0, std::numeric_limits<double>::max());
}

/// Strains of one wave about the middle of a bond, u_i ~ exp(i phase (i - 1/2)).
StepStrains<std::complex<double>> wave_strains(const LinearChain& chain, ChainMotion motion, double phase,
                                               double tension) {
  const std::complex<double> difference(0, 2 * std::sin(phase / 2));
  const auto single = [&](double spring, double dashpot, double inertia) {
    const auto one = [](double value) { return Eigen::VectorXd::Constant(1, value); };
    return StepStrains<std::complex<double>>{MatrixXcd::Constant(1, 1, difference), one(spring), one(spring),
                                             one(dashpot), one(inertia)};
  };
  const BondCoefficients &k = chain.stiffness, &c = chain.dashpot;
  if (motion == ChainMotion::axial) return single(k.stretch, c.stretch, chain.mass);
  if (motion == ChainMotion::twist) return single(k.twist, c.twist, chain.inertia);
  MatrixXcd b(2, 2), across(1, 2);
  b << difference, -chain.spacing * std::cos(phase / 2), 0, difference;
  across << difference, 0;
  const Eigen::Vector2d spring(k.shear, k.bend);
  StepStrains<std::complex<double>> strains{b, spring, spring, Eigen::Vector2d(c.shear, c.bend),
                                            Eigen::Vector2d(chain.mass, chain.inertia)};
  if (tension > 0) pull(strains, chain, tension, across);
  return strains;
}

StepStrains<double> strains_of(const LinearChain& chain, ChainMotion motion, ChainEnds ends, double tension) {
  const detail::ChainStrains s = detail::chain_strains(chain, motion, ends);
  StepStrains<double> strains{s.b, s.spring, s.spring, s.dashpot, s.inertia};
  if (tension == 0 || motion != ChainMotion::bending) return strains;
  Eigen::MatrixXd across = s.b(Eigen::seqN(0, chain.bonds, 2), Eigen::all);  // the shears,
  across(Eigen::all, Eigen::seqN(1, s.b.cols() / 2, 2)).setZero();           // without the rotations' part
  pull(strains, chain, tension, across);
  return strains;
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

double wave_limit(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion, double phase) {
  return last_stable(bond_time(chain), [&](double dt) {
    return wave_radius(chain, scheme, motion, phase, dt) <= 1 + round_off;
  });
}

/// Whether P(-1)/4 = M - (1/2 - theta) dt C - (1/4 - beta) dt^2 K is positive definite at any step.
bool always_stable(const TimeScheme& scheme, const LinearChain& chain) {
  const BondCoefficients& c = chain.dashpot;
  const bool undamped = c.stretch == 0 && c.shear == 0 && c.twist == 0 && c.bend == 0;
  return scheme.beta >= 0.25 && (scheme.theta == 0.5 || undamped);
}

/// Least limit over the phase: the waves sampled, then the least of them by sections around it.
double least_wave_limit(const LinearChain& chain, const TimeScheme& scheme) {
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

/// Weights of M, C and K, and of the stiffness by tension, in P(z).
struct Pencil {
  double inertia, dashpot, spring, pull;
};

Pencil pencil(const TimeScheme& scheme, double dt, double z) {
  const double square = (z - 1) * (z - 1);
  return {square, dt * (scheme.theta * square + z - 1), dt * dt * (scheme.beta * square + z), dt * dt * z};
}

/// Whether P is positive definite on the bending motions: elimination along the chain, sphere by sphere.
bool bending_is_definite(const LinearChain& chain, ChainEnds ends, double tension, const Pencil& p) {
  const BondCoefficients &k = chain.stiffness, &c = chain.dashpot;
  const Eigen::DiagonalMatrix<double, 2> weight(p.dashpot * c.shear + p.spring * k.shear,
                                                p.dashpot * c.bend + p.spring * k.bend);
  Eigen::Matrix2d behind, ahead;  // strains of the bond by its second and its first sphere
  behind << 1, -chain.spacing / 2, 0, 1;
  ahead << -1, -chain.spacing / 2, 0, -1;
  const Eigen::Matrix2d mass =
      Eigen::Vector2d(p.inertia * chain.mass, p.inertia * chain.inertia).asDiagonal();
  const Eigen::Matrix2d across = Eigen::Vector2d(p.pull * tension / chain.spacing, 0).asDiagonal();
  const Eigen::Matrix2d first = ahead.transpose() * weight * ahead + across,
                        second = behind.transpose() * weight * behind + across;
  const Eigen::Matrix2d between = behind.transpose() * weight * ahead - across;
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

/// The same along or about the chain.
bool rod_is_definite(const LinearChain& chain, ChainEnds ends, const Pencil& p, ChainMotion motion) {
  const bool axial = motion == ChainMotion::axial;
  const double inertia = p.inertia * (axial ? chain.mass : chain.inertia),
               bond = axial ? p.dashpot * chain.dashpot.stretch + p.spring * chain.stiffness.stretch
                            : p.dashpot * chain.dashpot.twist + p.spring * chain.stiffness.twist;
  double left = ends == ChainEnds::clamped_free ? std::numeric_limits<double>::infinity()
                                                : chain.end_share * inertia + bond;
  for (int sphere = 1; sphere <= chain.bonds; ++sphere) {
    if (!(left > 0)) return false;
    const bool last = sphere == chain.bonds;
    left = (last ? chain.end_share : 1.0) * inertia + (last ? 1 : 2) * bond - bond * bond / left;
  }
  return left > 0;
}

/// Whether P is positive definite on all motions, so that every real root lies right of z.
bool is_definite(const LinearChain& chain, const TimeScheme& scheme, ChainEnds ends, bool planar,
                 double tension, double dt, double z) {
  const Pencil p = pencil(scheme, dt, z);
  const int n = chain.bonds;
  if (chain.spacing_ratio != 1) {
    return rod_is_definite(chain, ends, p, ChainMotion::axial) &&
           (planar || rod_is_definite(chain, ends, p, ChainMotion::twist)) &&
           bending_is_definite(chain, ends, tension, p);
  }
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
         (planar || definite(chain.inertia, c.twist, k.twist)) &&
         bending_is_definite(chain, ends, tension, p);
}

}  // namespace

double wave_radius(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion, double phase,
                   double dt, double tension) {
  validate(chain);
  validate(scheme);
  require_between("phase", phase, 0, pi);
  require_positive("dt", dt);
  require_tension(tension);
  return radius(wave_strains(chain, motion, phase, tension), scheme, dt);
}

double chain_radius(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion, ChainEnds ends,
                    double dt, double tension) {
  validate(chain);
  validate(scheme);
  require_between("bonds (dense modes)", chain.bonds, 1, 200);
  require_positive("dt", dt);
  require_tension(tension);
  return radius(strains_of(chain, motion, ends, tension), scheme, dt);
}

double growth_per_step(const LinearChain& chain, const TimeScheme& scheme, ChainEnds ends, double dt,
                       bool planar, double tension) {
  validate(chain);
  validate(scheme);
  require_positive("dt", dt);
  require_tension(tension);
  const auto definite = [&](double z) { return is_definite(chain, scheme, ends, planar, tension, dt, z); };
  if (definite(-1)) return 1;
  double right = -1, left = -2;
  while (!definite(left)) right = left, left *= 2;
  while (right - left > 1e-14 * -left) {
    const double middle = (left + right) / 2;
    (definite(middle) ? left : right) = middle;
  }
  return -right;
}

double endless_stable_step(const LinearChain& chain, const TimeScheme& scheme, bool planar) {
  validate(chain);
  validate(scheme);
  if (always_stable(scheme, chain)) return std::numeric_limits<double>::infinity();
  // along and about the chain neighbors moving against each other are the first to grow
  double least = std::min(wave_limit(chain, scheme, ChainMotion::axial, pi), least_wave_limit(chain, scheme));
  if (!planar) least = std::min(least, wave_limit(chain, scheme, ChainMotion::twist, pi));
  return least;
}

double finite_stable_step(const LinearChain& chain, const TimeScheme& scheme, ChainEnds ends, bool planar,
                          double tension) {
  validate(chain);
  validate(scheme);
  require_tension(tension);
  if (tension == 0 && always_stable(scheme, chain)) return std::numeric_limits<double>::infinity();
  return last_stable(bond_time(chain),
                     [&](double dt) { return is_definite(chain, scheme, ends, planar, tension, dt, -1); });
}

double rayleigh_step(const ChainMaterial& material) {
  linear_chain(material);  // refuses what makes no sense
  const double shear_modulus = material.modulus / (2 * (1 + material.poisson_ratio));
  return pi * material.radius * std::sqrt(material.density / shear_modulus) /
         (0.1631 * material.poisson_ratio + 0.8766);
}

}  // namespace fiberchain::reference
