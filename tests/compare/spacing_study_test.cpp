// Fibers cut into bonds longer or shorter than thick, by the studies' measures: stable steps by runs, scenes
// released by every leapfrog and with a material's memory, calibration, bonds saved.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "compare/calibration/calibration.hpp"
#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/scenes/release_report.hpp"
#include "compare/spacing/study.hpp"
#include "compare/stability/run.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/chain_modes.hpp"

BOOST_AUTO_TEST_SUITE(spacing_study_test)

using namespace fiberchain;
using dem::BondModel;
using dem::MassModel;

namespace {

constexpr double spacings[] = {0.5, 1.7, 2.6};

dem::Fiber fiber_of(int bonds, double spacing, BondModel model, MassModel mass, double xi_b) {
  dem::Fiber fiber = compare::nominal_fiber(bonds, 0.17, model);
  fiber.spacing = spacing, fiber.mass = mass, fiber.bond_damping = xi_b;
  return fiber;
}

/// Whether the step said is that of the endless chain or, where its ends are light, of the finite one.
void check_predicted(const dem::Fiber& fiber) {
  const reference::LinearChain chain = compare::linear_chain_of(fiber);
  const double endless = reference::endless_stable_step(chain, reference::lagged_dashpots),
               finite = reference::finite_stable_step(chain, reference::lagged_dashpots,
                                                      reference::ChainEnds::free_free);
  BOOST_CHECK_CLOSE_FRACTION(dem::stable_time_step(fiber), std::min(endless, finite), 1e-4);
}

dem::ReleaseScene scene_of(const std::string& fiber, const std::string& rest) {
  return std::get<dem::ReleaseScene>(dem::parse_scene(
      {"s.yaml",
       "scene: release\nfiber: {diameter: 1.3 mm, aspect_ratio: 13, youngs_modulus: 3.1 MPa, "
       "poisson_ratio: 0.17, density: 1300, " +
           fiber + "}\nload: {reduced: 0.005}\n" + rest}));
}

}  // namespace

BOOST_AUTO_TEST_CASE(runs_leave_stability_where_the_modes_do_and_no_sooner_than_is_said) {
  for (const double s : spacings) {
    for (const auto model : {BondModel::paper, BondModel::corrected}) {
      for (const double xi_b : {0.0, 0.4}) {
        const dem::Fiber fiber = fiber_of(7, s, model, MassModel::cylinder, xi_b);
        const auto limit = compare::measured_limit({.fiber = fiber, .ends = reference::ChainEnds::free_free});
        const double modes =
            reference::finite_stable_step(compare::linear_chain_of(fiber), reference::lagged_dashpots,
                                          reference::ChainEnds::free_free, true);
        BOOST_TEST_CONTEXT(dem::name(model) << " s " << s << " xi_b " << xi_b) {
          BOOST_TEST(limit.stable < modes * 1.002);
          BOOST_TEST(limit.unstable > modes * 0.999);
          BOOST_TEST(dem::stable_time_step(fiber) < limit.unstable);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_step_that_is_said_is_that_of_the_reference) {
  for (const double s : {0.5, 0.8, 1.7, 2.6, 6.0})
    for (const int bonds : {2, 3, 5, 26})
      for (const auto model : {BondModel::paper, BondModel::corrected})
        for (const auto mass : {MassModel::spheres, MassModel::cylinder})
          for (const double xi_b : {0.0, 0.4})
            if (bonds * s > 1.2) check_predicted(fiber_of(bonds, s, model, mass, xi_b));
}

BOOST_AUTO_TEST_CASE(scenes_let_go_ring_as_the_linear_chain_does) {
  for (const std::string integrator : {"leapfrog", "leapfrog-damped", "leapfrog-stiff"}) {
    for (const std::string spacing : {"0.5", "2.6"}) {
      const auto scene = scene_of(
          "mass: cylinder, spacing: " + spacing,
          "bond: {model: corrected, damping: 0.9}\nperiods: 25\ntime: {integrator: " + integrator + "}\n");
      const compare::ReleaseRun run = compare::run_release(scene);
      BOOST_TEST(run.failure == "");
      BOOST_TEST(std::abs(run.damping / run.damping_modes - 1) < 2e-3, integrator << " s " << spacing);
      const double mode =
          reference::first_bending_mode(compare::linear_chain_of(scene.fiber)).eigenvalue.imag();
      BOOST_TEST(std::abs(run.frequency / mode - 1) < 2e-3);
      BOOST_TEST(compare::release_table(scene, run).number(0, "aspect_ratio") == 13);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_materials_memory_stiffens_it_as_its_complex_modes_say) {
  const auto scene = scene_of(
      "spacing: 2.6, material_damping: {spectrum: {youngs_modulus: [{strength: 0.3, time: 8 ms}], "
      "shear_modulus: "
      "[{strength: 0.3, time: 2 ms}]}}",
      "bond: {model: corrected}\nperiods: 10\ntime: {integrator: leapfrog}\n");
  const compare::ReleaseRun run = compare::run_release(scene);
  BOOST_TEST(run.failure == "");
  const double relaxed =
                   reference::first_bending_mode(compare::linear_chain_of(scene.fiber)).eigenvalue.imag(),
               own = compare::bending_modes_of(scene.fiber, 1).front().decay.eigenvalue.imag();
  BOOST_TEST(own > 1.05 * relaxed);
  BOOST_TEST(std::abs(run.frequency / own - 1) < 3e-3, run.frequency << " " << own);
}

BOOST_AUTO_TEST_CASE(bonds_of_any_length_are_calibrated) {
  for (const double s : spacings) {
    compare::CalibrationCase asked{.fiber = fiber_of(9, s, BondModel::paper, MassModel::spheres, 0)};
    const auto found = compare::calibrate(asked, 0.02);
    const auto mode = reference::first_bending_mode(compare::linear_chain_of(found.fiber));
    BOOST_TEST(std::abs(mode.damping / 0.02 - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(corrected_bonds_are_three_to_five_times_fewer_where_bending_allows_it) {
  for (const double load : {1.0, 6.0}) {
    const auto found = compare::fewest_bonds(60, 0.3, compare::SpacingGoal::statics, load, 0);
    BOOST_TEST(found.error <= found.touching);
    BOOST_TEST(found.times_fewer >= 3);
  }
  const auto mode = compare::fewest_bonds(60, 0.3, compare::SpacingGoal::first_mode, 0, 0);
  BOOST_TEST(mode.error <= mode.touching);
  BOOST_TEST(mode.times_fewer >= 3);
  // no number of bonds makes a stretching rod an inextensible one
  BOOST_TEST(compare::fewest_bonds(6, 0.3, compare::SpacingGoal::statics, 6, 1e-6).bonds == 0);
  BOOST_CHECK_THROW(compare::spaced_fiber({.aspect_ratio = 13, .spacing = 2}), compare::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
