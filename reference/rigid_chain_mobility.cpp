#include "reference/rigid_chain_mobility.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "reference/errors.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void validate(const RigidChain& chain) {
  require_between("spheres", chain.spheres, 1, 500);
  require_between("spacing_ratio", chain.spacing_ratio, 2, 1e6);
}

VectorXd centers(const RigidChain& chain) {
  const double half = chain.spacing_ratio * (chain.spheres - 1) / 2;
  return VectorXd::LinSpaced(chain.spheres, -half, half);
}

/// Mobility of the whole chain from each sphere's own (diagonal `self`) and the pairs'; per sphere the first
/// `kept` of the pair's motions.
template <class Pair, std::size_t size>
MatrixXd mobility(const RigidChain& chain, const std::array<double, size>& self, const Pair& pair,
                  Index kept) {
  const VectorXd z = centers(chain);
  const Index n = z.size();
  MatrixXd m = MatrixXd::Zero(kept * n, kept * n);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < kept; ++k) m(kept * i + k, kept * i + k) = self[static_cast<std::size_t>(k)];
    for (Index j = 0; j < n && chain.coupling != ChainCoupling::none; ++j) {
      if (i == j) continue;
      const auto action = pair(z(i) - z(j));
      for (Index k = 0; k < kept; ++k) {
        for (Index l = 0; l < kept; ++l) {
          m(kept * i + k, kept * j + l) = action[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
        }
      }
    }
  }
  return m;
}

bool strained(const RigidChain& chain) { return chain.coupling == ChainCoupling::force_torque_stresslet; }

/// Motions across: per sphere (u_y, omega_x) and with stresslets 2 e_yz.
MatrixXd across_mobility(const RigidChain& chain) {
  constexpr std::array<double, 3> self{1, 0.75, 1.8};
  return mobility(chain, self, detail::across_pair, strained(chain) ? 3 : 2);
}

MatrixXd along_mobility(const RigidChain& chain) {
  constexpr std::array<double, 2> self{1, 1.35};
  return mobility(chain, self, detail::along_pair, strained(chain) ? 2 : 1);
}

/// Spins about the line of centers meet nothing but each other: 1/(4 r^3) of torque over 2 pi mu.
MatrixXd spin_mobility(const RigidChain& chain) {
  constexpr std::array<double, 1> self{0.75};
  const auto pair = [](double separation) {
    return std::array<std::array<double, 1>, 1>{{{0.75 / std::pow(std::abs(separation), 3)}}};
  };
  return mobility(chain, self, pair, 1);
}

/// The same motion for every sphere in its row `row` of `kept`.
VectorXd uniform(Index spheres, Index kept, Index row) {
  VectorXd motion = VectorXd::Zero(kept * spheres);
  for (Index i = 0; i < spheres; ++i) motion(kept * i + row) = 1;
  return motion;
}

/// v . (mobility)^-1 v: force for unit velocity
double resistance(const MatrixXd& mobility, const VectorXd& v) { return v.dot(mobility.llt().solve(v)); }

/// Rotation of the chain about x at unit rate: u_y = -z, omega_x = 1, no strain. Forces times this are the
/// torque.
VectorXd rotation(const RigidChain& chain) {
  const Index kept = strained(chain) ? 3 : 2;
  VectorXd motion = uniform(chain.spheres, kept, 1);
  const VectorXd z = centers(chain);
  for (Index i = 0; i < z.size(); ++i) motion(kept * i) = -z(i);
  return motion;
}

/// A chain at rest against the flow of the unit strain rate e_yz: u_y = -z, no rotation, 2 e_yz = -2.
VectorXd strain(const RigidChain& chain) {
  const Index kept = strained(chain) ? 3 : 2;
  VectorXd motion = rotation(chain);
  for (Index i = 0; i < chain.spheres; ++i) {
    motion(kept * i + 1) = 0;
    if (kept == 3) motion(kept * i + 2) = -2;
  }
  return motion;
}

}  // namespace

namespace detail {

std::array<std::array<double, 3>, 3> across_pair(double separation) {
  const double r = std::abs(separation);
  const double r3 = r * r * r;
  const double rotlet = 0.75 * separation / r3;
  const double dipole = 2.4 * separation / (r3 * r * r);
  return {{{0.75 / r + 0.5 / r3, -rotlet, dipole},
           {rotlet, -0.375 / r3, 2.25 / r3},
           {-dipole, 2.25 / r3, (4.5 - 14.4 / (r * r)) / r3}}};
}

std::array<std::array<double, 2>, 2> along_pair(double separation) {
  const double r = std::abs(separation);
  const double r3 = r * r * r;
  const double coupling = (2.25 - 3.6 / (r * r)) * separation / r3;
  return {{{1.5 / r - 1 / r3, coupling}, {-coupling, (-6.75 + 16.2 / (r * r)) / r3}}};
}

}  // namespace detail

double rigid_chain_bretherton(const RigidChain& chain) {
  validate(chain);
  if (chain.spheres == 1) return 0;
  const VectorXd turn = rotation(chain);
  const VectorXd forces = across_mobility(chain).llt().solve(turn);
  // torque free: omega turn.forces + E_yz strain.forces = 0, the mobility being symmetric
  return strain(chain).dot(forces) / turn.dot(forces);
}

double rigid_chain_period(const RigidChain& chain, double rate) {
  validate(chain);
  require_between("spheres", chain.spheres, 2, 500);
  return jeffery_period(equivalent_aspect_ratio(rigid_chain_bretherton(chain)), rate);
}

RigidChainResistance rigid_chain_resistance(const RigidChain& chain) {
  validate(chain);
  const Index n = chain.spheres;
  const Index kept = strained(chain) ? 3 : 2;
  const MatrixXd across = across_mobility(chain);
  // forces are over 6 pi mu R, torques over 6 pi mu R^3
  return {resistance(along_mobility(chain), uniform(n, kept - 1, 0)), resistance(across, uniform(n, kept, 0)),
          0.75 * resistance(across, rotation(chain)),
          0.75 * resistance(spin_mobility(chain), uniform(n, 1, 0))};
}

}  // namespace fiberchain::reference
