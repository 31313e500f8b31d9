// Fibers marched in a fluid: order of the scheme, CVODE, momentum, and no fluid as the limit.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/flow_cases.hpp"

BOOST_AUTO_TEST_SUITE(flow_order_test)

namespace dem = fiberchain::dem;
using flowing::end_state;
using flowing::equal_times;
using flowing::fiber_of;
using flowing::order_of;
using flowing::path;
using flowing::straight_case;
using flowing::viscosity_of;

namespace {

/// A soft fiber that bends while it tumbles, with times that ask for steps of different length.
template <int Dim>
double tumbling_order(dem::BondForm form) {
  const dem::Fiber fiber = fiber_of(11);
  const double t_b = dem::bond_time_step(fiber), rate = 0.4 / t_b, shear = 0.06 / t_b;
  auto flow = straight_case<Dim>(fiber, {viscosity_of(fiber, rate), {dem::simple_shear(shear)}}, 1.9, 0.5);
  const auto at = [&](double ratio) {
    dem::FlowOptions options;
    options.form = form;
    options.step_ratio = ratio;
    return end_state(flow, {73 * t_b, 100 * t_b, 164 * t_b}, options);
  };
  const auto coarse = at(0.1), middle = at(0.05), fine = at(0.025);
  double bend = 0;
  for (std::size_t i = 0; i + 1 < fine.poses.size(); ++i) {
    bend = std::max(bend, dem::norm(dem::axis(fine.poses[i + 1]) - dem::axis(fine.poses[i])));
  }
  BOOST_TEST(bend > 0.02);
  BOOST_TEST_MESSAGE("bend per bond " << bend << ", change at half the step "
                                      << flowing::distance(middle, fine, fiber));
  return order_of(flowing::distance(coarse, middle, fiber), flowing::distance(middle, fine, fiber));
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_undamped_fiber_in_shear_is_marched_at_second_order) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const double order : {tumbling_order<2>(form), tumbling_order<3>(form)}) {
      BOOST_TEST_MESSAGE(dem::name(form) << ": observed order " << order);
      BOOST_TEST(std::abs(order - 2) < 0.1);
    }
  }
}

namespace {

/// Distance at the end from CVODE, which knows neither lanes nor half steps, at a step and at half of it.
template <int Dim>
std::pair<double, double> distance_from_cvode(double damping, double rate_ratio) {
  const dem::Fiber fiber = fiber_of(6, damping);
  const double t_b = dem::bond_time_step(fiber);
  const dem::Flow swing = dem::oscillation(dem::simple_shear(0.04 / t_b), 71 * t_b, 0.4);
  auto flow = straight_case<Dim>(fiber, {viscosity_of(fiber, rate_ratio / t_b), swing}, 1.9, 0.5);
  flow.boundary.loads = {{2, {}, {}}};
  flow.boundary.loads[0].force[0] = dem::load_force(fiber, 0.7);
  const std::vector<double> times{20 * t_b, 90 * t_b};
  dem::FlowOptions cvode;
  cvode.method = dem::FlowMethod::cvode;
  cvode.tolerance = 1e-12;
  dem::ChainState<Dim> expected;
  dem::integrate_in_flow<Dim>(flow, times, cvode,
                              [&](double, const dem::ChainState<Dim>& state) { expected = state; });
  const auto off = [&](double ratio) {
    dem::FlowOptions options;
    options.step_ratio = ratio;
    return flowing::distance(end_state(flow, times, options), expected, fiber);
  };
  return damping > 0 ? std::pair{off(0.004), off(0.002)} : std::pair{off(0.02), off(0.01)};
}

}  // namespace

