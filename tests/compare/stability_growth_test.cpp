// Bonds solved within the step: runs at large steps against the chain's modes, the step that tension allows.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/marched_mode.hpp"
#include "compare/stability/stirred.hpp"
#include "compare/stability/table.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/implicit_bond.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/tension_limit.hpp"

BOOST_AUTO_TEST_SUITE(stability_growth_test)

using namespace fiberchain;
using compare::Growth;
using compare::GrowthPoint;
using dem::BondForm;
using dem::BondModel;
using dem::Integrator;
using reference::ChainEnds;
using reference::ChainMotion;

namespace {

constexpr reference::TimeScheme stiff_scheme = reference::bonds_in_step(dem::stiff_beta);
constexpr compare::StabilityCase stiff{.scheme = Integrator::leapfrog_stiff};

std::vector<GrowthPoint> points(const compare::StabilitySweep& sweep) {
  return compare::growth_points(compare::growth_cases(sweep), {.jobs = 2});
}

/// A fiber whose dashpots are all tau K: its modes are those of the fiber without.
dem::Fiber retarded_fiber(int bonds, double tau_over_t_b) {
  dem::Fiber fiber = compare::nominal_fiber(bonds, 0.17, BondModel::paper);
  fiber.bond_damping = 0;
  fiber.dashpots = dem::DashpotLaw::retardation_time;
  fiber.retardation_time = tau_over_t_b * dem::bond_time_step(fiber);
  return fiber;
}

compare::ModeRun mode_run(double tau_over_t_b, int mode, double part_of_period,
                          BondForm form = BondForm::incremental) {
  return {.chain = {.fiber = retarded_fiber(13, tau_over_t_b),
                    .form = form,
                    .scheme = Integrator::leapfrog_stiff},
          .mode = mode,
          .part_of_period = part_of_period};
}

}  // namespace

BOOST_AUTO_TEST_CASE(marched_modes_have_the_root_of_their_oscillator) {
  for (const auto form : {BondForm::incremental, BondForm::total}) {
    for (const int mode : {0, 1, 4}) {
      for (const double steps_in_period : {90.0, 11.0, 1.3}) {
        const auto marched = compare::marched_mode(mode_run(0.3, mode, 1 / steps_in_period, form));
        const auto expected = reference::step_root(stiff_scheme, marched.angle, marched.damping);
        BOOST_TEST(std::abs(marched.z - expected) < 1e-6,
                   "mode " << mode << ", T/" << steps_in_period << ": " << marched.z << expected);
      }
    }
  }
}

// What a user sees: the damping ratio of the first mode at T/90 and its law.
BOOST_AUTO_TEST_CASE(damping_ratio_and_period_are_off_by_their_laws) {
  for (const double steps_in_period : {180.0, 90.0, 45.0}) {
    const auto marched = compare::marched_mode(mode_run(20, 0, 1 / steps_in_period));
    const auto law = reference::error_law(stiff_scheme, marched.angle, marched.damping);
    BOOST_TEST(marched.damping_error() == law.damping, boost::test_tools::tolerance(0.03));
    BOOST_TEST(marched.frequency_error() == law.frequency, boost::test_tools::tolerance(0.03));
    if (steps_in_period == 90) BOOST_TEST(std::abs(marched.damping_error()) < 0.001);
  }
}

BOOST_AUTO_TEST_CASE(no_motion_grows_at_ten_to_a_thousand_bond_times) {
  const auto all = points({.aspect_ratio = {5, 20},
                           .poisson_ratio = {-0.2, 0.49},
                           .bond_damping = {0, 0.1, 1, 10},
                           .ends = {ChainEnds::clamped_free, ChainEnds::free_free},
                           .dimension = {2, 3},
                           .form = {BondForm::incremental, BondForm::total}});
  BOOST_REQUIRE(all.size() == 2 * 2 * 4 * 2 * 2 * 2 * 2);
  for (const GrowthPoint& point : all) {
    BOOST_REQUIRE(point.at.size() == 3);
    for (const Growth& growth : point.at) {
      const auto& c = point.asked.chain;
      BOOST_TEST_CONTEXT(dem::name(c.form) << " r_f " << c.aspect_ratio << " nu " << c.poisson_ratio
                                           << " xi_b " << c.bond_damping << " dim " << c.dimension << " at "
                                           << growth.step_ratio << " t_b") {
        BOOST_TEST(growth.modes < 1 + 1e-10);
        if (c.bond_damping == 0 || c.ends == ChainEnds::free_free) BOOST_TEST(growth.modes > 1 - 1e-10);
        if (c.bond_damping > 0 && c.ends == ChainEnds::clamped_free) BOOST_TEST(growth.modes < 1 - 1e-8);
        BOOST_TEST(!growth.grows());
        BOOST_TEST(std::abs(growth.measured - growth.modes) < compare::growth_margin(growth.steps));
      }
    }
  }
}

// At r_f = 5 the slowest motion dies within the run. No run may die more slowly; where others die nearly as
// slowly it seems a little faster.
BOOST_AUTO_TEST_CASE(a_run_dies_out_as_fast_as_the_slowest_mode) {
  int seen = 0;
  for (const GrowthPoint& point : points({.aspect_ratio = {5}, .bond_damping = {0.3, 3}})) {
    for (const Growth& growth : point.at) {
      if (growth.modes > 0.999 || growth.steps < 500) continue;
      BOOST_TEST(std::log(growth.measured) / std::log(growth.modes) > 0.97);
      BOOST_TEST(std::log(growth.measured) / std::log(growth.modes) < 1.2);
      ++seen;
    }
  }
  BOOST_TEST(seen >= 10);
}

