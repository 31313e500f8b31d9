// Paths of rods: through limit points, onto branches; turned or numbered otherwise they are the same.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/dem/equilibrium/rods.hpp"

BOOST_AUTO_TEST_SUITE(rod_path_test)

using namespace fiberchain::dem;
using namespace fiberchain::dem::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// An arch of an angle [rad] between hinges, pushed down at its top by P R^2 / (E I) = `load`.
RodProblem arch(int bonds, double angle, double load) {
  Fiber fiber = rod_fiber(bonds);
  fiber.rest_angle = -angle / bonds;
  // from -angle/2 on both sides of the y axis
  RodProblem problem{.chain = placed(arc_rod(fiber), rotation({0, 0, angle / 2}), {}), .planar = true};
  problem.supports = {hinge_about_z(0), hinge_about_z(bonds)};
  const double radius = fiber_length(fiber) / angle;
  problem.point_loads = {
      {.sphere = bonds / 2, .force = {0, -load * bending_stiffness(fiber) / (radius * radius), 0}}};
  return problem;
}

RodPath snap(const RodProblem& problem, int points = 60) {
  const int top = problem.chain.fiber.aspect_ratio / 2;
  const double rise = problem.chain.poses[static_cast<std::size_t>(top)].position[1];
  return trace_rod(problem, {.points = points,
                             .most_points = 2000,
                             .end_displacement = 2.3 * rise,
                             .probe = {top, {0, -1, 0}},
                             .largest_step = 2.0 / points});
}

/// A rod in space with a bit of everything that has a direction.
RodProblem skew_rod(BondModel bond) {
  const Fiber fiber = rod_fiber(16, bond);
  const double l = bond_length(fiber), P = load_force(fiber, 2.7), L = fiber_length(fiber);
  const Vec<double, 3> a{3 * l, 4 * l, 0}, b{3 * l, 4 * l, 6 * l}, c{3 * l, 9 * l, 6 * l};
  RodProblem problem{.chain = rod_through(fiber, {{0, 0, 0}, a, b, c})};
  problem.supports = {
      {.sphere = 0, .turned = {0, 0.4, 0.2}},
      {.sphere = 7, .hold_displacement = {false, true, false}, .hold_rotation = {true, false, false}}};
  problem.point_loads = {{.sphere = 16, .force = {P, 0.3 * P, -0.2 * P}, .moment = {0, 0.1 * P * L, 0}},
                         {.sphere = 9, .force = {0, P, 0}, .direction = LoadDirection::following}};
  problem.line_loads = {
      {.first = 2, .last = 13, .force = {0, P / L, 0.4 * P / L}, .direction = LoadDirection::following}};
  problem.gravity = {0, 0, -P / fiber_mass(fiber)};
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_rod_turned_as_a_whole_has_the_turned_equilibrium) {
  const Quaternion<double> q = rotation({0.7, -1.9, 0.4});
  const Vec<double, 3> moved{0.2, -0.1, 0.4};
  for (const BondModel bond : {BondModel::paper, BondModel::corrected}) {
    const RodProblem problem = skew_rod(bond);
    RodProblem other = problem;
    other.chain = placed(problem.chain, q, moved);
    for (RodSupport& support : other.supports) {
      support.axes = q * support.axes;
      support.turned = rotate(q, support.turned);
    }
    other.point_loads[0].force = rotate(q, other.point_loads[0].force);
    other.point_loads[0].moment = rotate(q, other.point_loads[0].moment);
    other.gravity = rotate(q, other.gravity);
    const RodPoint here = solve_rod(problem), there = solve_rod(other);
    const double L = fiber_length(problem.chain.fiber);
    BOOST_TEST(tip_distance(here.poses, problem.chain.poses) > 0.2 * L);
    for (std::size_t i = 0; i < here.poses.size(); ++i) {
      BOOST_TEST(norm(rotate(q, here.poses[i].position) + moved - there.poses[i].position) < 1e-9 * L);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_frame_numbered_from_its_other_end_has_the_same_path) {
  const Fiber fiber = rod_fiber(20);
  const double P = load_force(fiber, 14);
  RodProblem frame{.chain = cornered_chain<3>(fiber, 8), .planar = true};
  frame.supports = {hinge_about_z(0), hinge_about_z(20)};
  frame.point_loads = {{.sphere = 11, .force = {P, 0, 0}}};
  RodProblem other = frame;
  other.chain = renumbered(frame.chain);
  other.point_loads[0].sphere = 9;
  RodPathOptions options{.control = RodControl::displacement,
                         .points = 30,
                         .end_displacement = 0.3 * fiber_length(fiber),
                         .probe = {11, {1, 0, 0}}};
  const RodPath path = trace_rod(frame, options);
  options.probe.sphere = 9;
  const RodPath reversed = trace_rod(other, options);
  BOOST_REQUIRE(path.points.size() == reversed.points.size());
  BOOST_REQUIRE(path.singular.size() == reversed.singular.size());
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    BOOST_TEST(std::abs(path.points[i].factor - reversed.points[i].factor) < 1e-9);
    BOOST_TEST(path.points[i].elastic_energy == reversed.points[i].elastic_energy,
               boost::test_tools::tolerance(1e-8));
    BOOST_TEST(path.points[i].negative == reversed.points[i].negative);
  }
}

BOOST_AUTO_TEST_CASE(an_arch_snaps_through_two_limit_points_and_two_bifurcations) {
  const RodProblem problem = arch(26, 0.5, 150);
  const RodPath path = snap(problem);
  std::vector<SingularPoint> limits, bifurcations;
  for (const SingularPoint& s : path.singular) {
    (s.kind == SingularKind::limit_point ? limits : bifurcations).push_back(s);
  }
  BOOST_REQUIRE(limits.size() == 2u);
  BOOST_TEST(limits[0].point.factor > limits[1].point.factor);
  BOOST_TEST(limits[0].crossing == 1);
  BOOST_TEST(limits[1].crossing == -1);
  // a shallow arch: sideways first
  BOOST_REQUIRE(bifurcations.size() == 2u);
  BOOST_TEST(bifurcations[0].point.factor < limits[0].point.factor);
  BOOST_TEST(name(path.points.front().stability) == "stable");
  BOOST_TEST(name(path.points.back().stability) == "stable");
  // the limit is the largest load factor of finer paths
  const RodPath fine = snap(problem, 400);
  double largest = 0;
  for (const RodPoint& point : fine.points) {
    if (point.arc < limits[1].point.arc) largest = std::max(largest, point.factor);
  }
  BOOST_TEST(largest <= limits[0].point.factor * (1 + 1e-9));
  BOOST_TEST(largest > limits[0].point.factor * (1 - 1e-3));
}

BOOST_AUTO_TEST_CASE(energy_is_the_work_of_the_load_along_the_path) {
  const RodProblem problem = arch(26, 0.5, 150);
  const double P = norm(problem.point_loads[0].force);
  double before = 0;
  for (const int points : {200, 400}) {
    const RodPath path = snap(problem, points);
    double work = 0, worst = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const RodPoint &a = path.points[i - 1], &b = path.points[i];
      work += 0.5 * P * (a.factor + b.factor) * (b.probe - a.probe);
      worst = std::max({worst, std::abs(b.elastic_energy - work), std::abs(b.work - work)});
    }
    worst /= path.points.back().elastic_energy;
    BOOST_TEST(worst < 1e-3);
    if (before > 0) BOOST_TEST(worst < before / 3.5);  // trapezoids: second order
    before = worst;
  }
}

