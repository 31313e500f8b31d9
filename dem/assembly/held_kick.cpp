#include "dem/assembly/held_kick.hpp"

#include "dem/chain/block_tridiagonal.hpp"
#include "dem/motion/implicit_kick.hpp"

namespace fiberchain::dem {
namespace {

using Matrix = BlockTridiagonal<6>;
using Vectors = std::vector<Matrix::Vector>;

constexpr Physics solved_bonds{.dimension = 3,
                               .form = BondForm::total,
                               .damped = true,
                               .settling_damping = false,
                               .curved = false,
                               .solved = Solved::bonds};

const SphereStep<double>& step_of(const GroupKind& kind, int sphere) {
  const bool is_end = sphere == 0 || sphere + 1 == kind.spheres();
  return is_end ? kind.parameters.end : kind.parameters.inner;
}

void add(Matrix::Block& block, const Square<double, 6>& more) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) block(i, j) += more[i][j];
  }
}

Matrix matrix_of(const GroupKind& kind, const std::vector<MovingSphere<double, 3>>& spheres,
                 KickMatrix matrix, const std::vector<double>& parts) {
  Matrix A(kind.spheres());
  for (int i = 0; i < kind.spheres(); ++i) {
    const Vec<double, 6> inertias = inertias_of(kind.parameters, step_of(kind, i));
    for (int c = 0; c < 6; ++c) A.diagonal[i](c, c) = inertias[c];
  }
  if (matrix == KickMatrix::masses) return A;
  MarchParameters<double, 3> p = kind.parameters;
  BondParameters<double>& bond = p.bond;
  if (matrix == KickMatrix::springs)
    bond.dash_stretch = bond.dash_shear = bond.dash_twist = bond.dash_bend = 0;
  const BondParameters<double> law = solved_dashpots<solved_bonds, double>(p);
  for (int i = 0; i + 1 < kind.spheres(); ++i) {
    auto between = bond_matrix<solved_bonds, double>(p, law, spheres[i], spheres[i + 1]);
    if (parts[i] < 1) scale(between, parts[i]);
    add(A.diagonal[i], between.first);
    add(A.diagonal[i + 1], between.second);
    add(A.upper[i], between.coupling);
    A.lower[i + 1] = A.upper[i].transpose();
  }
  return A;
}

/// Takes a component that is given out of the system: its column to the right-hand side, its row to an
/// identity.
void fix(Matrix& A, Vectors& b, int sphere, int c, double value) {
  const auto take = [&](Matrix::Block& block, int row) {
    b[row] -= value * block.col(c);
    block.col(c).setZero();
  };
  take(A.diagonal[sphere], sphere);
  A.diagonal[sphere].row(c).setZero();
  A.diagonal[sphere](c, c) = 1;
  if (sphere > 0) {
    take(A.upper[sphere - 1], sphere - 1);
    A.lower[sphere].row(c).setZero();
  }
  if (sphere + 1 < A.blocks()) {
    take(A.lower[sphere + 1], sphere + 1);
    A.upper[sphere].row(c).setZero();
  }
  b[sphere](c) = value;
}

}  // namespace

std::vector<double> bond_parts(const GroupKind& kind, const double* histories, int lane) {
  std::vector<double> parts(static_cast<std::size_t>(kind.chain.fiber.aspect_ratio), 1);
  if (kind.law->failure_place < 0) return parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] =
        kind.history_of(histories, lane, static_cast<int>(i))[kind.law->intact_place * kind.kernel->width];
  return parts;
}

HeldKick held_kick(const GroupKind& kind, const std::vector<MovingSphere<double, 3>>& spheres,
                   const std::vector<HeldChange>& held, KickMatrix matrix, const std::vector<double>& parts) {
  const double dt = kind.parameters.step;
  const Matrix whole = matrix_of(kind, spheres, matrix, parts);
  Vectors forces(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      forces[i](c) = dt * spheres[i].force[c];
      forces[i](3 + c) = dt * spheres[i].moment[c];
    }
  }
  Matrix A = whole;
  Vectors change = forces;
  for (const HeldChange& one : held) {
    for (int c = 0; c < 6; ++c) {
      if (one.is[c]) fix(A, change, one.sphere, c, one.change[c]);
    }
  }
  for (const HeldChange& one :
       held) {  // the right-hand side of a fixed row is its value, whatever came after
    for (int c = 0; c < 6; ++c) {
      if (one.is[c]) change[one.sphere](c) = one.change[c];
    }
  }
  solve_in_place(A, change);
  const Vectors taken = product(whole, change);
  HeldKick kick{std::vector<SixNumbers>(spheres.size()), std::vector<SixNumbers>(spheres.size())};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (int c = 0; c < 6; ++c) kick.change[i][c] = change[i](c);
  }
  for (const HeldChange& one : held) {
    for (int c = 0; c < 6; ++c) {
      if (one.is[c]) kick.impulse[one.sphere][c] = taken[one.sphere](c) - forces[one.sphere](c);
    }
  }
  return kick;
}

}  // namespace fiberchain::dem