// Where a step outlasts the memory of the velocity, c dt / m >> 1, the scheme is Euler's.
BOOST_AUTO_TEST_CASE(a_step_longer_than_the_drags_memory_is_of_first_order_and_still_accurate) {
  for (const double rate_ratio : {30.0, 3e4}) {
    const dem::Fiber fiber = fiber_of(10);
    const double t_b = dem::bond_time_step(fiber), shear = 2e-3 / (t_b * rate_ratio);
    const auto flow =
        straight_case<2>(fiber, {viscosity_of(fiber, rate_ratio / t_b), {dem::simple_shear(shear)}}, 1.9);
    dem::FlowOptions cvode;
    cvode.method = dem::FlowMethod::cvode;
    cvode.tolerance = 1e-11;
    dem::ChainState<2> expected;
    dem::integrate_in_flow<2>(flow, {3 / shear}, cvode,
                              [&](double, const dem::ChainState<2>& state) { expected = state; });
    const auto off = [&](double part) {
      dem::FlowOptions options;
      options.step_ratio = part * dem::stable_time_step(fiber, flow.fluid) / t_b;
      return flowing::distance(end_state(flow, {3 / shear}, options), expected, fiber);
    };
    const double coarse = off(0.8), fine = off(0.4);
    BOOST_TEST(std::abs(order_of(coarse, fine) - 1) < 0.1);
    BOOST_TEST(coarse < 2e-4);
  }
}

BOOST_AUTO_TEST_CASE(the_march_becomes_cvodes_solution_as_the_step_vanishes) {
  for (const double damping : {0.0, 1.3}) {
    for (const double rate_ratio : {0.05, 0.8}) {
      for (const auto distance : {distance_from_cvode<2>, distance_from_cvode<3>}) {
        const auto [coarse, fine] = distance(damping, rate_ratio);
        BOOST_TEST_MESSAGE("damping " << damping << ", drag rate " << rate_ratio << " / t_b: " << coarse
                                      << " " << fine);
        // lagged dashpots are of first order
        BOOST_TEST(std::abs(order_of(coarse, fine) - (damping > 0 ? 1 : 2)) < 0.1);
        BOOST_TEST(fine < 2e-6);
      }
    }
  }
}

namespace {

/// Momentum and angular momentum about the origin, and what the fluid gives a second.
template <int Dim>
struct Account {
  dem::Vec<double, Dim> momentum{}, force{};
  dem::Spin<double, Dim> angular{}, torque{};
};

template <int Dim>
Account<Dim> account(const dem::FlowCase<Dim>& flow, const dem::ChainState<Dim>& state, double time) {
  const dem::Fiber& fiber = flow.chain.fiber;
  const double m = dem::sphere_mass(fiber), J = dem::sphere_inertia(fiber);
  const dem::StokesDrag drag = dem::stokes_drag(flow.fluid, fiber);
  const dem::Gradient A = dem::gradient_at(flow.fluid.flow, time);
  Account<Dim> sum;
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    const auto& x = state.poses[i].position;
    const auto force = drag.translation * (dem::velocity_at<Dim>(A, x) - state.velocity[i]);
    sum.momentum = sum.momentum + m * state.velocity[i];
    sum.force = sum.force + force;
    sum.angular = sum.angular + m * dem::cross(x, state.velocity[i]) + J * state.spin[i];
    sum.torque = sum.torque + dem::cross(x, force) + drag.rotation * (dem::spin_of<Dim>(A) - state.spin[i]);
  }
  return sum;
}

