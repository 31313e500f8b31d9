// What a ring-down tells of its fiber: coverage of the intervals on records made here, by formulas of their
// own.
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

#include "compare/identify/identify.hpp"
#include "compare/identify/record_csv.hpp"
#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(identify_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::compare;
using std::numbers::pi;

namespace {

/// A fiber that was let go: E from a uniform beam's first mode, a second mode beside.
struct Made {
  double youngs_modulus, damping_ratio, omega;
  dem::Fiber fiber;
  RingDownRecord record;
};

struct Settings {
  double noise = 0.01;  ///< over the amplitude
  double periods = 20;
  int samples = 1000;
  double second = 0;  ///< mode 2's amplitude over mode 1's
};

Made made(double E, double xi, const Settings& settings, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  dem::Fiber fiber{dem::isotropic_material(1e9, 0.17, 1000 + 2000 * unit(random)), 2e-4 * (1 + unit(random)),
                   20 + static_cast<int>(80 * unit(random))};
  const double L = fiber.diameter * fiber.aspect_ratio, R = fiber.diameter / 2;
  // omega_1 = 1.8751^2 sqrt(E I/(rho A L^4)), I/A = R^2/4
  const double omega =
      std::pow(1.8751040687119611 / L, 2) * std::sqrt(E * R * R / (4 * fiber.material.density));
  Made all{E, xi, omega, fiber, {}};
  const double duration = settings.periods * 2 * pi / omega, amplitude = 1e-3 * (0.5 + unit(random)),
               offset = 1e-2 * unit(random), phase = 2 * pi * unit(random), begin = unit(random);
  std::normal_distribution<double> normal(0, settings.noise * amplitude);
  const auto sine = [&](double w, double damping, double t) {
    return std::exp(-damping * w * t) * std::cos(w * std::sqrt(1 - damping * damping) * t + phase);
  };
  for (int i = 0; i < settings.samples; ++i) {
    const double t = duration * i / (settings.samples - 1);
    all.record.time.push_back(begin + t);
    all.record.displacement.push_back(
        offset + amplitude * (sine(omega, xi, t) + settings.second * sine(6.2669 * omega, 2 * xi, t)) +
        normal(random));
  }
  return all;
}

bool holds(const Estimate& estimate, double truth) { return estimate.low < truth && truth < estimate.high; }

}  // namespace

BOOST_AUTO_TEST_CASE(intervals_hold_the_truth_as_often_as_they_say) {
  std::mt19937_64 random(20150276);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int cases = 200;
  int modulus = 0, damping = 0, loss = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (int n = 0; n < cases; ++n) {
    const double E = std::pow(10.0, 6 + 5 * unit(random)), xi = std::pow(10.0, -2.7 + 1.7 * unit(random));
    const Settings settings{.noise = std::pow(10.0, -3 + 2 * unit(random)),
                            .periods = 8 + 30 * unit(random),
                            .samples = 400 + static_cast<int>(1600 * unit(random)),
                            .second = n % 3 == 0 ? 0.05 : 0};
    const Made one = made(E, xi, settings, random);
    const Identification found = identify({.record = one.record, .fiber = one.fiber});
    BOOST_TEST_CONTEXT("case " << n << " xi " << xi << " noise " << settings.noise) {
      BOOST_TEST(found.doubts.empty());
      // no interval is so wide that it would hold anything
      BOOST_TEST(found.youngs_modulus->high - found.youngs_modulus->low < 0.1 * E);
    }
    modulus += holds(*found.youngs_modulus, E);
    damping += holds(found.damping_ratio, xi);
    loss += holds(found.loss_factor, 2 * xi);
  }
  const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / cases;
  BOOST_TEST_MESSAGE("covered of " << cases << ": E " << modulus << ", xi " << damping << "; " << each
                                   << " s a case");
  for (const int held : {modulus, damping, loss})
    BOOST_TEST(std::abs(static_cast<double>(held) / cases - 0.95) <= 0.03);
  BOOST_TEST(damping == loss);
}

BOOST_AUTO_TEST_CASE(other_confidences_are_covered_as_often_as_they_say) {
  std::mt19937_64 random(77);
  int half = 0;
  constexpr int cases = 400;
  for (int n = 0; n < cases; ++n) {
    const Made one = made(3e9, 0.02, {.noise = 0.03, .periods = 12, .samples = 300}, random);
    half += holds(identify({.record = one.record, .confidence = 0.5}).damping_ratio, 0.02);
  }
  // the binomial's standard deviation is 0.025
  BOOST_TEST(std::abs(static_cast<double>(half) / cases - 0.5) < 0.08);
}