BOOST_AUTO_TEST_CASE(a_buckled_columns_branch_is_an_elastica) {
  const Fiber fiber = rod_fiber(40);
  const double L = fiber_length(fiber), euler = bending_stiffness(fiber) * kPi * kPi / (L * L);
  RodProblem column{.chain = straight_chain<3>(fiber), .planar = true};
  column.supports = {hinge_about_z(0), hinge_about_z(40, {false, true, true})};
  column.point_loads = {{.sphere = 40, .force = {-1.2 * euler, 0, 0}}};
  const RodPath path = trace_rod(column, {.control = RodControl::load, .points = 5});
  BOOST_REQUIRE(path.singular.size() == 1u);
  for (const int sign : {1, -1}) {
    const RodPath branch = trace_branch(column, path.singular[0], sign, 0.05, {.points = 20});
    BOOST_TEST(branch.points.back().factor == 1.0);
    const Poses<3>& end = branch.points.back().poses;
    // P / P_E = (2 K(k) / pi)^2, k = sin(alpha / 2), alpha the end's angle
    const double alpha =
        2 * std::asin(norm(Vec<double, 3>(rotate(end[0].orientation, Vec<double, 3>{1, 0, 0}) -
                                          Vec<double, 3>{1, 0, 0})) /
                      2);
    const double ratio = std::pow(2 / kPi * std::comp_ellint_1(std::sin(alpha / 2)), 2);
    BOOST_TEST(ratio == 1.2, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(sign * end[20].position[1] > 0.2 * L);
    BOOST_TEST(name(branch.points.back().stability) == "stable");
  }
}

BOOST_AUTO_TEST_SUITE_END()
