#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <cmath>

#include "reference/chain_strains.hpp"
#include "reference/complex_modes.hpp"
#include "reference/errors.hpp"
#include "reference/mode_following.hpp"

namespace fiberchain::reference {
namespace {

using SparseComplex = Eigen::SparseMatrix<std::complex<double>>;

/// One of a bond's motions: every `stride`-th row of the strains from `first` on.
struct BondMotion {
  double spring;
  double dashpot;
  ComplexModulus modulus;
  SparseComplex matrix;  ///< its part of B^T B
  Eigen::Index first;
  Eigen::Index stride;

  /// K (1 + h (k(s) - 1)) + h c s and its derivative by s.
  ModulusValue stiffness(double h, std::complex<double> s) const {
    const ModulusValue k = modulus(s);
    return {spring * (1.0 + h * (k.value - 1.0)) + h * dashpot * s, h * (spring * k.slope + dashpot)};
  }
  auto part(const Eigen::VectorXcd& strain) const {
    return strain(Eigen::seq(first, strain.size() - 1, stride)).array();
  }
};

struct ModeOfChain {
  std::complex<double> s;
  Eigen::VectorXcd u;
};

/// M s^2 + sum of the motions' stiffness(h, s) B^T B, its inverse and its stationary form.
class NonlinearEigenproblem {
 public:
  NonlinearEigenproblem(const detail::ChainStrains& strains, std::vector<BondMotion> motions)
      : strains_(strains), motions_(std::move(motions)) {
    const Eigen::VectorXcd m = strains.inertia.cast<std::complex<double>>();
    mass_ = Eigen::MatrixXcd(m.asDiagonal()).sparseView();
    solver_.analyzePattern(derivative_and_value(1, {1, 1}).value);
  }

  /// Inverse iteration: u from T(s)^-1 T'(s) u, s from u^T T(s) u = 0, which a mode makes stationary.
  std::optional<ModeOfChain> solve(double h, const ModeOfChain& from) {
    ModeOfChain mode = from;
    for (int i = 0; i < 30; ++i) {
      set_shape_from_inverse(h, mode);
      const auto root = stationary_root(h, mode);
      if (!root) return std::nullopt;
      const double change = std::abs(*root - mode.s);
      mode.s = *root;
      // the shape's error is the root of the eigenvalue's: this change is the last but one
      if (change <= 1e-10 * std::abs(mode.s)) return same(from, mode) ? std::optional(mode) : std::nullopt;
    }
    return std::nullopt;
  }

  /// K''/(2 K') at |s|, the motions weighted by |strain|^2.
  double half_loss(const ModeOfChain& mode) const {
    const Eigen::VectorXcd strain = strains_.b * mode.u;
    std::complex<double> sum = 0;
    for (const BondMotion& each : motions_) {
      sum += each.stiffness(1, {0, std::abs(mode.s)}).value * each.part(strain).abs2().sum();
    }
    return sum.imag() / (2 * sum.real());
  }

 private:
  struct MatrixPair {
    SparseComplex value, slope;
  };

  MatrixPair derivative_and_value(double h, std::complex<double> s) const {
    MatrixPair t{s * s * mass_, 2.0 * s * mass_};
    for (const BondMotion& each : motions_) {
      const ModulusValue k = each.stiffness(h, s);
      t.value = SparseComplex(t.value + k.value * each.matrix);
      t.slope = SparseComplex(t.slope + k.slope * each.matrix);
    }
    return t;
  }

  void set_shape_from_inverse(double h, ModeOfChain& mode) {
    const MatrixPair t = derivative_and_value(h, mode.s);
    solver_.factorize(t.value);
    if (solver_.info() != Eigen::Success) return;  // singular to the last digit: s and u are the mode
    const Eigen::VectorXcd next = solver_.solve(Eigen::VectorXcd(t.slope * mode.u));
    if (next.allFinite()) mode.u = next.normalized();
  }

  std::optional<std::complex<double>> stationary_root(double h, const ModeOfChain& mode) const {
    const Eigen::VectorXcd strain = strains_.b * mode.u;
    const auto square = [](const auto& v) { return v.square().sum(); };
    const std::complex<double> m =
        (strains_.inertia.cast<std::complex<double>>().array() * mode.u.array().square()).sum();
    return detail::complex_newton(
        [&](std::complex<double> s) {
          ModulusValue p{m * s * s, 2.0 * m * s};
          for (const BondMotion& each : motions_) {
            const ModulusValue k = each.stiffness(h, s);
            const std::complex<double> e = square(each.part(strain));
            p.value += k.value * e;
            p.slope += k.slope * e;
          }
          return p;
        },
        mode.s);
  }

