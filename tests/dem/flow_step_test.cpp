// The stable step in a fluid, of the scheme and of chains that run.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/relaxation.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/flow_cases.hpp"

BOOST_AUTO_TEST_SUITE(flow_step_test)

namespace dem = fiberchain::dem;
using flowing::viscosity_of;

namespace {

/// Whether a tiny random motion of a straight chain in a fluid at rest grows by 1e6 in so many steps.
template <int Dim>
bool grows(const dem::Fiber& fiber, const dem::Fluid& fluid, dem::BondForm form, double step, int steps) {
  const auto chain = dem::straight_chain<Dim>(fiber);
  dem::ChainBatch<Dim> block({chain}, {false, false}, {step}, {0.0},
                             {.dimension = Dim,
                              .form = form,
                              .damped = dem::damped(fiber),
                              .settling_damping = false,
                              .curved = false,
                              .fluid = true},
                             dem::InstructionSet::scalar);
  block.set_fluid(0, fluid);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double l = dem::bond_length(fiber), size = 1e-10;
  auto state = dem::at_rest<Dim>(chain.poses);
  for (auto& pose : state.poses) {
    for (double& x : pose.position.c) x += size * l * uniform(generator);
  }
  dem::put_state(block, 0, chain, state);
  block.synchronize();
  block.march(steps);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    if (!(dem::norm(block.sphere(0, i).pose.position - chain.poses[i].position) < 1e6 * size * l))
      return true;
  }
  return false;
}

/// The largest step that does not grow, to 1 in 400, looked for around a guess.
template <int Dim>
double measured_limit(const dem::Fiber& fiber, const dem::Fluid& fluid, dem::BondForm form, double guess) {
  double low = 0.5 * guess, high = 2 * guess;
  BOOST_TEST(!grows<Dim>(fiber, fluid, form, low, 4000));
  BOOST_TEST(grows<Dim>(fiber, fluid, form, high, 4000));
  while (high > 1.0025 * low) {
    const double middle = std::sqrt(low * high);
    (grows<Dim>(fiber, fluid, form, middle, 4000) ? high : low) = middle;
  }
  return low;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_step_of_drag_is_exact) {
  for (const double exponent : {1e-9, 0.37, 4.1, 900.0}) {
    const auto step = dem::relaxation(2.3, 0.7, exponent * 0.7 / 2.3);
    BOOST_TEST(std::abs(step.keep - std::exp(-exponent)) <= 1e-15);
    BOOST_TEST(std::abs(step.follow / -std::expm1(-exponent) - 1) < 1e-14);
    BOOST_TEST(std::abs(step.gain * 2.3 / step.follow - 1) < 1e-15);
    const auto half = dem::relaxation(2.3, 0.7, exponent * 0.35 / 2.3);
    BOOST_TEST(std::abs(half.keep * half.gain + half.gain - step.gain) < 1e-14 * step.gain);
  }
  BOOST_TEST(dem::relaxation(0, 0.7, 1.4).gain == 2.0);
  BOOST_TEST(dem::relaxation(1e-12, 0.7, 1.4).gain == 2.0, boost::test_tools::tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(without_drag_as_before_and_with_much_drag_twice_drag_over_stiffness) {
  for (const double damping : {0.0, 0.3, 2.0}) {
    const dem::Fiber fiber = flowing::fiber_of(9, damping);
    const double t_b = dem::bond_time_step(fiber);
    const double vacuum = dem::stable_time_step(fiber);
    BOOST_TEST(std::abs(dem::stable_time_step(fiber, {viscosity_of(fiber, 1e-9 / t_b), {}}) / vacuum - 1) <
               1e-7);
    double before = vacuum;
    for (const double rate : {0.1, 1.0, 10.0, 100.0}) {
      const double limit = dem::stable_time_step(fiber, {viscosity_of(fiber, rate / t_b), {}});
      BOOST_TEST(limit > before);
      before = limit;
    }
  }
  const dem::Fiber fiber = flowing::fiber_of(9);
  const dem::Fluid thick{viscosity_of(fiber, 1e4 / dem::bond_time_step(fiber)), {}};
  const double largest = 4 * dem::bond_stiffness(fiber).stretch;
  BOOST_TEST(std::abs(dem::stable_time_step(fiber, thick) * largest /
                          (2 * dem::stokes_drag(thick, fiber).translation) -
                      1) < 1e-3);
}

BOOST_AUTO_TEST_CASE(chains_that_run_grow_beyond_the_stable_step_and_not_below) {
  for (const double damping : {0.0, 0.4, 2.0}) {
    for (const double rate : {1e-6, 0.1, 1.0, 3.0, 20.0, 1e4}) {
      const dem::Fiber fiber = flowing::fiber_of(31, damping);
      const dem::Fluid fluid{viscosity_of(fiber, rate / dem::bond_time_step(fiber)), {}};
      const double limit = dem::stable_time_step(fiber, fluid);
      const double planar = measured_limit<2>(fiber, fluid, dem::BondForm::incremental, limit);
      const double spatial = measured_limit<3>(fiber, fluid, dem::BondForm::total, limit);
      BOOST_TEST_MESSAGE("damping " << damping << ", drag rate " << rate << " / t_b: limit "
                                    << limit / dem::bond_time_step(fiber) << " t_b, measured over it "
                                    << planar / limit << " planar, " << spatial / limit << " spatial");
      for (const double measured : {planar, spatial}) {
        BOOST_TEST(measured > 0.996 * limit);
        BOOST_TEST(measured < 1.015 * limit);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
