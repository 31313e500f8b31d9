// Drag on every sphere of a fiber marched with inertia, against closed forms.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/dem/flow_cases.hpp"

BOOST_AUTO_TEST_SUITE(flow_drag_test)

namespace dem = fiberchain::dem;
using flowing::end_state;
using flowing::equal_times;
using flowing::fiber_of;
using flowing::order_of;
using flowing::path;
using flowing::straight_case;
using flowing::viscosity_of;

namespace {

template <int Dim>
dem::Boundary<Dim> weights(int spheres, const dem::Vec<double, Dim>& weight) {
  dem::Boundary<Dim> boundary;
  for (int i = 0; i < spheres; ++i) boundary.loads.push_back({i, weight, {}});
  return boundary;
}

/// Largest velocity and spin times R on a path against those of a single sphere, over the largest.
template <class Velocity, class Spin>
double single_sphere_error(const flowing::Path<3>& path, double R, const Velocity& velocity,
                           const Spin& spin) {
  double worst = 0, scale = 0;
  for (std::size_t n = 0; n < path.times.size(); ++n) {
    const double v = velocity(path.times[n]), w = spin(path.times[n]);
    scale = std::max(scale, std::abs(v));
    for (std::size_t i = 0; i < path.states[n].poses.size(); ++i) {
      worst = std::max(
          {worst, std::abs(path.states[n].velocity[i][1] - v), R * std::abs(path.states[n].spin[i][0] - w)});
    }
  }
  return worst / scale;
}

/// x' = rate (goal(t) - x) where the goal is start-up as 1 - exp(-a t), from 0.
double after_start_up(double rate, double a, double t) {
  return -std::expm1(-rate * t) - rate / (rate - a) * (std::exp(-a * t) - std::exp(-rate * t));
}

/// The same where the goal is cos(w t + phase), from cos(phase).
double in_oscillation(double rate, double w, double phase, double t) {
  using namespace std::complex_literals;
  const std::complex<double> steady = rate / (rate + 1i * w) * std::exp(1i * phase);
  return (steady * std::exp(1i * w * t)).real() + (std::cos(phase) - steady.real()) * std::exp(-rate * t);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_falling_fiber_approaches_the_terminal_velocity_as_a_single_sphere) {
  const dem::Fiber fiber = fiber_of(7);
  const double m = dem::sphere_mass(fiber), t_b = dem::bond_time_step(fiber);
  for (const double rate : {0.003 / t_b, 0.7 / t_b, 40 / t_b}) {
    auto flow = straight_case<3>(fiber, {viscosity_of(fiber, rate), {}}, 0.3, 0.4);
    const double g = 1e-4 * dem::bond_length(fiber) / (t_b * t_b), speed = g / rate;
    flow.boundary = weights<3>(8, {0.36 * m * g, 0.48 * m * g, 0.8 * m * g});
    const auto fall = path(flow, equal_times(6 / rate, 7));
    for (std::size_t n = 0; n < fall.times.size(); ++n) {
      const double expected = -std::expm1(-rate * fall.times[n]) * speed;
      for (const auto& v : fall.states[n].velocity) {
        BOOST_TEST(std::abs(v[0] / (0.36 * expected) - 1) < 1e-11);
        BOOST_TEST(std::abs(v[2] / (0.8 * expected) - 1) < 1e-11);
      }
    }
  }
}

// Loads on one sphere only: at rest in its own frame the chain's drag is 6 pi mu R N U.
BOOST_AUTO_TEST_CASE(a_pulled_fiber_has_the_drag_of_all_its_spheres_the_ends_included) {
  for (const int bonds : {1, 2, 13}) {
    const dem::Fiber fiber = fiber_of(bonds, 0.4);
    const double t_b = dem::bond_time_step(fiber), l = dem::bond_length(fiber);
    auto flow = straight_case<2>(fiber, {viscosity_of(fiber, 0.2 / t_b), {}}, 0.9);
    const double F = 1e-6 * dem::axial_stiffness(fiber);
    flow.boundary.loads = {{bonds, {F * std::cos(0.9), F * std::sin(0.9)}, {}}};
    const dem::StokesDrag drag = dem::stokes_drag(flow.fluid, fiber);
    const auto state = end_state(flow, {900 * t_b * (1 + bonds)});
    double total = 0;
    for (const auto& v : state.velocity)
      total += drag.translation * (v[0] * std::cos(0.9) + v[1] * std::sin(0.9));
    BOOST_TEST(std::abs(total / F - 1) < 1e-9);
    for (const auto& v : state.velocity) {
      BOOST_TEST(std::abs(dem::norm(v) * drag.translation * (bonds + 1) / F - 1) < 1e-6);
    }
    BOOST_TEST(dem::norm(state.poses[bonds].position - state.poses[0].position) > bonds * l);
  }
}

BOOST_AUTO_TEST_CASE(a_couple_turns_a_stiff_fiber_against_the_drag_and_torque_of_every_sphere) {
  for (const int bonds : {1, 6}) {
    const dem::Fiber fiber = fiber_of(bonds, 0.4);
    const double t_b = dem::bond_time_step(fiber), l = dem::bond_length(fiber);
    auto flow = straight_case<3>(fiber, {viscosity_of(fiber, 0.5 / t_b), {}}, 0.2, 0.0);
    const dem::StokesDrag drag = dem::stokes_drag(flow.fluid, fiber);
    const double M = 1e-7 * dem::bond_stiffness(fiber).bend, half = 0.5 * bonds;
    flow.boundary.loads = {{bonds, {}, {0, 0, M}}};
    double resistance = 0;
    for (int i = 0; i <= bonds; ++i)
      resistance += drag.rotation + drag.translation * l * l * (i - half) * (i - half);
    for (const auto& w : end_state(flow, {4000 * t_b}).spin) {
      BOOST_TEST(std::abs(w[2] * resistance / M - 1) < 1e-5);
      BOOST_TEST(std::abs(w[0] * resistance / M) < 1e-9);
    }
  }
}

// A chain along x at z = h in u = (0, g(t) z, 0): all its spheres move and spin as one alone, whatever the
// bonds.
BOOST_AUTO_TEST_CASE(start_up_and_oscillation_move_a_sphere_as_the_closed_forms_at_second_order) {
  const dem::Fiber fiber = fiber_of(3);
  const double R = dem::sphere_radius(fiber), t_b = dem::bond_time_step(fiber), rate = 0.05 / t_b,
               h = 3.1 * R;
  const double turn = rate * dem::stokes_drag({1, {}}, fiber).rotation /
                      dem::stokes_drag({1, {}}, fiber).translation * dem::sphere_mass(fiber) /
                      dem::sphere_inertia(fiber);
  const double g = 1e-3 / t_b, a = 0.021 / t_b, w = 0.08 / t_b, phase = 0.7;
  const dem::Gradient A{{{0, 0, 0}, {0, 0, g}, {0, 0, 0}}};
  const auto error = [&](const dem::Flow& unsteady, double ratio, const auto& goal) {
    auto flow = straight_case<3>(fiber, {viscosity_of(fiber, rate), unsteady}, 0);
    for (auto& pose : flow.start) pose.position[2] += h;
    dem::FlowOptions options;
    options.step_ratio = ratio;
    return single_sphere_error(
        path(flow, equal_times(100 * t_b, 10), options), R, [&](double t) { return g * h * goal(rate, t); },
        [&](double t) { return -0.5 * g * goal(turn, t); });
  };
  const auto start = [&](double c, double t) { return after_start_up(c, a, t); };
  const auto swing = [&](double c, double t) { return in_oscillation(c, w, phase, t); };
  const dem::Flow starting = dem::start_up(A, 1 / a),
                  swinging = dem::oscillation(A, 2 * std::numbers::pi / w, phase);
  BOOST_TEST(error(starting, 0.1, start) < 1e-5);
  BOOST_TEST(error(swinging, 0.1, swing) < 1e-4);
  BOOST_TEST(std::abs(order_of(error(starting, 0.4, start), error(starting, 0.2, start)) - 2) < 0.1);
  BOOST_TEST(std::abs(order_of(error(swinging, 0.4, swing), error(swinging, 0.2, swing)) - 2) < 0.1);
}

// x'' = c (A x - x') of every sphere by itself, where bonds are too soft to matter.
BOOST_AUTO_TEST_CASE(without_bonds_every_sphere_moves_by_itself) {
  const dem::Fiber fiber = fiber_of(4, 0, 1e-20);
  constexpr double c = 0.9, g = 0.31, end = 7;
  dem::Fluid fluid{viscosity_of(fiber, c), {dem::simple_shear(g)}};
  const auto flow = straight_case<2>(fiber, fluid, 1.1);
  const auto state = end_state(flow, equal_times(end, 7000));
  const double drag_ratio = dem::stokes_drag(fluid, fiber).rotation / dem::sphere_inertia(fiber);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    const auto x = flow.start[i].position;
    // u is constant along a streamline: a sphere that starts with it stays on it
    BOOST_TEST(std::abs(state.poses[i].position[0] - x[0] - g * x[1] * end) < 1e-12);
    BOOST_TEST(std::abs(state.spin[i][0] + 0.5 * g) < 1e-12);
  }
  BOOST_TEST(drag_ratio > c);
  auto turning = flow;
  turning.fluid.flow = {dem::solid_rotation(g)};
  const auto spiral = end_state(turning, equal_times(end, 7000));
  // z'' + c z' - i c g z = 0 in the complex plane, from z' = i g z
  using namespace std::complex_literals;
  const std::complex<double> root = std::sqrt(std::complex<double>(c * c, 4 * c * g));
  const std::complex<double> p = 0.5 * (-c + root), q = 0.5 * (-c - root);
  const std::complex<double> growth =
      ((1i * g - q) * std::exp(p * end) - (1i * g - p) * std::exp(q * end)) / (p - q);
  for (std::size_t i = 0; i < spiral.poses.size(); ++i) {
    const auto x = flow.start[i].position;
    const std::complex<double> z = growth * std::complex<double>(x[0], x[1]);
    BOOST_TEST(std::abs(std::complex<double>(spiral.poses[i].position[0], spiral.poses[i].position[1]) - z) <
               1e-6 * dem::fiber_length(fiber));
  }
}

