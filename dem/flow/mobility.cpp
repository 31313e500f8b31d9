#include "dem/flow/mobility.hpp"

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "dem/flow/pair_mobility.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Of the six motions of a sphere in space those that a fiber of this dimension has.
template <int Dim>
constexpr std::array<int, sphere_motions<Dim>> kept_motions() {
  if constexpr (Dim == 2) {
    return {0, 1, 5};
  } else {
    return {0, 1, 2, 3, 4, 5};
  }
}

/// R, and the factor 1 / (8 pi mu) with it.
struct Scale {
  double radius, factor;
};

/// Powers of R that a motion carries: a velocity by a force goes with 1/R, every spin or moment with 1/R
/// more.
template <int Dim>
double power(const Scale& scale, int row, int column) {
  const int angular = (row >= Dim) + (column >= Dim);
  return scale.factor / std::pow(scale.radius, 1 + angular);
}

template <int Dim>
pair::Line line(const Poses<Dim>& poses, int i, int j, double radius) {
  pair::Vector r = pair::Vector::Zero();
  for (int c = 0; c < Dim; ++c) r[c] = (poses[i].position[c] - poses[j].position[c]) / radius;
  const double length = r.norm();
  if (length > 0) return {length, r / length};
  return {0, pair::Vector::UnitX()};  // on top of each other: no direction enters there
}

using PairBlock = Eigen::Matrix<double, 6, 6>;

PairBlock pair_block(const pair::Line& l) {
  const pair::Matrix coupling = pair::translation_by_torque(l);
  PairBlock block;
  block << pair::translation_by_force(l), coupling, coupling, pair::spin_by_torque(l);
  return block;
}

using DipoleBlock = Eigen::Matrix<double, 6, 5>;

DipoleBlock motion_by_dipoles(const pair::Line& l, const std::array<pair::Matrix, 5>& basis) {
  DipoleBlock block;
  for (int k = 0; k < 5; ++k)
    block.col(k) << pair::translation_by_dipole(l, basis[k]), pair::spin_by_dipole(l, basis[k]);
  return block;
}

template <int Dim>
Eigen::MatrixXd motions_by_forces(const Poses<Dim>& poses, const Scale& scale) {
  constexpr int m = sphere_motions<Dim>;
  constexpr auto kept = kept_motions<Dim>();
  const int n = static_cast<int>(poses.size());
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n * m, n * m);
  for (int i = 0; i < n; ++i) {
    for (int a = 0; a < m; ++a) {
      M(i * m + a, i * m + a) = power<Dim>(scale, a, a) * (a < Dim ? pair::own_translation : pair::own_spin);
    }
    for (int j = 0; j < i; ++j) {
      const PairBlock block = pair_block(line(poses, i, j, scale.radius));
      for (int a = 0; a < m; ++a) {
        for (int b = 0; b < m; ++b) {
          M(i * m + a, j * m + b) = M(j * m + b, i * m + a) =
              power<Dim>(scale, a, b) * block(kept[a], kept[b]);
        }
      }
    }
  }
  return M;
}

void check_apart(double gap, int i, int j) {
  if (gap >= 1.8) return;
  throw Diverged(fmt::format(
      "spheres {} and {} are {:.3g} R apart: stresslets are for spheres that do not overlap; likely "
      "cause: a fiber that folds onto itself, or bonds too soft for the flow",
      j, i, gap));
}

/// Adds what the stresslets do that keep the spheres rigid: S = -strains^-1 (E + motions^T F).
template <int Dim>
void add_stresslets(const Poses<Dim>& poses, const Scale& scale, Mobility& mobility) {
  constexpr int m = sphere_motions<Dim>;
  constexpr auto kept = kept_motions<Dim>();
  const auto basis = pair::strain_basis();
  const int n = static_cast<int>(poses.size());
  const double R = scale.radius, by_strain = scale.factor / (R * R * R);
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(n * m, n * 5),
                  strains = Eigen::MatrixXd::Zero(n * 5, n * 5);
  strains.diagonal().setConstant(pair::own_strain * by_strain);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      const pair::Line l = line(poses, i, j, R);
      check_apart(l.r, i, j);
      const DipoleBlock block = motion_by_dipoles(l, basis);
      for (int a = 0; a < m; ++a) {
        const double size = scale.factor / std::pow(R, a < Dim ? 2 : 3);
        // the other way round e turns, and with it what is odd in e
        motions.block<1, 5>(i * m + a, j * 5) = size * block.row(kept[a]);
        motions.block<1, 5>(j * m + a, i * 5) = (a < Dim ? -size : size) * block.row(kept[a]);
      }
      for (int k = 0; k < 5; ++k) {
        const pair::Matrix E = by_strain * pair::strain_by_dipole(l, basis[k]);
        for (int h = 0; h < 5; ++h) {
          strains(i * 5 + h, j * 5 + k) = strains(j * 5 + k, i * 5 + h) = E.cwiseProduct(basis[h]).sum();
        }
      }
    }
  }
  const Eigen::MatrixXd kept_rigid = strains.llt().solve(motions.transpose());  // strains^-1 motions^T
  mobility.motion.noalias() -= motions * kept_rigid;
  mobility.strain = Eigen::MatrixXd::Zero(n * m, 5);
  for (int j = 0; j < n; ++j) mobility.strain -= kept_rigid.middleRows(j * 5, 5).transpose();
}

}  // namespace

Eigen::Matrix<double, 5, 1> strain_components(const Gradient& A) {
  pair::Matrix gradient;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) gradient(i, j) = A[i][j];
  }
  Eigen::Matrix<double, 5, 1> components;
  const auto basis = pair::strain_basis();
  for (int k = 0; k < 5; ++k) components[k] = gradient.cwiseProduct(basis[k]).sum();
  return components;
}

template <int Dim>
Mobility mobility(const Fluid& fluid, double radius, const Poses<Dim>& poses) {
  const Scale scale{radius, 1 / (8 * std::numbers::pi * fluid.viscosity)};
  Mobility result{motions_by_forces<Dim>(poses, scale),
                  Eigen::MatrixXd(poses.size() * sphere_motions<Dim>, 0)};
  if (fluid.hydrodynamics == Hydrodynamics::stresslets) add_stresslets<Dim>(poses, scale, result);
  return result;
}

template Mobility mobility<2>(const Fluid&, double, const Poses<2>&);
template Mobility mobility<3>(const Fluid&, double, const Poses<3>&);

}  // namespace fiberchain::dem
