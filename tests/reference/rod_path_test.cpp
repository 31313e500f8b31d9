// Rods in space held and loaded in any way, against closed forms and published values.
#include "reference/rod_path.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "reference/errors.hpp"
#include "reference/reissner.hpp"
#include "reference/twisted_ring.hpp"

BOOST_AUTO_TEST_SUITE(rod_path_test)

namespace ref = fiberchain::reference;
using ref::RodJoint;
using std::numbers::pi;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double L = 1.31, EI = 0.73;

ref::SpatialRod straight(double axial = infinity, double shear = infinity) {
  return {{{L}}, EI, 0.61, axial, shear};
}

void check_near(const ref::SpaceVector& a, const ref::SpaceVector& b, double allowed) {
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(std::abs(a[i] - b[i]) < allowed, a[i] << " " << b[i]);
}

ref::SpaceVector end_of(const ref::RodProblem& problem, double factor = 1) {
  return ref::follow_rod(problem, factor).sections.back().position;
}

/// A hinge about z whose end may move along x.
constexpr ref::RodEnd sliding_hinge{.held = {false, true, true}, .joint = RodJoint::hinge};

/// Load factor of first branching in the plane under an end force -e_x E I / L^2.
double euler(ref::RodEnd begin, ref::RodEnd end, double low, double high, double axial = infinity,
             double shear = infinity) {
  ref::RodProblem column{.rod = straight(axial, shear), .begin = begin, .end = end, .planar = true};
  column.varied.force = {-EI / (L * L), 0, 0};
  return ref::rod_critical_factor(column, low, high, ref::RodMotion::in_plane);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_end_moment_bends_a_rod_to_a_ring) {
  ref::RodProblem ring{.rod = {{{0.4 * L}, {0.6 * L}}, EI, 0.61, 55}, .planar = true};
  ring.varied.moment = {0, 0, 2 * pi * EI / L};
  const auto at = ref::follow_rod(ring);
  check_near(at.sections.back().position, {0, 0, 0}, 1e-11);
  const double a = 0.8 * pi, R = L / (2 * pi);
  check_near(at.sections[1].position, {R * std::sin(a), R * (1 - std::cos(a)), 0}, 1e-11);
  const auto shape = ref::rod_shape(ring, at, 5);
  BOOST_TEST(shape.size() == 6U);
  check_near(shape[2].position, at.sections[1].position, 1e-11);
}

// Love, Treatise, section 270: a straight rod is a helix of this radius and slope under a wrench about its
// axis, with any twist; its force is cos(a) (C tau - B sin(a) cos(a) / r) / r.
BOOST_AUTO_TEST_CASE(a_wrench_makes_a_helix) {
  const double B = EI, C = 0.61, r = 0.17, slope = 0.4, twist = 1.9;
  const double c = std::cos(slope), s = std::sin(slope), F = c * (C * twist - B * s * c / r) / r;
  // begin: tangent e_x, the principal normal e_y; then the axis is s e_x + c e_z
  const ref::SpaceVector axis{s, 0, c};
  ref::RodProblem helix{.rod = {{{L}}, B, C, infinity}};
  for (std::size_t i = 0; i < 3; ++i) helix.varied.force[i] = F * axis[i];
  const double angle = c * L / r, rise = s * L;
  // the moment at the end, on the axis and across it
  const double along = C * twist * s + B * c * c * c / r, around = C * twist * c - B * c * c * s / r;
  const ref::SpaceVector tangential{c * std::cos(angle), std::sin(angle), -s * std::cos(angle)};
  for (std::size_t i = 0; i < 3; ++i) helix.varied.moment[i] = along * axis[i] + around * tangential[i];
  const ref::SpaceVector flat{c, 0, -s};
  ref::SpaceVector exact{};
  for (std::size_t i = 0; i < 3; ++i)
    exact[i] = rise * axis[i] + r * std::sin(angle) * flat[i] + (i == 1 ? r * (1 - std::cos(angle)) : 0);
  check_near(end_of(helix), exact, 1e-10);
}

BOOST_AUTO_TEST_CASE(stretches_and_shears_as_reissners_beam) {
  const double P = 2.3, axial = 61, shear = 19;
  ref::RodProblem cantilever{.rod = straight(axial, shear)};
  cantilever.varied.force = {0, 0, P};
  const auto tip = ref::reissner_cantilever(EI, axial, shear, P, L);
  check_near(end_of(cantilever), {L * (1 - tip.x), 0, L * tip.y}, 1e-10);
}

