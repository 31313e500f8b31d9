// The study of materials: what it measures against closed forms and roots.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "compare/material/damped_packing.hpp"
#include "compare/material/modulus_rise.hpp"
#include "compare/material/points.hpp"
#include "compare/measure/bond_spectra_of.hpp"
#include "compare/study/errors.hpp"
#include "dem/scene/scene_error.hpp"

BOOST_AUTO_TEST_SUITE(material_study_test)

using namespace fiberchain;
using namespace fiberchain::compare;

namespace {

dem::Fiber one_branch(double strength, double time) {
  dem::Fiber fiber{dem::isotropic_material(3.1e9, 0.17, 1310), 1.7e-3, 7};
  const dem::PronySeries series{{strength, time}};
  fiber.branches = dem::maxwell_branches({series, series, {}}, fiber.bond_model);
  return fiber;
}

double zeta_1(const dem::Fiber& fiber) { return bending_modes_of(fiber, 1).front().decay.damping; }

}  // namespace

BOOST_AUTO_TEST_CASE(causality_gives_back_one_maxwell_branch) {
  constexpr double g = 0.7, tau = 0.013;
  const auto storage = [](double w) { return 1 + g * w * w * tau * tau / (1 + w * w * tau * tau); };
  const auto tangent = [&](double w) { return g * w * tau / (1 + w * w * tau * tau) / storage(w); };
  for (const double low : {3.0, 40.0}) {
    BOOST_TEST(causal_rise(tangent, low, 1900) == storage(1900) / storage(low),
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(a_loop_has_the_area_of_its_branch_to_second_order) {
  constexpr double g = 0.4, tau = 2.3e-3, f = 51;
  const double x = 2 * std::numbers::pi * f * tau;
  const double expected = g * x / (1 + x * x) / (1 + g * x * x / (1 + x * x));
  const dem::Fiber fiber = one_branch(g, tau);
  BOOST_TEST(bending_loss_factor(fiber, f) == expected, boost::test_tools::tolerance(1e-12));
  const double coarse = bending_loop(fiber, f, {.cycles = 12, .steps = 100}).loss / expected - 1,
               fine = bending_loop(fiber, f, {.cycles = 12, .steps = 200}).loss / expected - 1;
  BOOST_TEST(std::abs(fine) < 1e-3);
  BOOST_TEST(std::abs(coarse / fine - 4) < 0.05);
}

BOOST_AUTO_TEST_CASE(a_loop_of_dashpots_is_an_ellipse) {
  dem::Fiber fiber{dem::isotropic_material(3.1e9, 0.17, 1310), 1.7e-3, 7};
  fiber.dashpots = dem::DashpotLaw::retardation_time, fiber.retardation_time = 1.9e-5;
  const BendingLoop loop = bending_loop(fiber, 430, {.cycles = 2});
  BOOST_TEST(loop.loss == 2 * std::numbers::pi * 430 * 1.9e-5, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(loop.storage == dem::bond_stiffness(fiber).bend, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(modes_decay_in_time_as_their_roots) {
  const dem::Fiber fiber = one_branch(0.03, 4e-5);
  for (const auto& mode : bending_modes_of(fiber, 2)) {
    const MarchedDecay marched = marched_decay(fiber, mode);
    BOOST_TEST(marched.damping == mode.decay.damping, boost::test_tools::tolerance(2e-4));
    BOOST_TEST(2 * std::numbers::pi * marched.frequency == mode.decay.eigenvalue.imag(),
               boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(three_fibers_are_alike_in_mode_1) {
  const MetalValues tungsten = metal_values("tungsten");
  const ThreeFibers fibers = three_fibers(tungsten, 9);
  const double wire = zeta_1(fibers.thermoelastic);
  BOOST_TEST(zeta_1(fibers.viscous) == wire, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(zeta_1(fibers.flat) == wire, boost::test_tools::tolerance(1e-6));
  // at the peak a quarter of Zener's strength, less what the further modes and shear have
  const double strength =
      dem::relaxation_strength(tungsten.thermal, tungsten.youngs_modulus, tungsten.density);
  BOOST_TEST(wire < 0.25 * strength);
  BOOST_TEST(wire > 0.24 * strength);
  const double f = first_frequency(fibers.elastic);
  BOOST_TEST(dem::thermal_peak(dem::thermal_diffusivity(tungsten.thermal, tungsten.density),
                               fibers.diameter / 2) == f,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(diameter_at_peak(tungsten, 9, 3) == 3 * fibers.diameter, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_wire_is_damped_as_the_exact_series_says) {
  const auto points = wire_points(
      {.metals = {"nickel"}, .aspect_ratio = 9, .diameters = {3e-6, 2e-3}, .marched_every = 0}, 1);
  BOOST_REQUIRE(points.size() == 2);
  for (const WirePoint& p : points) {
    BOOST_TEST(p.root == p.series, boost::test_tools::tolerance(0.01));
    BOOST_TEST(!p.marched);
  }
  BOOST_TEST(points[0].frequency / points[0].peak < 1);
  BOOST_TEST(points[1].frequency / points[1].peak > 10);
}

BOOST_AUTO_TEST_CASE(values_are_those_of_the_files) {
  const MetalValues steel = metal_values("carbon-steel");
  BOOST_TEST(steel.youngs_modulus == 212e9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(steel.thermal.temperature == 290);
  BOOST_TEST(steel.thermal.conductivity == 49);
  const PlantLoss bamboo = plant_loss("bamboo");
  BOOST_TEST(bamboo.bending.low == 0.01);
  BOOST_TEST(bamboo.bending.high == 0.015);
  BOOST_TEST(bamboo.twist.high == 0.04);
  BOOST_TEST(bamboo.band_high == 20000);
  BOOST_CHECK_THROW(metal_values("unobtainium"), fiberchain::dem::SceneError);
  BOOST_CHECK_THROW(metal_values("bamboo"), InputError);  // no conductivity
}

BOOST_AUTO_TEST_CASE(packings_have_the_same_damping_of_mode_1) {
  const EqualDamping equal = equal_damping(0.6);
  BOOST_TEST(equal.loss_factor > 1.9 * equal.damping);
  BOOST_TEST(equal.loss_factor < 2.1 * equal.damping);
  const auto cases = damped_packings({.fibers = 75, .seeds = 2, .bond_damping = 0.6});
  BOOST_REQUIRE(cases.size() == 6);
  BOOST_TEST(damper_of(cases[3]) == "elastic");
  BOOST_TEST(damper_of(cases[4]) == "viscous");
  BOOST_TEST(damper_of(cases[5]) == "flat");
  BOOST_TEST(cases[5].loss_factor == equal.loss_factor);
  BOOST_TEST(cases[5].seed == 2);
}

BOOST_AUTO_TEST_CASE(a_packing_has_settled_when_it_stays_slow) {
  PackingRun run;
  for (const double speed : {0.2, 1.0, 0.04, 0.07, 0.03, 0.01}) {
    run.history.push_back({});
    run.history.back().time = 0.1 * static_cast<double>(run.history.size()), run.history.back().speed = speed;
  }
  BOOST_TEST(settle_time(run) == 0.4);
  BOOST_TEST(settle_time(run, 0.5) == 0.2);
}

BOOST_AUTO_TEST_CASE(logarithmic_values_are_evenly_apart) {
  const auto values = logarithmic_values(2e-3, 5, 4);
  BOOST_REQUIRE(values.size() == 4);
  BOOST_TEST(values[0] == 2e-3);
  BOOST_TEST(values[3] == 5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(values[2] / values[1] == values[1] / values[0], boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
