#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "reference/chain_strains.hpp"
#include "reference/complex_modes.hpp"
#include "reference/errors.hpp"
#include "reference/mode_following.hpp"

namespace fiberchain::reference {
namespace {

/// The spectrum of a row of the strains.
const PronySeries& spectrum_of_row(const BondSpectra& spectra, ChainMotion motion, Eigen::Index row) {
  if (motion == ChainMotion::axial) return spectra.stretch;
  if (motion == ChainMotion::twist) return spectra.twist;
  return row % 2 == 0 ? spectra.shear : spectra.bend;
}

/// One branch's spring of one row.
struct BranchUnknown {
  Eigen::Index row;
  PronyTerm term;
};

std::vector<BranchUnknown> branch_unknowns(const BondSpectra& spectra, ChainMotion motion,
                                           Eigen::Index rows) {
  std::vector<BranchUnknown> all;
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (const PronyTerm& term : spectrum_of_row(spectra, motion, row)) {
      if (term.strength > 0) all.push_back({row, term});
    }
  }
  return all;
}

/// First-order form in scaled strains, strains of the branches' springs x' = B u' - x/tau, and velocities,
/// z = (sqrt(K) B u, sqrt(g K) x, sqrt(M) u'), S = sqrt(K) B/sqrt(M): skew but for the decays -1/tau and
/// the dashpots.
Eigen::MatrixXd branched_first_order(const detail::ChainStrains& strains,
                                     const std::vector<BranchUnknown>& branches) {
  const Eigen::Index e = strains.spring.size();
  const Eigen::Index x = static_cast<Eigen::Index>(branches.size());
  const Eigen::Index u = strains.inertia.size();
  const Eigen::MatrixXd s = strains.spring.cwiseSqrt().asDiagonal() * strains.b *
                            strains.inertia.cwiseSqrt().cwiseInverse().asDiagonal();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(e + x + u, e + x + u);
  a.topRightCorner(e, u) = s;
  for (Eigen::Index j = 0; j < x; ++j) {
    const BranchUnknown& branch = branches[static_cast<std::size_t>(j)];
    a(e + j, e + j) = -1 / branch.term.time;
    a.row(e + j).tail(u) = std::sqrt(branch.term.strength) * s.row(branch.row);
  }
  a.bottomLeftCorner(u, e + x) = -a.topRightCorner(e + x, u).transpose();
  a.bottomRightCorner(u, u) = -s.transpose() * strains.dashpot.cwiseQuotient(strains.spring).asDiagonal() * s;
  return a;
}

/// As of complex_chain_modes: K''/(2 K') at omega, rows weighted by |strain|^2.
double half_loss_of_rows(const detail::ChainStrains& strains, const std::vector<BranchUnknown>& branches,
                         const Eigen::VectorXcd& u, double omega) {
  const Eigen::VectorXd weight = (strains.b * u).cwiseAbs2();
  double storage = weight.dot(strains.spring);
  double loss = omega * weight.dot(strains.dashpot);
  for (const BranchUnknown& branch : branches) {
    const double x = omega * branch.term.time;
    const double part =
        weight(branch.row) * strains.spring(branch.row) * branch.term.strength * x / (1 + x * x);
    storage += x * part;
    loss += part;
  }
  return loss / (2 * storage);
}

std::vector<Eigen::Index> lowest_first(const Eigen::VectorXcd& values, int left_out) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < values.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return std::abs(values(a)) < std::abs(values(b)); });
  order.erase(order.begin(), order.begin() + left_out);
  return order;
}

}  // namespace

std::vector<ComplexChainMode> all_complex_chain_modes(const LinearChain& chain, const BondSpectra& spectra,
                                                      ChainMotion motion, ChainEnds ends) {
  validate(chain);
  for (const PronySeries* each : {&spectra.stretch, &spectra.shear, &spectra.twist, &spectra.bend}) {
    validate(*each);
  }
  require_between("bonds (linearized modes)", chain.bonds, 1, 300);
  const detail::ChainStrains strains = detail::chain_strains(chain, motion, ends);
  const std::vector<BranchUnknown> branches = branch_unknowns(spectra, motion, strains.spring.size());
  const double unknowns = static_cast<double>(strains.spring.size() + strains.inertia.size()) +
                          static_cast<double>(branches.size());
  require_between("unknowns (linearized modes)", unknowns, 1, 2000);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(branched_first_order(strains, branches));
  if (solver.info() != Eigen::Success) throw NoConvergence("linearized modes of the chain");

  const Eigen::VectorXd scale = strains.inertia.cwiseSqrt().cwiseInverse();
  std::vector<ComplexChainMode> modes;
  for (const Eigen::Index i : lowest_first(solver.eigenvalues(), strains.rigid_motions)) {
    const std::complex<double> s = solver.eigenvalues()(i);
    if (s.imag() < 0) continue;
    const Eigen::VectorXcd u = scale.asDiagonal() * solver.eigenvectors().col(i).tail(scale.size());
    FreeDecay decay = detail::free_decay(s, half_loss_of_rows(strains, branches, u, std::abs(s)));
    const bool oscillates = s.imag() > 0;
    if (!oscillates) decay.half_loss_factor = decay.difference = 0;
    detail::SphereShape shape = detail::sphere_shape(u, motion, ends);
    modes.push_back({decay, oscillates, std::move(shape.displacement), std::move(shape.rotation)});
  }
  return modes;
}

}  // namespace fiberchain::reference