  /// Neither far in frequency nor of another shape (in the norm of the masses).
  bool same(const ModeOfChain& a, const ModeOfChain& b) const {
    const auto product = [&](const Eigen::VectorXcd& x, const Eigen::VectorXcd& y) {
      return std::abs(x.dot(strains_.inertia.asDiagonal() * y));
    };
    const double overlap = product(a.u, b.u) / std::sqrt(product(a.u, a.u) * product(b.u, b.u));
    return detail::continues(a.s, b.s) && overlap > 0.9;
  }

  const detail::ChainStrains& strains_;
  std::vector<BondMotion> motions_;
  SparseComplex mass_;
  Eigen::SparseLU<SparseComplex> solver_;
};

BondMotion bond_motion(const detail::ChainStrains& strains, const ComplexModulus& modulus, Eigen::Index first,
                       Eigen::Index stride) {
  const Eigen::MatrixXd rows = strains.b(Eigen::seq(first, strains.b.rows() - 1, stride), Eigen::all);
  const Eigen::SparseMatrix<double> b = rows.sparseView();
  return {strains.spring(first),
          strains.dashpot(first),
          modulus,
          SparseComplex(Eigen::SparseMatrix<double>(b.transpose() * b).cast<std::complex<double>>()),
          first,
          stride};
}

std::vector<BondMotion> bond_motions(const detail::ChainStrains& strains, const BondModuli& moduli,
                                     ChainMotion motion) {
  if (motion == ChainMotion::axial) return {bond_motion(strains, moduli.stretch, 0, 1)};
  if (motion == ChainMotion::twist) return {bond_motion(strains, moduli.twist, 0, 1)};
  return {bond_motion(strains, moduli.shear, 0, 2), bond_motion(strains, moduli.bend, 1, 2)};
}

/// The lowest modes of M s^2 + B^T diag(K) B, those of a rigid body left out.
std::vector<ModeOfChain> elastic_modes(const detail::ChainStrains& strains, int count) {
  const Eigen::VectorXd scale = strains.inertia.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd s = strains.spring.cwiseSqrt().asDiagonal() * strains.b * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(s.transpose() * s);
  if (solver.info() != Eigen::Success) throw NoConvergence("elastic modes of the linear chain");
  std::vector<ModeOfChain> modes;
  for (Eigen::Index i = strains.rigid_motions; i < strains.rigid_motions + count; ++i) {
    const Eigen::VectorXd u = scale.cwiseProduct(solver.eigenvectors().col(i));
    modes.push_back({{0, std::sqrt(solver.eigenvalues()(i))}, u.normalized().cast<std::complex<double>>()});
  }
  return modes;
}

}  // namespace

BondModuli bond_moduli(const BondSpectra& spectra) {
  return {complex_modulus(spectra.stretch), complex_modulus(spectra.shear), complex_modulus(spectra.twist),
          complex_modulus(spectra.bend)};
}

std::vector<ComplexChainMode> complex_chain_modes(const LinearChain& chain, const BondModuli& moduli,
                                                  ChainMotion motion, ChainEnds ends, int count) {
  validate(chain);
  require_between("bonds (complex modes)", chain.bonds, 1, 300);
  const detail::ChainStrains strains = detail::chain_strains(chain, motion, ends);
  require_between("count", count, 1, static_cast<double>(strains.inertia.size() - strains.rigid_motions));
  NonlinearEigenproblem problem(strains, bond_motions(strains, moduli, motion));
  const auto solve = [&](double h, const ModeOfChain& from) { return problem.solve(h, from); };
  std::vector<ComplexChainMode> modes;
  for (const ModeOfChain& elastic : elastic_modes(strains, count)) {
    const ModeOfChain mode = detail::follow(elastic, solve, "complex mode of the linear chain");
    detail::SphereShape shape = detail::sphere_shape(mode.u, motion, ends);
    modes.push_back({detail::free_decay(mode.s, problem.half_loss(mode)), true, std::move(shape.displacement),
                     std::move(shape.rotation)});
  }
  return modes;
}

}  // namespace fiberchain::reference