BOOST_AUTO_TEST_CASE(one_percent_of_noise_leaves_xi_to_two_percent) {
  std::mt19937_64 random(5);
  for (const double xi : {0.003, 0.01, 0.05}) {
    for (int n = 0; n < 20; ++n) {
      const Made one = made(2e9, xi, {.noise = 0.01, .periods = 25, .samples = 2000}, random);
      const Identification found = identify({.record = one.record, .fiber = one.fiber});
      BOOST_TEST(std::abs(found.damping_ratio.value / xi - 1) < 0.02);
      BOOST_TEST(std::abs(found.youngs_modulus->value / 2e9 - 1) < 2e-3);
      BOOST_TEST(std::abs(found.noise / found.amplitude / 0.01 - 1) < 0.15);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_noise_it_is_exact) {
  std::mt19937_64 random(9);
  for (const double xi : {1e-3, 0.02, 0.3}) {
    const double second = xi < 0.1 ? 0.1 : 0;
    const Made one = made(4.4e8, xi, {.noise = 0, .periods = 10, .samples = 500, .second = second}, random);
    const Identification found = identify({.record = one.record, .fiber = one.fiber});
    BOOST_TEST(std::abs(found.damping_ratio.value / xi - 1) < 1e-6);
    BOOST_TEST(std::abs(found.youngs_modulus->value / 4.4e8 - 1) < 1e-6);
    BOOST_TEST(std::abs(found.log_decrement.value / (2 * pi * xi / std::sqrt(1 - xi * xi)) - 1) < 1e-6);
    BOOST_TEST(found.fit.modes.size() == (second > 0 ? 2u : 1u));
  }
  // two modes that are gone within a period are not told apart: what is left tells so
  const Made gone = made(4.4e8, 0.3, {.noise = 0, .periods = 10, .samples = 500, .second = 0.1}, random);
  BOOST_TEST(identify({.record = gone.record}).warnings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(samples_need_not_be_even_in_time) {
  std::mt19937_64 random(11);
  Made one = made(4.4e8, 0.02, {.noise = 0.01, .periods = 15, .samples = 1500}, random);
  RingDownRecord some;
  for (std::size_t i = 0; i < one.record.time.size(); ++i) {
    if (random() % 3 == 0) continue;
    some.time.push_back(one.record.time[i]), some.displacement.push_back(one.record.displacement[i]);
  }
  const Identification found = identify({.record = some});
  BOOST_TEST(std::abs(found.damping_ratio.value / 0.02 - 1) < 0.02);
  BOOST_TEST(std::abs(found.frequency.value / one.omega - 1) < 1e-3);
}

BOOST_AUTO_TEST_CASE(records_that_cannot_tell_are_told) {
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal;
  int false_alarms = 0;
  for (int n = 0; n < 100; ++n) {
    RingDownRecord noise;
    for (int i = 0; i < 300; ++i) noise.time.push_back(i), noise.displacement.push_back(normal(random));
    false_alarms += identify({.record = noise}).doubts.empty();
  }
  BOOST_TEST(false_alarms == 0);
  const Made brief = made(1e9, 0.01, {.noise = 0.001, .periods = 1.3}, random),
             undamped = made(1e9, 1e-6, {.noise = 0.05, .periods = 10}, random);
  for (const Made& one : {brief, undamped}) {
    const Identification found = identify({.record = one.record, .fiber = one.fiber});
    BOOST_TEST(found.doubts.size() == 1u);
    BOOST_TEST(std::isnan(found.damping_ratio.value));
    BOOST_TEST(std::isnan(found.bond_damping->value));
  }
  BOOST_TEST(holds(*identify({.record = undamped.record, .fiber = undamped.fiber}).youngs_modulus, 1e9));
}

BOOST_AUTO_TEST_CASE(what_is_left_and_is_not_noise_is_told) {
  std::mt19937_64 random(17);
  Made one = made(1e9, 0.01, {.noise = 0.002, .periods = 20}, random);
  const auto warned = [](const RingDownRecord& record) {
    return !identify({.record = record}).warnings.empty();
  };
  BOOST_TEST(!warned(one.record));
  // a frequency that falls with the amplitude
  for (std::size_t i = 0; i < one.record.time.size(); ++i) {
    const double t = one.record.time[i] - one.record.time[0], x = one.omega * t, decay = std::exp(-0.01 * x),
                 phase = x + 2 * (1 - decay * decay);
    one.record.displacement[i] = decay * std::cos(phase) + 0.002 * std::normal_distribution<double>()(random);
  }
  BOOST_TEST(warned(one.record));
}

BOOST_AUTO_TEST_CASE(files_are_read_or_named) {
  std::istringstream good("# measured\nt,other,y\n0,9,1\n1,9,-0.5\n");
  const RingDownRecord record = read_record(good, "r.csv", {.displacement = "y", .time_unit = 1e-3});
  BOOST_TEST(record.time == (std::vector<double>{0, 1e-3}), boost::test_tools::per_element());
  BOOST_TEST(record.displacement == (std::vector<double>{1, -0.5}), boost::test_tools::per_element());
  for (const auto& [text, said] : {std::pair<std::string, std::string>{"", "r.csv:0: holds no header"},
                                   {"0,1\n", "begins with a number"},
                                   {"t\n0\n", "one column"},
                                   {"t,y\n0,a\n", "r.csv:2: column 2: 'a' is not a finite number"},
                                   {"t,y\n0,1\n0,2\n", "r.csv:3: times must rise"},
                                   {"t,y\n0,nan\n", "'nan'"},
                                   {"t,x\n0,1\n", "there is no column 'y'"}}) {
    std::istringstream input(text);
    BOOST_CHECK_EXCEPTION(
        read_record(input, "r.csv", {.displacement = text.starts_with("t,x") ? "y" : ""}), InputError,
        [&](const InputError& e) { return std::string(e.what()).find(said) != std::string::npos; });
  }
}

BOOST_AUTO_TEST_SUITE_END()