BOOST_AUTO_TEST_CASE(in_solid_rotation_a_fiber_turns_as_the_fluid_does) {
  const dem::Fiber fiber = fiber_of(6, 0.2);
  const double t_b = dem::bond_time_step(fiber), omega = 2e-4 / t_b;
  for (const double rate : {0.01 / t_b, 5 / t_b}) {
    const auto flow = straight_case<3>(fiber, {viscosity_of(fiber, rate), {dem::solid_rotation(omega)}}, 0.3);
    const double end = 2 * std::numbers::pi * 3.3 / omega;
    const auto state = end_state(flow, {end});
    const auto turned = flowing::inclined<3>(fiber, 0.3 + omega * end);
    for (std::size_t i = 0; i < turned.size(); ++i) {
      BOOST_TEST(dem::norm(state.poses[i].position - turned[i].position) < 1e-5 * dem::fiber_length(fiber));
      BOOST_TEST(dem::norm(dem::axis(state.poses[i]) - dem::axis(turned[i])) < 1e-5);
      BOOST_TEST(std::abs(state.spin[i][2] / omega - 1) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_stiff_chain_tumbles_as_jefferys_ellipsoid) {
  const dem::Fiber fiber = fiber_of(4);
  const double t_b = dem::bond_time_step(fiber), shear = 1e-4 / t_b, N = 5;
  const auto flow = straight_case<2>(fiber, {viscosity_of(fiber, 0.3 / t_b), {dem::simple_shear(shear)}},
                                     std::numbers::pi / 2);
  const double r_e = std::sqrt((N * N + 1) / 2), period = 2 * std::numbers::pi * (r_e + 1 / r_e) / shear;
  const auto way = path(flow, equal_times(period, 11));
  for (std::size_t n = 0; n < way.times.size(); ++n) {
    // angle from the gradient: tan = r_e tan(2 pi t / T)
    const double phase = 2 * std::numbers::pi * way.times[n] / period;
    const dem::Vec<double, 2> axis{r_e * std::sin(phase), std::cos(phase)};
    const auto ends = way.states[n].poses.back().position - way.states[n].poses.front().position;
    BOOST_TEST(std::abs(dem::cross((1 / dem::norm(axis)) * axis, (1 / dem::norm(ends)) * ends)[0]) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_clamped_sphere_stays_and_the_rest_feels_the_stream) {
  const dem::Fiber fiber = fiber_of(9, 0.3);
  const double t_b = dem::bond_time_step(fiber);
  for (const auto set : {dem::InstructionSet::scalar, dem::best_instruction_set()}) {
    auto flow =
        straight_case<2>(fiber, {viscosity_of(fiber, 0.2 / t_b), {dem::simple_shear(2e-4 / t_b)}}, 1.57);
    flow.boundary.clamped = {0};
    dem::FlowOptions options;
    options.instruction_set = set;
    const auto state = end_state(flow, {20000 * t_b}, options);
    BOOST_TEST(dem::norm(state.poses[0].position - flow.start[0].position) == 0.0);
    BOOST_TEST(state.poses[0].orientation == flow.start[0].orientation);
    const auto moved = state.poses[9].position - flow.start[9].position;
    BOOST_TEST(dem::norm(moved) > 0.01 * dem::fiber_length(fiber));
    for (const auto& v : state.velocity) BOOST_TEST(dem::norm(v) < 1e-6 * dem::bond_length(fiber) / t_b);
  }
}

BOOST_AUTO_TEST_SUITE_END()
