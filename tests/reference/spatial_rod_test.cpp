// The rod in space against closed forms, the planar beam and published values.
#include "reference/spatial_rod.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/reissner.hpp"

BOOST_AUTO_TEST_SUITE(spatial_rod_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_near(const ref::SpaceVector& a, const ref::SpaceVector& b, double allowed) {
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(std::abs(a[i] - b[i]) < allowed, a[i] << " " << b[i]);
}

}  // namespace

BOOST_AUTO_TEST_CASE(bends_in_its_plane_as_reissners_beam) {
  const double L = 0.83, EI = 2.7, EA = 310, P = 5.1;
  const ref::TipState plane = ref::reissner_cantilever(EI, EA, infinity, P, L);
  const auto end = ref::spatial_rod_end({{{0.3}, {L - 0.3}}, EI, 1.9, EA}, {.force = {0, 0, P}});
  check_near(end, {L * (1 - plane.x), 0, L * plane.y}, 1e-10);
}

BOOST_AUTO_TEST_CASE(an_end_moment_makes_a_helix) {
  // straight at rest, B for both bendings: M fixed in space turns about the rod's axis; with B = C the
  // curvature is M / B everywhere in space: a helix about M
  const double L = 1.3, B = 0.7;
  const ref::SpaceVector M{0.9, 1.7, -0.4};
  const auto end = ref::spatial_rod_end({{{L}}, B, B, infinity}, {.moment = M});
  const double m = std::hypot(M[0], M[1], M[2]), w = m / B * L;
  const ref::SpaceVector n{M[0] / m, M[1] / m, M[2] / m};
  // r = int (exp(s k x) e_x) ds
  const ref::SpaceVector across{0, n[2], -n[1]};  // n x e_x
  ref::SpaceVector exact{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = n[0] * n[i], flat = (i == 0 ? 1.0 : 0.0) - along;
    exact[i] = L * (along + flat * std::sin(w) / w + across[i] * (1 - std::cos(w)) / w);
  }
  check_near(end, exact, 1e-11);
}

BOOST_AUTO_TEST_CASE(bends_under_its_weight_as_the_small_beam) {
  const double L = 0.9, EI = 3.1, w = 1e-5;
  const auto end = ref::spatial_rod_end({{{L}}, EI, 2, infinity}, {.weight = {0, w, 0}});
  BOOST_TEST(std::abs(end[1] / (w * L * L * L * L / (8 * EI)) - 1) < 1e-8);
}

// K. J. Bathe, S. Bolourchi, Large displacement analysis of three-dimensional beam structures, Int. J. Numer.
// Meth. Eng. 14 (1979) 961-986: a 45 degree bend of radius 100, section 1 x 1, E = 1e7, nu = 0, force 600 out
// of its plane; their 8 straight elements give the tip at (15.9, 47.2, 53.4) from (29.3, 70.7, 0), as J. C.
// Simo and L. Vu-Quoc's (1986) do: (15.79, 47.23, 53.37). More elements take it to ours, within 0.4.
BOOST_AUTO_TEST_CASE(the_45_degree_bend_of_bathe_and_bolourchi) {
  const double R = 100, EI = 1e7 / 12, GJ = 0.5e7 * 0.1406, angle = std::numbers::pi / 4;
  // the bend begins along its y axis and turns towards x: here along x, turning towards -y
  const auto end =
      ref::spatial_rod_end({{{R * angle, {0, 0, -1 / R}}}, EI, GJ, 1e7}, {.force = {0, 0, 600}}, 20);
  BOOST_TEST(std::abs(-end[1] - 15.9) < 0.4);
  BOOST_TEST(std::abs(end[0] - 47.2) < 0.4);
  BOOST_TEST(std::abs(end[2] - 53.4) < 0.4);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_rod) {
  BOOST_CHECK_THROW(ref::spatial_rod_end({{}, 1, 1, 1}, {}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::spatial_rod_end({{{-1}}, 1, 1, 1}, {}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::spatial_rod_end({{{1}}, 0, 1, 1}, {}), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
