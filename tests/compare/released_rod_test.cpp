// A rod of uniform curvature let go at one end: its curvature rises to 1.428 of what it was, and breaks it or
// not.
#include "compare/breaking/released_rod.hpp"
#include "compare/breaking/fragments.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(released_rod_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::compare;

namespace {

dem::AssemblyOptions options_of(const ReleasedRod& rod, dem::BondForm form, dem::Integrator scheme) {
  return {.step = (scheme == dem::Integrator::leapfrog ? 0.4 : 2.0) * dem::bond_time_step(rod.fiber),
          .integrator = scheme,
          .form = form};
}

constexpr dem::Integrator schemes[] = {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff};

}  // namespace

BOOST_AUTO_TEST_CASE(largest_curvature_tends_to_that_of_a_beam) {
  const double exact = largest_curvature_of_beam();
  BOOST_TEST(std::abs(exact - 1.428) < 5e-4);
  for (const dem::BondForm form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const dem::Integrator scheme : schemes) {
      double error[3];
      for (int n = 0; n < 3; ++n) {
        const ReleasedRod rod = released_rod(80 << n);
        error[n] = std::abs(largest_curvature(rod, options_of(rod, form, scheme)) / exact - 1);
      }
      BOOST_TEST_MESSAGE(name(form) << ", " << name(scheme) << ": off by " << error[0] << ", " << error[1]
                                    << ", " << error[2]);
      BOOST_TEST(error[0] < 0.01);
      BOOST_TEST(error[1] < 0.5 * error[0]);
      BOOST_TEST(error[2] < 0.5 * error[1]);
    }
  }
}

/// By the strength in bending, E R kappa.
BOOST_AUTO_TEST_CASE(strength_of_1_40_breaks_and_of_1_46_does_not) {
  for (const dem::Integrator scheme : schemes) {
    for (const double part : {1.40, 1.46}) {
      ReleasedRod rod = released_rod(160);
      const double strength = part * stress_at_rest(rod);
      rod.fiber.strength = dem::BondStrength{.tension = strength, .compression = strength};
      const auto breaks = breaks_of(rod, options_of(rod, dem::BondForm::total, scheme));
      BOOST_TEST(breaks.empty() == (part > 1.428), name(scheme) << " " << part << ": " << breaks.size());
      if (breaks.empty()) continue;
      BOOST_TEST_MESSAGE(name(scheme)
                         << ": breaks " << 160 - breaks[0].bond << " diameters from the free end");
      BOOST_TEST(breaks[0].stress >= strength);
      BOOST_TEST(breaks[0].stress < 1.01 * strength);
      BOOST_TEST(breaks[0].time > time_of_way(rod.fiber, rod.release_way));
    }
  }
}

/// Weaker rods break into more pieces; into how many is measured by `validate`.
BOOST_AUTO_TEST_CASE(rods_break_into_pieces_by_their_strength) {
  const Fragments weak = break_rods({.aspect_ratio = 20, .rods = 160, .strength = 1.2}),
                  strong = break_rods({.aspect_ratio = 20, .rods = 160, .strength = 1.6});
  BOOST_TEST_MESSAGE(weak.mean << " +- " << weak.deviation << " pieces, " << strong.mean << " +- "
                               << strong.deviation);
  BOOST_TEST(std::abs(weak.mean - 2.25) < 3 * weak.deviation + 0.05);
  BOOST_TEST(strong.mean < weak.mean - 0.5);
  BOOST_TEST(weak.longest < strong.longest);
  BOOST_TEST(weak.unbroken < strong.unbroken);
}

BOOST_AUTO_TEST_SUITE_END()