// theta'' = p cos(phi) in the frame of the end: p = (int dphi / sqrt(sin phi))^2 / 2, phi up to the end's
// turn.
BOOST_AUTO_TEST_CASE(a_force_that_follows_turns_the_end_as_the_pendulum) {
  for (const double turn : {0.6, 2.4}) {
    const auto part = [](double phi) {
      // int dphi / sqrt(sin phi) with u = sin^2(phi)
      const double u = std::pow(std::sin(phi), 2);
      return 0.5 * boost::math::beta(0.25, 0.5, u);
    };
    const double whole = 0.5 * boost::math::beta(0.25, 0.5);
    const double integral = turn < pi / 2 ? part(turn) : 2 * whole - part(turn);
    ref::RodProblem follower{.rod = straight(), .planar = true};
    follower.varied.following_force = {0, integral * integral / 2 * EI / (L * L), 0};
    const auto q = ref::follow_rod(follower).sections.back().orientation;
    BOOST_TEST(std::abs(2 * std::atan2(q[2], q[3]) - turn) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(columns_of_all_ends_branch_at_eulers_loads) {
  const ref::RodEnd hinge{.joint = RodJoint::hinge}, clamp{}, sliding_clamp{.held = {false, true, true}},
      guided{.held = {false, false, true}};
  const double root = 4.493409457909064;  // tan x = x
  BOOST_TEST(std::abs(euler(clamp, ref::free_rod_end, 1, 4) - pi * pi / 4) < 1e-9);
  BOOST_TEST(std::abs(euler(hinge, sliding_hinge, 5, 15) - pi * pi) < 1e-9);
  BOOST_TEST(std::abs(euler(clamp, sliding_hinge, 15, 25) - root * root) < 1e-9);
  BOOST_TEST(std::abs(euler(clamp, sliding_clamp, 30, 50) - 4 * pi * pi) < 1e-9);
  BOOST_TEST(std::abs(euler(clamp, guided, 5, 15) - pi * pi) < 1e-9);
}

// J. A. Haringx (1948), with stretch: P (1 - P/EA + P/GA) = pi^2 E I / L^2
BOOST_AUTO_TEST_CASE(a_column_that_stretches_and_shears_branches_as_haringx_has_it) {
  const double axial = 91, shear = 43,
               P = euler({.joint = RodJoint::hinge}, sliding_hinge, 4, 15, axial, shear) * EI / (L * L);
  BOOST_TEST(std::abs(P * (1 - P / axial + P / shear) / (pi * pi * EI / (L * L)) - 1) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_hinged_column_beyond_its_load_is_the_elastica) {
  // end angle a: P / P_E = (2 K(sin(a/2)) / pi)^2
  const double a = 1.1, ratio = std::pow(2 * boost::math::ellint_1(std::sin(a / 2)) / pi, 2);
  ref::RodProblem column{
      .rod = straight(), .begin = {.joint = RodJoint::hinge}, .end = sliding_hinge, .planar = true};
  const double P = ratio * pi * pi * EI / (L * L);
  column.varied.force = {-P, 0, 0};
  auto guess = ref::rod_at_rest();
  guess.orientation = {0, 0, std::sin(0.5), std::cos(0.5)};  // an angle of 1
  guess.force = {-P, 0, 0};
  const auto q = ref::solve_rod(column, 1, guess).sections.front().orientation;
  BOOST_TEST(std::abs(2 * std::atan2(q[2], q[3]) - a) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_standing_column_gives_way_to_its_weight_as_greenhill_has_it) {
  // w L^3 / E I = 9/4 j^2, j = 1.866350858873895 the first zero of J_(-1/3)
  ref::RodProblem column{.rod = straight(), .planar = true};
  column.varied.weight = {-EI / (L * L * L), 0, 0};
  const double found = ref::rod_critical_factor(column, 5, 12, ref::RodMotion::in_plane);
  BOOST_TEST(std::abs(found - 2.25 * std::pow(1.866350858873895, 2)) < 1e-9);
}

// The power series of theta'' = w s cos(theta) from the free end, where theta = a: w is such that theta(L) =
// 0.
BOOST_AUTO_TEST_CASE(hangs_under_its_weight_as_the_power_series) {
  constexpr int terms = 60;
  const auto series = [](double a, double w) {  // theta, int cos, int sin at s = 1
    std::vector<double> t(terms + 2), c(terms + 2), s(terms + 2);
    t[0] = a, c[0] = std::cos(a), s[0] = std::sin(a);
    for (int n = 0; n < terms; ++n) {
      // (n + 1) c_(n+1) = -sum (k + 1) t_(k+1) s_(n-k)
      const auto m = static_cast<std::size_t>(n);
      double dc = 0, ds = 0;
      if (n >= 1) t[m + 1] = n >= 2 ? w * c[m - 2] / ((n + 1.0) * n) : 0;
      for (std::size_t k = 0; k <= m; ++k) {
        dc -= (static_cast<double>(k) + 1) * t[k + 1] * s[m - k];
        ds += (static_cast<double>(k) + 1) * t[k + 1] * c[m - k];
      }
      c[m + 1] = dc / (n + 1), s[m + 1] = ds / (n + 1);
    }
    std::array<double, 3> at{};
    for (std::size_t n = 0; n < terms; ++n)
      at[0] += t[n], at[1] += c[n] / (static_cast<double>(n) + 1),
          at[2] += s[n] / (static_cast<double>(n) + 1);
    return at;
  };
  const double a = -0.9;
  double low = 0, high = 20;  // theta rises with w
  for (int i = 0; i < 100; ++i) {
    const double w = (low + high) / 2;
    (series(a, w)[0] < 0 ? low : high) = w;
  }
  const auto at = series(a, low);
  ref::RodProblem heavy{.rod = straight(), .planar = true};
  heavy.varied.weight = {0, -low * EI / (L * L * L), 0};
  check_near(end_of(heavy), {L * at[1], L * at[2], 0}, 1e-10);
}

// S. L. Lee, F. S. Manuel, E. C. Rossow, J. Eng. Mech. Div. ASCE 94 (1968): two members of length 120, E A =
// 6 E, E I = 2 E, hinged at both ends, a force at a fifth of the second one. J. C. Simo, L. Vu-Quoc (1986)
// and others have its limit loads at 18.5 and -9.4 E I / 120^2.
BOOST_AUTO_TEST_CASE(lees_frame_turns_back_twice) {
  ref::RodProblem lee{.rod = {{{120}, {24, {}, -pi / 2}, {96, {}, 0, {-0.1, 0, 0}}}, 2, 1.4, 6},
                      .begin = {.joint = RodJoint::hinge},
                      .end = {.joint = RodJoint::hinge},
                      .planar = true};
  const double unit = 2 / (0.1 * 120 * 120);
  const auto path =
      ref::rod_path(lee, ref::solve_rod(lee, 0, ref::rod_at_rest()),
                    {.points = 110, .ends = [&](const auto& at) { return at.factor < -8 * unit; }});
  const auto limits = ref::rod_limit_points(lee, path);
  BOOST_TEST_REQUIRE(limits.size() >= 1U);
  BOOST_TEST(std::abs(limits[0].factor / unit - 18.557) < 0.001);
  BOOST_TEST(std::abs(limits[0].in_plane) < 1e-6 * std::abs(path[0].in_plane));
  BOOST_TEST(path.back().factor < -8 * unit);
}

// J. H. Argyris et al., Comput. Meth. Appl. Mech. Eng. 20 (1979) 105-155: frames of two members of length
// 240, 30 x 0.6 thick, E = 71240, nu = 0.31. J. C. Simo, L. Vu-Quoc, ibid. 58 (1986) 79-116 have the critical
// force in the plane of the clamped one at 1.088, the moments of the hinged one at +-622.2.
BOOST_AUTO_TEST_CASE(right_angle_frames_leave_their_plane_at_argyris_loads) {
  const double E = 71240, b = 30, t = 0.6;
  const auto frame = [&](double corner) -> ref::SpatialRod {
    return {{{240, {}, corner}, {240, {}, -pi / 2}},
            E * t * b * b * b / 12,
            E / 2.62 * b * t * t * t / 3,
            E * b * t,
            infinity,
            E * b * t * t * t / 12};
  };
  ref::RodProblem clamped{.rod = frame(0), .planar = true};
  clamped.varied.force = {1, 0, 0};
  BOOST_TEST(std::abs(ref::rod_critical_factor(clamped, 0.9, 1.3, ref::RodMotion::out_of_plane) - 1.088) <
             0.001);
  for (const double way : {1.0, -1.0}) {
    ref::RodProblem hinged{
        .rod = frame(pi / 4), .begin = {.joint = RodJoint::hinge}, .end = sliding_hinge, .planar = true};
    hinged.varied.moment = {0, 0, way}, hinged.varied.begin_moment = {0, 0, -way};
    BOOST_TEST(std::abs(ref::rod_critical_factor(hinged, 600, 628, ref::RodMotion::out_of_plane) - 622.2) <
               0.05);
  }
}

BOOST_AUTO_TEST_CASE(a_twisted_ring_leaves_its_plane_at_michells_turn) {
  const double C = 0.61, michell = 2 * pi * std::sqrt(3.0) * EI / C;
  BOOST_TEST(std::abs(ref::twisted_ring_critical_turn({L, EI, C, infinity, infinity}) / michell - 1) < 1e-12);
  // stretch alone and shear alone make it softer, in proportion where they are small
  const auto less = [&](double axial, double shear) {
    return 1 - ref::twisted_ring_critical_turn({L, EI, C, axial, shear}) / michell;
  };
  const double unit = EI / (L * L), stretch = less(1e4 * unit, infinity), shear = less(infinity, 1e4 * unit);
  BOOST_TEST(stretch > 0);
  BOOST_TEST(shear > 0);
  BOOST_TEST(std::abs(less(1e4 * unit, 1e4 * unit) / (stretch + shear) - 1) < 0.01);
  BOOST_TEST(std::abs(less(1e5 * unit, infinity) * 10 / stretch - 1) < 0.01);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_rod) {
  ref::RodProblem none{.rod = {{{L}}, EI, 0.61, infinity, -1}};
  BOOST_CHECK_THROW(ref::follow_rod(none), ref::InvalidArgument);
  none.rod = {{}, EI, 0.61, infinity};
  BOOST_CHECK_THROW(ref::follow_rod(none), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