BOOST_AUTO_TEST_CASE(longest_fibers_are_stable_too) {
  for (const GrowthPoint& point : points({.aspect_ratio = {200},
                                  .poisson_ratio = {0.3},
                                  .bond_damping = {0, 1},
                                  .bond = {BondModel::corrected}})) {
    for (const Growth& growth : point.at) {
      BOOST_TEST(!growth.grows());
      BOOST_TEST(std::abs(growth.measured - growth.modes) < compare::growth_margin(growth.steps));
      BOOST_TEST(growth.modes < 1 + 1e-10);
      BOOST_TEST(growth.modes > 1 - 1e-5);
    }
  }
}

BOOST_AUTO_TEST_CASE(tables_notes_and_threads) {
  const compare::StabilitySweep sweep{
      .aspect_ratio = {4}, .poisson_ratio = {0.1}, .bond_damping = {0.2, 2}, .step_ratio = {7, 50}};
  BOOST_TEST(compare::cases(sweep).size() == 8);
  const auto cases = compare::growth_cases(sweep);
  BOOST_TEST(cases.size() == 4);
  const auto one = compare::growth_points(cases, {.jobs = 1}),
             three = compare::growth_points(cases, {.jobs = 3});
  const dem::Table table = compare::growth_table(one);
  BOOST_TEST((table.rows() == compare::growth_table(three).rows()));
  BOOST_REQUIRE(table.rows().size() == 8);
  BOOST_TEST(table.number(1, "step_ratio") == 50);
  BOOST_TEST(table.text(0, "scheme") == "leapfrog-stiff");
  BOOST_TEST(table.text(0, "growth_verdict") == "stable");
  BOOST_TEST(compare::growth_notes(one).find("of 8 runs 0 grew") != std::string::npos);
  BOOST_TEST(compare::growth_notes({}).empty());
}

// Pulled at its free end, which halves what the endless chain bears.
BOOST_AUTO_TEST_CASE(a_pulled_run_grows_where_its_modes_do) {
  const dem::Fiber fiber = compare::nominal_fiber(40, 0.17, BondModel::paper);
  const reference::LinearChain chain = compare::linear_chain_of(fiber);
  const double strain = 1e-3, tension = strain * chain.stiffness.stretch * chain.spacing;
  const double limit =
      reference::finite_stable_step(chain, stiff_scheme, ChainEnds::clamped_free, true, tension);
  BOOST_TEST(limit / reference::tension_limited_step(chain, dem::stiff_beta, tension) == 0.6,
             boost::test_tools::tolerance(0.2));
  const auto largest_kick = [&](double dt) {
    dem::ChainBatch<2> block(
        {dem::straight_chain<2>(fiber)}, {true, false}, {dt}, {0.0},
        compare::planar_physics({.fiber = fiber, .form = BondForm::total, .scheme = stiff.scheme}),
        dem::best_instruction_set());
    const dem::Boundary<2> pulled{{0}, {{fiber.aspect_ratio, {tension, 0}, {}}}};
    block.set_ramp(0, pulled, pulled, 1);
    for (int i = 1; i <= fiber.aspect_ratio; ++i) {
      auto sphere = block.sphere(0, i);
      sphere.pose.position.c[0] *= 1 + strain;
      sphere.velocity.c[1] = 1e-9 * dem::bond_length(fiber) / dt * (i % 3 - 1);
      block.set_sphere(0, i, sphere);
    }
    block.synchronize();
    double largest = 0;
    for (int n = 0; n < 1000 && largest < 1e-3; ++n) {
      block.march(1);
      largest = std::max(largest, std::abs(block.sphere(0, fiber.aspect_ratio).velocity.c[1]) * dt /
                                      dem::bond_length(fiber));
    }
    return largest;
  };
  BOOST_TEST(largest_kick(0.9 * limit) < 1e-6);
  BOOST_TEST(largest_kick(1.1 * limit) > 1e-3);
}

BOOST_AUTO_TEST_CASE(dem_and_reference_know_the_same_step_for_a_tension) {
  for (const double nu : {-0.2, 0.3}) {
    const dem::Fiber fiber = compare::nominal_fiber(13, nu, BondModel::paper);
    const reference::LinearChain chain = compare::linear_chain_of(fiber);
    for (const double beta : {0.27, 0.3}) {
      for (const double strain : {1e-3, 1e-2}) {
        const double tension = strain * chain.stiffness.stretch * chain.spacing;
        const double own = dem::step_for_tension(fiber, tension, beta, {true, false});
        const double other = reference::finite_stable_step(chain, reference::bonds_in_step(beta),
                                                           reference::ChainEnds::clamped_free, true, tension);
        // dem has the stiffness of the drawn bond
        BOOST_TEST_MESSAGE("beta " << beta << " strain " << strain << ": step off by " << own / other - 1);
        BOOST_TEST(std::abs(own / other - 1) < 2 * strain);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto growth = [](compare::StabilityCase chain, double ratio) {
    return compare::growth_points({{chain, {ratio}}});
  };
  compare::StabilityCase chain = stiff;
  BOOST_CHECK_THROW(growth(chain, 0), compare::InputError);
  chain.aspect_ratio = 201;
  BOOST_CHECK_THROW(growth(chain, 10), compare::InputError);
  chain = stiff;
  chain.bond_damping = -1;
  BOOST_CHECK_THROW(growth(chain, 10), dem::InvalidInput);
  BOOST_CHECK_THROW(growth({}, 10), compare::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
