// The damped Elastica in time: its Jacobian, statics, linear limit, energy, amplitude-frequency relation,
// mass layout and refinement.
#include "reference/damped_elastica.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "reference/chain_modes.hpp"
#include "reference/damped_beam.hpp"
#include "reference/elastica.hpp"
#include "reference/elastica_motion.hpp"
#include "reference/errors.hpp"
#include "tests/reference/crossings.hpp"

BOOST_AUTO_TEST_SUITE(damped_elastica_test)

namespace ref = fiberchain::reference;
using ref::BeamHistory;
using ref::BeamLayout;
using ref::Release;
using ref::detail::ElasticaMotion;

namespace {

constexpr BeamLayout odd_layout{0.0071, 0.043, 0.0006, 0.0013};
constexpr Release loaded(double load) { return {Release::Shape::static_load, load}; }

std::vector<double> equal_times(double end, int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(end * i / samples);
  return times;
}

double total(const ref::BeamSample& s) { return s.kinetic + s.elastic + s.dissipated; }

double largest_distance(const BeamHistory& a, const BeamHistory& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    worst = std::max(worst, std::hypot(a.samples[i].y - b.samples[i].y, a.samples[i].x - b.samples[i].x));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(jacobian_is_the_derivative_of_the_right_hand_side) {
  const ElasticaMotion motion(odd_layout, 7);
  const auto size = static_cast<std::size_t>(motion.size());
  std::mt19937 generator(7);
  std::normal_distribution<> normal;
  std::vector<double> state(size);
  for (std::size_t i = 0; i < size; ++i)
    state[i] = normal(generator) * (i < 7 ? 0.3 : 2.0) / (1.0 + static_cast<double>(i % 7));
  std::vector<double> jacobian(size * size, 0.0);
  motion.jacobian(state, jacobian);
  const auto difference = [&](std::size_t column, double h) {
    std::vector<double> up = state, down = state, d_up(size), d_down(size);
    up[column] += h;
    down[column] -= h;
    motion.rhs(up, d_up);
    motion.rhs(down, d_down);
    for (std::size_t i = 0; i < size; ++i) d_up[i] = (d_up[i] - d_down[i]) / (2 * h);
    return d_up;
  };
  double worst = 0;
  double largest = 0;
  for (std::size_t j = 0; j < size; ++j) {
    const auto fine = difference(j, 1e-4);
    const auto coarse = difference(j, 2e-4);
    for (std::size_t i = 0; i < size; ++i) {
      const double exact = (4 * fine[i] - coarse[i]) / 3;  // Richardson
      worst = std::max(worst, std::abs(jacobian[i + size * j] - exact) / (1 + std::abs(exact)));
      largest = std::max(largest, std::abs(exact));
    }
  }
  BOOST_TEST_MESSAGE("Jacobian: largest relative difference " << worst << ", largest entry " << largest);
  BOOST_TEST(worst < 1e-6);
  BOOST_TEST(largest > 1000);
}

BOOST_AUTO_TEST_CASE(statics_equal_the_static_elastica_and_converge_spectrally) {
  for (const double load : {0.013, 1.0, 6.0, -3.7}) {
    const ref::TipState exact = ref::elastica_closed_form(std::abs(load));
    const double sign = load < 0 ? -1 : 1;
    const auto error = [&](int modes) {
      const auto s = ref::damped_elastica(odd_layout, loaded(load), {0}, {modes}).samples[0];
      return std::abs(s.y - sign * exact.y) + std::abs(s.x - exact.x) +
             std::abs(s.angle - sign * exact.angle);
    };
    BOOST_TEST(error(16) < 1e-13, "load " << load);
    if (std::abs(load) < 1) continue;
    BOOST_TEST(error(4) > 20 * error(6));
    BOOST_TEST(error(6) > 20 * error(8));
    if (std::abs(load) > 3) BOOST_TEST(error(8) > 20 * error(12));  // below, 8 modes are exact to rounding
    BOOST_TEST(error(4) > 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(linear_frequencies_are_the_beam_s) {
  const std::vector<double> omega = ref::beam_frequencies({}, 20);
  for (int k = 1; k <= 6; ++k) {
    const double beta = ref::clamped_free_beta(k);
    BOOST_TEST(omega[static_cast<std::size_t>(k - 1)] == beta * beta, boost::test_tools::tolerance(1e-9));
  }
  // tip mass: 1 + cos cosh + m beta (cos sinh - sin cosh) = 0
  for (const double mass : {0.05, 0.8}) {
    for (int k = 0; k < 4; ++k) {
      const double b = std::sqrt(ref::beam_frequencies({0, mass, 0, 0}, 20)[static_cast<std::size_t>(k)]);
      const double equation =
          1 / std::cosh(b) + std::cos(b) + mass * b * (std::cos(b) * std::tanh(b) - std::sin(b));
      BOOST_TEST(std::abs(equation) < 1e-9, "mass " << mass << " mode " << k + 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_body_at_the_tip_and_turning_sections_lower_the_frequencies) {
  // w = A (cosh - cos)(bs) + B (sinh - sin)(bs) with w'' = b^4 j w' and w''' = -b^4 m w at s = 1
  const double m = 0.31;
  const double j = 0.027;
  for (int k = 0; k < 4; ++k) {
    const double b = std::sqrt(ref::beam_frequencies({0, m, j, 0}, 20)[static_cast<std::size_t>(k)]);
    const double c = std::cos(b) / std::cosh(b);
    const double s = std::sin(b) / std::cosh(b);
    const double t = std::tanh(b);
    const double moment_a = 1 + c - b * b * b * j * (t + s);
    const double moment_b = t + s - b * b * b * j * (1 - c);
    const double force_a = t - s + b * m * (1 - c);
    const double force_b = 1 + c + b * m * (t - s);
    const double size = std::abs(moment_a * force_b) + std::abs(moment_b * force_a);
    BOOST_TEST(std::abs(moment_a * force_b - moment_b * force_a) < 1e-8 * size, "mode " << k + 1);
  }
  // small rotary inertia r: omega falls by r/2 int phi'^2 / int phi^2 = 4.647778319 r/2 (25-digit quadrature)
  const double r = 1e-6;
  const double fall = 1 - ref::beam_frequencies({0, 0, 0, r}, 14)[0] / ref::beam_frequencies({}, 14)[0];
  BOOST_TEST(fall == 4.647778319 * r / 2, boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(chain_layout_is_the_chain_s_own_numbers) {
  const auto chain = ref::linear_chain({7, 1.3, 2.6, 0.3, 1.1});
  const double length = 7 * chain.spacing;
  const double mu = chain.mass / chain.spacing;
  const double unit = std::sqrt(mu * std::pow(length, 4) / (chain.stiffness.bend * chain.spacing));
  const BeamLayout layout = ref::chain_layout(7, 0.7);
  const auto equal = boost::test_tools::tolerance(1e-13);
  BOOST_TEST(layout.tip_mass == chain.mass / 2 / (mu * length), equal);
  BOOST_TEST(layout.tip_inertia == chain.inertia / 2 / (mu * length * length * length), equal);
  BOOST_TEST(layout.rotary_inertia == chain.inertia / chain.spacing / (mu * length * length), equal);
  const double dashpot = ref::with_bond_damping(chain, 0.7).dashpot.bend;
  BOOST_TEST(layout.retardation == dashpot / chain.stiffness.bend / unit, equal);
  BOOST_TEST(ref::chain_time_unit(7) * ref::bond_time(chain) == unit, equal);
}

BOOST_AUTO_TEST_CASE(chain_layout_is_second_order_and_first_without_the_half_sphere) {
  // first undamped frequency of the chain over that of the beam, in the chain's bond times
  const auto error = [](int bonds, bool half_sphere) {
    BeamLayout layout = ref::chain_layout(bonds, 0);
    if (!half_sphere) layout.tip_mass = layout.tip_inertia = 0;
    const auto chain = ref::linear_chain({bonds, 1.3, 2.6, 0.3, 1.1});
    const double unit = ref::chain_time_unit(bonds) * ref::bond_time(chain);
    return std::abs(ref::first_bending_mode(chain).frequency * unit / ref::beam_frequencies(layout)[0] - 1);
  };
  const double with = std::log2(error(20, true) / error(40, true));
  const double without = std::log2(error(20, false) / error(40, false));
  BOOST_TEST_MESSAGE("order with the half sphere " << with << ", without " << without);
  BOOST_TEST(with > 1.9);
  BOOST_TEST(with < 2.1);
  BOOST_TEST(without > 0.85);
  BOOST_TEST(without < 1.15);
}

BOOST_AUTO_TEST_CASE(chain_layout_has_the_chain_s_damping) {
  const BeamLayout layout = ref::chain_layout(60, 0.7);
  const auto chain = ref::with_bond_damping(ref::linear_chain({60, 1.3, 2.6, 0.3, 1.1}), 0.7);
  const double beam = layout.retardation * ref::beam_frequencies(layout)[0] / 2;
  BOOST_TEST(std::abs(ref::first_bending_mode(chain).damping / beam - 1) < 1e-3);
  BOOST_TEST(layout.retardation * ref::chain_time_unit(60) == 0.7 * std::sqrt(3.2),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(small_motion_is_the_damped_beam) {
  const double load = 1e-4;
  const double tau = 0.0057;
  const std::vector<double> times = equal_times(9, 200);
  const BeamHistory elastica =
      ref::damped_elastica({tau, 0, 0, 0}, loaded(load), times, {14, ref::CvodeMethod::bdf, {1e-11, 1e-17}});
  const BeamHistory beam = ref::damped_beam_modal({tau, 0}, loaded(load), times, 6000);
  double worst = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    worst = std::max(worst, std::abs(elastica.samples[i].y - beam.samples[i].y) / load);
  }
  BOOST_TEST_MESSAGE("linear limit: largest difference over load " << worst);
  BOOST_TEST(worst < 5e-8);  // what is left is of order load^2 and of the tolerance
  BOOST_TEST(worst > 1e-13);
}

BOOST_AUTO_TEST_CASE(energy_lost_is_energy_dissipated) {
  for (const double load : {2.0, 5.3}) {
    const BeamHistory run = ref::damped_elastica(odd_layout, loaded(load), equal_times(9, 90),
                                                 {14, ref::CvodeMethod::bdf, {1e-11, 1e-13}});
    const double start = run.samples[0].elastic;
    for (const auto& sample : run.samples) BOOST_TEST(std::abs(total(sample) / start - 1) < 1e-8);
    BOOST_TEST(run.samples.back().dissipated > 0.1 * start);
    BOOST_TEST(run.samples[0].kinetic == 0);
    BOOST_TEST(run.statistics.steps > 500);
    BOOST_TEST(run.statistics.right_hand_sides > run.statistics.steps);
    BOOST_TEST(run.statistics.jacobians > 0);
  }
}

BOOST_AUTO_TEST_CASE(undamped_motion_keeps_its_energy) {
  const BeamHistory run =
      ref::damped_elastica({0, 0.02, 0, 0}, {Release::Shape::first_mode, 0.25}, equal_times(6, 6),
                           {6, ref::CvodeMethod::adams, {1e-10, 1e-12}});
  for (const auto& sample : run.samples) {
    BOOST_TEST(std::abs(total(sample) / run.samples[0].elastic - 1) < 1e-8);
    BOOST_TEST(sample.dissipated == 0);
  }
}

BOOST_AUTO_TEST_CASE(frequency_grows_with_the_square_of_the_amplitude) {
  // by averaging, checked outside by 30-digit quadrature over the mode shape: 0.01938354688111745
  const double coefficient = ref::amplitude_frequency_coefficient();
  BOOST_TEST(coefficient == 0.01938354688111745, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(coefficient - 0.0194) < 0.5e-4);

  // and in time: periods of the undamped beam at two amplitudes, extrapolated to zero
  const double omega_0 = ref::beam_frequencies({}, 6)[0];
  const auto measured = [&](double amplitude) {
    const double end = 12 * 2 * std::numbers::pi / omega_0;
    const BeamHistory run =
        ref::damped_elastica({}, {Release::Shape::first_mode, amplitude}, equal_times(end, 2400),
                             {6, ref::CvodeMethod::adams, {1e-9, 1e-11}});
    double reached = 0;
    for (const auto& sample : run.samples) reached = std::max(reached, std::abs(sample.y));
    const double omega = 2 * std::numbers::pi / reference_test::mean_period(run.samples);
    return (omega / omega_0 - 1) / (reached * reached);
  };
  const double at_small = measured(0.1);
  const double at_large = measured(0.2);
  const double at_zero = at_small + (at_small - at_large) / 3;
  BOOST_TEST_MESSAGE("coefficient at a = 0.1, 0.2 and extrapolated: " << at_small << " " << at_large << " "
                                                                      << at_zero);
  BOOST_TEST(std::abs(at_zero / coefficient - 1) < 0.003);
  BOOST_TEST(at_large > at_small);
}

BOOST_AUTO_TEST_CASE(large_motion_converges_in_modes_and_tolerance) {
  const std::vector<double> times = equal_times(5, 250);
  const auto run = [&](int modes, double tolerance) {
    return ref::damped_elastica(ref::chain_layout(10, 1), loaded(2), times,
                                {modes, ref::CvodeMethod::bdf, {tolerance, tolerance / 100}});
  };
  const BeamHistory finest = run(20, 1e-11);
  const double coarse = largest_distance(run(6, 1e-11), finest);
  const double middle = largest_distance(run(8, 1e-11), finest);
  const double fine = largest_distance(run(12, 1e-11), finest);
  BOOST_TEST_MESSAGE("distance from 20 modes: " << coarse << " " << middle << " " << fine);
  BOOST_TEST(coarse > 5 * middle);
  BOOST_TEST(middle > 20 * fine);
  BOOST_TEST(fine < 1e-8);
  BOOST_TEST(largest_distance(run(12, 1e-6), finest) > 10 * largest_distance(run(12, 1e-9), finest));
}

BOOST_AUTO_TEST_CASE(mirrored_release_moves_mirrored) {
  const std::vector<double> times = equal_times(2, 7);
  const BeamHistory up = ref::damped_elastica(odd_layout, loaded(2.3), times, {10});
  const BeamHistory down = ref::damped_elastica(odd_layout, loaded(-2.3), times, {10});
  for (std::size_t i = 0; i < times.size(); ++i) {
    BOOST_TEST(std::abs(up.samples[i].y + down.samples[i].y) < 1e-8);
    BOOST_TEST(std::abs(up.samples[i].x - down.samples[i].x) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(rates_are_the_derivatives_of_the_tip) {
  const double h = 1e-4;
  const BeamHistory run = ref::damped_elastica(odd_layout, loaded(3), {0.7 - h, 0.7, 0.7 + h},
                                               {12, ref::CvodeMethod::bdf, {1e-12, 1e-14}});
  const auto& s = run.samples;
  BOOST_TEST(std::abs((s[2].y - s[0].y) / (2 * h) - s[1].y_rate) < 1e-5 * std::abs(s[1].y_rate) + 1e-6);
  BOOST_TEST(std::abs((s[2].x - s[0].x) / (2 * h) - s[1].x_rate) < 1e-5 * std::abs(s[1].x_rate) + 1e-6);
  BOOST_TEST(std::abs((s[2].angle - s[0].angle) / (2 * h) - s[1].angle_rate) <
             1e-5 * std::abs(s[1].angle_rate) + 1e-6);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  BOOST_CHECK_THROW(ref::damped_elastica({-1, 0, 0, 0}, loaded(1), {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({0, NAN, 0, 0}, loaded(1), {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({0, 0, -1, 0}, loaded(1), {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({0, 0, 0, INFINITY}, loaded(1), {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({}, loaded(1e5), {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({}, {Release::Shape::first_mode, 0.7}, {0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_elastica({}, loaded(1), {0, 2, 1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_layout(0, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_layout(10, -1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_time_unit(-3), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