/// Change of momentum (angular momentum) less the fluid's impulse by the trapezoidal rule, over its size.
template <int Dim>
std::pair<double, double> imbalance(double ratio, double damping) {
  const dem::Fiber fiber = fiber_of(5, damping);
  const double t_b = dem::bond_time_step(fiber), rate = 0.08 / t_b;
  auto flow =
      straight_case<Dim>(fiber, {viscosity_of(fiber, rate), {dem::simple_shear(0.02 / t_b)}}, 1.9, 0.5);
  for (auto& pose : flow.start) pose.position[1] += 2.3 * dem::bond_length(fiber);
  flow.fluid.flow = dem::oscillation(dem::simple_shear(0.02 / t_b), 47 * t_b, 0.4);
  dem::FlowOptions options;
  options.step_ratio = ratio;
  std::vector<double> times{0};
  for (const double t : equal_times(60 * t_b, static_cast<int>(std::lround(60 / ratio)))) times.push_back(t);
  const auto way = path(flow, times, options);
  std::vector<Account<Dim>> accounts;
  for (std::size_t n = 0; n < way.times.size(); ++n)
    accounts.push_back(account(flow, way.states[n], way.times[n]));
  auto momentum = accounts[0].momentum - accounts.back().momentum;
  auto angular = accounts[0].angular - accounts.back().angular;
  double scale = 0, angular_scale = 0;
  for (std::size_t n = 1; n < accounts.size(); ++n) {
    const double half = 0.5 * (way.times[n] - way.times[n - 1]);
    const auto impulse = half * (accounts[n - 1].force + accounts[n].force);
    const auto twist = half * (accounts[n - 1].torque + accounts[n].torque);
    momentum = momentum + impulse, angular = angular + twist;
    scale += dem::norm(impulse), angular_scale += dem::norm(twist);
  }
  return {dem::norm(momentum) / scale, dem::norm(angular) / angular_scale};
}

}  // namespace

BOOST_AUTO_TEST_CASE(momentum_changes_by_the_drag_of_the_spheres) {
  for (const double damping : {0.0, 0.3}) {
    for (const auto balance : {imbalance<2>, imbalance<3>}) {
      const auto coarse = balance(0.2, damping), fine = balance(0.1, damping);
      BOOST_TEST_MESSAGE("momentum " << coarse.first << " " << fine.first << ", angular " << coarse.second
                                     << " " << fine.second);
      BOOST_TEST(fine.first < 2e-5);
      BOOST_TEST(fine.second < 1e-4);
      BOOST_TEST(std::abs(order_of(coarse.first, fine.first) - 2) < 0.1);
      BOOST_TEST(std::abs(order_of(coarse.second, fine.second) - 2) < 0.1);
    }
  }
}

namespace {

/// What a fluid of that drag changes of a chain's end, over its length; without it the same march in vacuum.
template <int Dim>
double change_by_fluid(double rate_ratio, dem::BondForm form) {
  const dem::Fiber fiber = fiber_of(6);
  const double t_b = dem::bond_time_step(fiber), step = 0.5 * dem::stable_time_step(fiber);
  auto flow = straight_case<Dim>(
      fiber, {viscosity_of(fiber, rate_ratio / t_b), {dem::planar_extension(0.01 / t_b)}}, 0.7, 0.3);
  flow.start[2].position[1] += 0.01 * dem::bond_length(fiber);
  dem::ChainBatch<Dim> block(
      {flow.chain}, {false, false}, {step}, {0.0},
      {.dimension = Dim, .form = form, .damped = false, .settling_damping = false, .curved = false},
      dem::InstructionSet::scalar);
  dem::ChainState<Dim> start = dem::at_rest<Dim>(flow.start);
  for (std::size_t i = 0; i < start.poses.size(); ++i) {
    start.velocity[i] = dem::velocity_at<Dim>(flow.fluid.flow.gradient, start.poses[i].position);
  }
  dem::put_state(block, 0, flow.chain, start);
  block.synchronize();
  block.march(150);
  dem::FlowOptions options;
  options.form = form;
  options.step_ratio = step / t_b;
  options.instruction_set = dem::InstructionSet::scalar;
  return flowing::distance(end_state(flow, {150 * step}, options), dem::state_now(block, 0, 7), fiber);
}

}  // namespace

BOOST_AUTO_TEST_CASE(as_the_viscosity_vanishes_the_march_becomes_that_without_fluid) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const auto change : {change_by_fluid<2>, change_by_fluid<3>}) {
      const double coarse = change(1e-6, form), fine = change(5e-7, form);
      BOOST_TEST(std::abs(order_of(coarse, fine) - 1) < 0.02);
      BOOST_TEST(coarse < 1e-4);
      BOOST_TEST(change(1e-14, form) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
