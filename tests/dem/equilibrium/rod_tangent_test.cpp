// The tangent of a rod against differences of what is out of balance: every kind of load and of support.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/equilibrium/rod_supports.hpp"
#include "tests/dem/equilibrium/rods.hpp"

BOOST_AUTO_TEST_SUITE(rod_tangent_test)

using namespace fiberchain::dem;
using namespace fiberchain::dem::test;

namespace {

constexpr int kBonds = 6;
constexpr double kFactor = 0.7;

/// One of every support and load, in one rod.
RodProblem everything(BondModel bond, LineLoads rule) {
  std::mt19937 numbers(5);
  const Fiber fiber = rod_fiber(kBonds, bond);
  RodProblem problem{.chain = cornered_chain<3>(fiber, 2), .line_load_rule = rule};
  const double P = load_force(fiber, 2.3), L = fiber_length(fiber);
  const Quaternion<double> axes = rotation({0.3, -0.5, 0.9});
  problem.supports = {
      {.sphere = 0, .axes = axes, .moved = random_vector(numbers, 0.1 * L), .turned = {0.2, 0.5, -0.3}},
      {.sphere = 2,
       .hold_displacement = {true, false, true},
       .hold_rotation = {false, true, true},
       .axes = axes},
      {.sphere = 4,
       .hold_displacement = {false, true, false},
       .hold_rotation = {true, false, false},
       .axes = axes,
       .moved = random_vector(numbers, 0.1 * L)},
      {.sphere = 6, .hold_displacement = {false, true, false}, .hold_rotation = {false, false, false}}};
  for (const auto direction : {LoadDirection::dead, LoadDirection::following}) {
    for (const int sphere : {2, 3, 4, 6}) {
      problem.point_loads.push_back({.sphere = sphere,
                                     .force = random_vector(numbers, P),
                                     .moment = random_vector(numbers, P * L),
                                     .direction = direction,
                                     .steady = sphere == 3});
    }
    problem.line_loads.push_back(
        {.first = 1, .last = 5, .force = random_vector(numbers, P / L), .direction = direction});
  }
  problem.gravity = random_vector(numbers, P / fiber_mass(fiber));
  return problem;
}

/// Any poses that the supports allow: the universal joint's turns are its own.
Poses<3> some_poses(const RodProblem& problem) {
  std::mt19937 numbers(8);
  Poses<3> poses = problem.chain.poses;
  const double l = bond_length(problem.chain.fiber);
  for (auto& pose : poses) {
    pose.position = pose.position + random_vector(numbers, 0.05 * l);
    pose.orientation = rotation(random_vector(numbers, 0.4)) * pose.orientation;
  }
  const Quaternion<double> axes = problem.supports[2].axes;
  poses[4].orientation = rotation(rotate(axes, Vec<double, 3>{0, 0.4, 0})) *
                         rotation(rotate(axes, Vec<double, 3>{0, 0, -0.7})) *
                         problem.chain.poses[4].orientation;
  return poses;
}

Poses<3> nudged(Poses<3> poses, std::size_t sphere, const SphereVector<3>& motion) {
  poses[sphere].position = poses[sphere].position + displacement_part<3>(motion);
  turn_by_vector(poses[sphere].orientation, rotation_part<3>(motion));
  return poses;
}

SphereVector<3> entry(const ChainTangent<3>& K, std::size_t row, std::size_t column, int k) {
  if (row == column) return K.diagonal[row].col(k);
  if (row == column + 1) return K.lower[row].col(k);
  if (row + 1 == column) return K.upper[row].col(k);
  return SphereVector<3>::Zero();
}

/// Largest difference of the free rows, force and moments each over their own size.
double worst(const SphereVector<3>& difference, const HeldSphere& held, double force, double moment) {
  double worst = 0;
  for (int k = 0; k < 6; ++k) {
    if (held.held[static_cast<std::size_t>(k)]) continue;
    worst = std::max(worst, std::abs(difference[k]) / (k < 3 ? force : moment));
  }
  return worst;
}

void check_tangent(BondModel bond, LineLoads rule) {
  const RodProblem problem = everything(bond, rule);
  const Poses<3> start = problem.chain.poses, poses = some_poses(problem);
  const RodSystem system = rod_system(problem, start, poses, kFactor);
  const BondStiffness stiff = bond_stiffness(problem.chain.fiber);
  const double l = bond_length(problem.chain.fiber);
  double found = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    for (int k = 0; k < 6; ++k) {
      if (system.held[j].held[static_cast<std::size_t>(k)]) continue;
      const double eps = 1e-5 * (k < 3 ? l : 1.0), unit = k < 3 ? 1.0 : l;
      const SphereVector<3> way = eps * system.held[j].directions.col(k);
      const auto ahead = rod_system(problem, start, nudged(poses, j, way), kFactor).unbalanced;
      const auto behind = rod_system(problem, start, nudged(poses, j, -way), kFactor).unbalanced;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const SphereVector<3> slope = (ahead[i] - behind[i]) / (-2 * eps);
        found = std::max(found, worst(slope - entry(system.K, i, j, k), system.held[i], stiff.stretch * unit,
                                      stiff.stretch * l * unit));
      }
    }
  }
  BOOST_TEST(found < 1e-9);
  const double step = 1e-4;
  const auto more = rod_system(problem, start, poses, kFactor + step),
             less = rod_system(problem, start, poses, kFactor - step);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SphereVector<3> slope = (more.unbalanced[i] - less.unbalanced[i]) / (2 * step);
    const double P = load_force(problem.chain.fiber, 1), L = fiber_length(problem.chain.fiber);
    const SphereVector<3> difference = slope + system.by_factor[i];
    for (int k = 0; k < 6; ++k) {
      const double unit = system.held[i].held[static_cast<std::size_t>(k)] ? (k < 3 ? L : 1.0)
                          : k < 3                                          ? P
                                                                           : P * L;
      // a prescribed turn's own error: its rate is exact where the sphere has got to
      if (i == 0 && k > 2) continue;
      BOOST_TEST(std::abs(difference[k]) < 1e-8 * unit, "sphere " << i << " motion " << k);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(tangent_is_the_derivative_of_what_is_out_of_balance) {
  check_tangent(BondModel::paper, LineLoads::lumped);
  check_tangent(BondModel::corrected, LineLoads::consistent);
}

BOOST_AUTO_TEST_CASE(without_a_potential_the_tangent_is_unsymmetric_and_with_one_symmetric_at_equilibrium) {
  const Fiber fiber = rod_fiber(7);
  RodProblem problem{.chain = straight_chain<3>(fiber)};
  problem.supports = {
      {.sphere = 0, .hold_rotation = {true, false, false}},
      {.sphere = 7, .hold_displacement = {false, true, true}, .hold_rotation = {false, true, true}}};
  const double P = load_force(fiber, 3.0);
  problem.point_loads = {{.sphere = 3, .force = {0, P, 0.4 * P}}, {.sphere = 7, .force = {P, 0, 0}}};
  problem.gravity = {0, 0, 2 * P / fiber_mass(fiber)};
  const auto asymmetry = [&] {
    const RodPoint point = solve_rod(problem);
    const ChainTangent<3> K =
        held_tangent(problem, rod_system(problem, problem.chain.poses, point.poses, 1), 0);
    double largest = 0;
    for (std::size_t i = 0; i < point.poses.size(); ++i) {
      largest = std::max(largest, (K.diagonal[i] - K.diagonal[i].transpose()).cwiseAbs().maxCoeff());
    }
    return largest / bond_stiffness(fiber).bend;
  };
  BOOST_TEST(has_potential(problem));
  BOOST_TEST(asymmetry() < 1e-7);
  problem.point_loads.push_back({.sphere = 5, .moment = {0, 0, P * bond_length(fiber)}});
  BOOST_TEST(!has_potential(problem));
  BOOST_TEST(asymmetry() > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
