// Rods whose chain has a closed form: bending to a ring, columns.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/dem/equilibrium/rods.hpp"

BOOST_AUTO_TEST_SUITE(rod_closed_forms_test)

using namespace fiberchain::dem;
using namespace fiberchain::dem::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// What a column's ends may do; its load is along -x at the last sphere.
struct ColumnEnds {
  std::string_view name;
  RodSupport first, last;
  double length_factor;  ///< P_cr = (pi / (factor L))^2 E I
};

std::vector<ColumnEnds> all_ends(int n) {
  const std::array<bool, 3> slides{false, true, true}, turns{true, true, false}, fixed{true, true, true};
  return {{"clamped, free",
           {.sphere = 0},
           {.sphere = n, .hold_displacement = {false, false, true}, .hold_rotation = turns},
           2},
          {"hinged, hinged",
           {.sphere = 0, .hold_rotation = turns},
           {.sphere = n, .hold_displacement = slides, .hold_rotation = turns},
           1},
          {"clamped, hinged",
           {.sphere = 0},
           {.sphere = n, .hold_displacement = slides, .hold_rotation = turns},
           kPi / 4.493409457909064},
          {"clamped, guided",
           {.sphere = 0},
           {.sphere = n, .hold_displacement = slides, .hold_rotation = fixed},
           0.5}};
}

/// First critical load over E I (pi / (factor L))^2, and what it is found as.
double first_critical(const ColumnEnds& ends, const Fiber& fiber) {
  const int n = fiber.aspect_ratio;
  RodProblem problem{.chain = straight_chain<3>(fiber), .supports = {ends.first, ends.last}, .planar = true};
  const double euler =
      bending_stiffness(fiber) * std::pow(kPi / (ends.length_factor * fiber_length(fiber)), 2);
  problem.point_loads = {{.sphere = n, .force = {-1.3 * euler, 0, 0}}};
  const RodPath path = trace_rod(problem, {.control = RodControl::load, .points = 4});
  BOOST_REQUIRE(path.singular.size() == 1u);
  BOOST_TEST(name(path.singular[0].kind) == "bifurcation");
  BOOST_TEST(path.singular[0].crossing == 1);
  BOOST_TEST(name(path.points.front().stability) == "stable");
  BOOST_TEST(name(path.points.back().stability) == "unstable");
  return 1.3 * path.singular[0].point.factor;
}

/// A chain's bonds stretch by P / K_n and shear; with both in place the least load of the ends whose mode is
/// sin or cos along the bonds: per bond phi = pi / (factor n), 4 K_bend tan^2(phi / 2) = P l (1 + P l / (K_t
/// l_0^2) ...) solved by bisection on the determinant of one wave.
double wave_load(const Fiber& fiber, double phi) {
  const BondStiffness K = bond_stiffness(fiber);
  const double l0 = bond_length(fiber);
  const double chord = fiber.bond_model == BondModel::corrected ? 1.0 / 24 : 0.0;
  // y_i = Y sin(i phi), theta_i = T cos(i phi): second variation of the compressed straight chain
  const auto determinant = [&](double P) {
    const double l = l0 - P / K.stretch, N = -P;
    const double Kg = K.shear * l0 * l0, s = 2 * std::sin(phi / 2), c = std::cos(phi / 2);
    const double bend = K.bend + 2 * N * l0 * chord;
    // U/bond = 1/2 Kg (dy/l - mean theta)^2 + 1/2 N dy^2 / l + 1/2 bend dtheta^2
    const double yy = Kg * s * s / (l * l) + N * s * s / l, yt = -Kg * s * c / l,
                 tt = Kg * c * c + bend * s * s;
    return yy * tt - yt * yt;
  };
  double low = 0, high = 0.5 * K.stretch * l0;
  for (double P = high / 4096; P < high; P += high / 4096) {
    if (determinant(P) < 0) {
      high = P;
      break;
    }
    low = P;
  }
  for (int n = 0; n < 80; ++n) {
    const double middle = 0.5 * (low + high);
    (determinant(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_end_moment_bends_a_chain_to_a_ring) {
  for (const BondModel bond : {BondModel::paper, BondModel::corrected}) {
    for (const int n : {13, 100}) {
      const Fiber fiber = rod_fiber(n, bond);
      RodProblem problem{.chain = straight_chain<3>(fiber), .supports = {{.sphere = 0}}};
      const double M = 2 * kPi * bending_stiffness(fiber) / fiber_length(fiber);
      for (const LoadDirection direction : {LoadDirection::dead, LoadDirection::following}) {
        problem.point_loads = {{.sphere = n, .moment = {0, 0, M}, .direction = direction}};
        const RodPoint ring = solve_rod(problem);
        // equal turns of 2 pi / n about z: the ends meet, whatever a bond's length
        BOOST_TEST(tip_distance(ring.poses, problem.chain.poses) / fiber_length(fiber) == 1.0,
                   boost::test_tools::tolerance(1e-9));
        BOOST_TEST(norm(ring.poses.back().position) < 1e-9 * fiber_length(fiber));
        const double energy = M * kPi;  // 1/2 M 2 pi
        BOOST_TEST(ring.elastic_energy == energy, boost::test_tools::tolerance(1e-9));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(columns_of_all_ends_buckle_at_their_chains_own_load) {
  for (const BondModel bond : {BondModel::paper, BondModel::corrected}) {
    const Fiber fiber = rod_fiber(13, bond);
    const double euler = bending_stiffness(fiber) * std::pow(kPi / fiber_length(fiber), 2);
    for (const ColumnEnds& ends : all_ends(13)) {
      if (ends.name == "clamped, hinged") continue;  // not one wave
      const double k = ends.length_factor;
      const double found = first_critical(ends, fiber) * euler / (k * k);
      BOOST_TEST(found == wave_load(fiber, kPi / (k * 13)), boost::test_tools::tolerance(1e-7));
    }
  }
}

BOOST_AUTO_TEST_CASE(columns_of_all_ends_come_to_eulers_load_in_second_order) {
  for (const ColumnEnds& ends : all_ends(8)) {
    const auto error = [&](int n) {
      for (const ColumnEnds& there : all_ends(n)) {
        if (there.name == ends.name) return first_critical(there, rod_fiber(n)) - 1;
      }
      return 0.0;
    };
    // stretch is part of it, second order too
    const double order = std::log2(error(16) / error(32));
    BOOST_TEST(std::abs(order - 2) < 0.1, ends.name << ": order " << order);
  }
}

BOOST_AUTO_TEST_SUITE_END()
