// Calibration: there and back on the linear chain, the run that verifies it, what it expects of a run, what
// it refuses.
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/calibration/calibration.hpp"
#include "compare/calibration/table.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/damped_elastica.hpp"
#include "reference/elastica.hpp"
#include "tests/compare/messages.hpp"

BOOST_AUTO_TEST_SUITE(calibration_test)

using namespace fiberchain;
using namespace fiberchain::compare;
using dem::BondModel;
using dem::DashpotLaw;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto laws = {DashpotLaw::bond_damping, DashpotLaw::retardation_time, DashpotLaw::bending_only};

CalibrationCase case_of(int aspect_ratio, double nu = 0.17, DashpotLaw law = DashpotLaw::bond_damping,
                        BondModel bond = BondModel::paper) {
  CalibrationCase asked{nominal_fiber(aspect_ratio, nu, bond)};
  asked.fiber.dashpots = law;
  return asked;
}

}  // namespace

BOOST_AUTO_TEST_CASE(there_and_back) {
  for (const DashpotLaw law : laws) {
    for (const BondModel bond : {BondModel::paper, BondModel::corrected}) {
      for (const int r_f : {5, 13, 37, 140, 500}) {
        for (const double xi : {1e-4, 7e-4, 0.003, 0.011, 0.05, 0.4, 0.97}) {
          const CalibrationCase asked = case_of(r_f, 0.17, law, bond);
          const Calibration there = calibrate(asked, xi);
          const Calibration back = calibration_of({there.fiber});
          BOOST_TEST(std::abs(back.damping_ratio / xi - 1) < 1e-9);
          BOOST_TEST(back.setting == there.setting);
          BOOST_TEST(std::abs(reference::first_bending_mode(linear_chain_of(there.fiber)).damping / xi - 1) <
                     1e-9);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(proportional_damping_has_its_closed_form) {
  // c = tau K for every motion: xi_f = tau omega_0 / 2 exactly, whatever the chain
  for (const int r_f : {5, 41, 500}) {
    const Calibration found = calibrate(case_of(r_f, 0.43, DashpotLaw::retardation_time), 0.031);
    dem::Fiber bare = found.fiber;
    bare.retardation_time = 0;
    const double omega = reference::first_bending_mode(linear_chain_of(bare)).frequency;
    BOOST_TEST(std::abs(found.retardation_time / (2 * 0.031 / omega) - 1) < 1e-9);
    BOOST_TEST(found.retardation_time == found.fiber.retardation_time);
  }
  // the paper's dashpots: (beta_1^2 / sqrt(20)) xi_b / (r_f + 1/2)^2 within 0.25 %
  for (const int r_f : {5, 10, 500}) {
    const double expected = 0.02 * std::pow(r_f + 0.5, 2) * std::sqrt(20.0) / std::pow(1.87510407, 2);
    BOOST_TEST(std::abs(calibrate(case_of(r_f), 0.02).setting / expected - 1) < 0.0025);
  }
}

BOOST_AUTO_TEST_CASE(material_scales_out_of_the_setting_and_into_the_times) {
  const Calibration found = calibrate(case_of(13), 0.017);
  CalibrationCase steel = case_of(13);
  steel.fiber.material = dem::isotropic_material(210e9, 0.17, 7850);
  steel.fiber.diameter = 0.3e-3;
  const Calibration other = calibrate(steel, 0.017);
  BOOST_TEST(std::abs(other.setting / found.setting - 1) < 1e-9);
  const double faster = (2e-3 / 0.3e-3) * std::sqrt(210e9 / 7850 / (2.6e6 / 1000));
  BOOST_TEST(std::abs(other.natural_frequency / found.natural_frequency / faster - 1) < 1e-9);
  BOOST_TEST(std::abs(found.stable_step / other.stable_step / faster - 1) < 1e-9);
  BOOST_TEST(found.stable_step == dem::stable_time_step(found.fiber));
  BOOST_TEST(std::abs(found.bond_time / (0.8165 * 2e-3 * std::sqrt(1000 / 2.6e6)) - 1) < 1e-4);
}

BOOST_AUTO_TEST_CASE(measures_of_damping_mean_the_same) {
  BOOST_TEST(to_damping_ratio(DampingMeasure::quality_factor, 25) == 0.02);
  BOOST_TEST(to_damping_ratio(DampingMeasure::loss_factor, 0.04) == 0.02);
  const double delta = 2 * std::numbers::pi * 0.02 / std::sqrt(1 - 0.0004);
  BOOST_TEST(std::abs(to_damping_ratio(DampingMeasure::log_decrement, delta) / 0.02 - 1) < 1e-14);
  BOOST_TEST(to_damping_ratio(DampingMeasure::log_decrement, 1e3) <
             1);  // any decrement is below critical damping
}

BOOST_AUTO_TEST_CASE(departures_add_up_to_the_chain) {
  for (const DashpotLaw law : laws) {
    const Calibration f = calibrate(case_of(11, 0.43, law), 0.01);
    const double light = 1 + f.damping_departure.mass;
    BOOST_TEST(std::abs(light - std::sqrt(1.5)) < 1e-14);
    BOOST_TEST(f.frequency_departure.mass == f.damping_departure.mass);
    const double sum = light + f.damping_departure.discretization + f.damping_departure.shear;
    BOOST_TEST(std::abs(f.beam_damping * sum / f.damping_ratio - 1) < 1e-9);
    // half a sphere more at the end: (r_f / (r_f + 1/2))^2, and the rest is of second order
    BOOST_TEST(std::abs(f.damping_departure.discretization / light - (std::pow(11 / 11.5, 2) - 1)) < 0.003);
    BOOST_TEST(std::abs(f.frequency_departure.discretization / light - (std::pow(11 / 11.5, 2) - 1)) < 0.003);
    BOOST_TEST(f.frequency_departure.shear < 0);
    BOOST_TEST(f.frequency_departure.shear > -0.01);
  }
  const Calibration slender = calibrate(case_of(500), 0.01);
  BOOST_TEST(std::abs(slender.damping_departure.discretization / std::sqrt(1.5) + 0.002) < 1e-5);
  BOOST_TEST(std::abs(slender.damping_departure.shear) < 1e-5);
  // with the fiber's own mass nothing is left of that, nor of the half sphere
  CalibrationCase own = case_of(40);
  own.fiber.mass = dem::MassModel::cylinder;
  const Calibration cylinder = calibrate(own, 0.01);
  BOOST_TEST(cylinder.frequency_departure.mass == 0);
  BOOST_TEST(std::abs(cylinder.frequency_departure.discretization) < 1e-3);
}

BOOST_AUTO_TEST_CASE(run_has_the_damping_asked_for) {
  for (const auto& [r_f, nu, xi] :
       {std::tuple{8, 0.17, 0.02}, {9, 0.43, 1e-3}, {11, -0.11, 0.05}, {13, 0.29, 0.007}}) {
    for (const DashpotLaw law : laws) {
      const Calibration found = calibrate(case_of(r_f, nu, law), xi);
      const Verification run = verify(found);
      BOOST_TEST(std::abs(run.difference) < 2e-4);
      BOOST_TEST(std::abs(run.damping_ratio / xi - 1 - run.difference) < 1e-8);
      BOOST_TEST(std::abs(run.bond_steps / verification_cost(found) - 1) < 0.05);
    }
  }
  BOOST_TEST(std::abs(verify(calibrate(case_of(7), 0.8)).difference) < 2e-3);  // two peaks are left
}

BOOST_AUTO_TEST_CASE(time_step_does_what_is_expected_of_it) {
  // the effect itself, by the iteration of one oscillator with lagged damping
  const double xi = 0.07, omega = 3.0, dt = 0.01;
  double x = 1, v = 0, before = 0;
  std::vector<Peak> peaks;
  for (int i = 0; i < 20000 && peaks.size() < 21; ++i) {
    v += dt * (-omega * omega * x - 2 * xi * omega * v);
    x += dt * v;
    if (before > 0 && v <= 0) peaks.push_back({i * dt, x - dt * v});  // off by up to (omega dt)^2 / 8
    before = v;
  }
  const double delta = std::log(peaks[0].value / peaks[20].value) / 20;
  BOOST_TEST(std::abs(damping_ratio(delta) / xi - 1 - time_step_effect(xi, omega, dt)) < 2e-5);
  BOOST_TEST(std::abs(time_step_effect(xi, omega, dt)) > 1e-3);
  // and in the chain: two steps differ as expected, beyond all else that the two runs share
  CalibrationCase asked = case_of(5);
  asked.step_ratio = 0.1;
  const Calibration coarse = calibrate(asked, 0.03);
  asked.step_ratio = 0.02;
  const Calibration fine = calibrate(asked, 0.03);
  const double expected = coarse.time_step_effect - fine.time_step_effect;
  BOOST_TEST(std::abs(expected) > 3e-5);
  BOOST_TEST(std::abs(verify(coarse).difference - verify(fine).difference - expected) <
             0.1 * std::abs(expected));
}

// The numbers in amplitude_effect(), found again: the uniform inextensible Elastica let go from a load of 4.
BOOST_AUTO_TEST_CASE(amplitude_does_what_is_expected_of_it) {
  for (const double xi : {0.011, 0.03}) {
    reference::BeamLayout layout;
    const double omega = reference::beam_frequencies(layout).front(), period = 2 * std::numbers::pi / omega;
    layout.retardation = 2 * xi / omega;
    std::vector<double> times;
    for (int i = 0; i <= 12 * 120; ++i) times.push_back(period * i / 120);
    TipHistory tip;
    for (const auto& s :
         reference::damped_elastica(layout, {reference::Release::Shape::static_load, 4}, times).samples) {
      tip.time.push_back(s.time);
      tip.y.push_back(s.y);
      tip.velocity.push_back(s.y_rate);
    }
    const std::vector<Peak> peaks = positive_peaks(tip);
    int compared = 0;
    for (std::size_t j = 3; j + 1 < peaks.size(); ++j) {
      const double amplitude = std::sqrt(peaks[j].value * peaks[j + 1].value);
      if (amplitude > largest_amplitude) continue;
      const double local = damping_ratio(std::log(peaks[j].value / peaks[j + 1].value));
      BOOST_TEST(std::abs(local / xi - 1 - amplitude_effect(amplitude)) < 0.003);
      if (amplitude < 0.3) BOOST_TEST(std::abs((local / xi - 1) / amplitude_effect(amplitude) - 1) < 0.01);
      ++compared;
    }
    BOOST_TEST(compared >= 5);
  }
  BOOST_TEST(amplitude_effect(0) == 0);
}

BOOST_AUTO_TEST_CASE(amplitude_is_a_load_or_a_deflection) {
  BOOST_TEST(to_amplitude(AmplitudeMeasure::load, 0) == 0);
  BOOST_TEST(to_amplitude(AmplitudeMeasure::load, 1) == reference::elastica_shooting(1).y);
  BOOST_TEST(to_amplitude(AmplitudeMeasure::tip_deflection, 0.3) == 0.3);
  BOOST_TEST(to_amplitude(AmplitudeMeasure::load, 2.4) < largest_amplitude);
  for (const double load : {2.6, 10.0, 1e9}) {
    BOOST_TEST(
        names(message_of<InputError>([&] { to_amplitude(AmplitudeMeasure::load, load); }), "known up to"));
  }
}

BOOST_AUTO_TEST_CASE(one_answer_takes_less_than_10_ms) {
  calibrate(case_of(500), 0.02);
  double least = kInfinity;
  for (int i = 0; i < 10; ++i) {
    const auto start = std::chrono::steady_clock::now();
    calibrate(case_of(500, 0.17, DashpotLaw::bending_only), 0.05 - 0.001 * i);
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  BOOST_TEST(least < 0.01);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_says_why) {
  for (const auto& [measure, value] : {std::pair{DampingMeasure::damping_ratio, 1.0},
                                       {DampingMeasure::damping_ratio, 7.0},
                                       {DampingMeasure::quality_factor, 0.5},
                                       {DampingMeasure::loss_factor, 2.0}}) {
    BOOST_TEST(
        names(message_of<InputError>([&] { to_damping_ratio(measure, value); }), "there is no vibration"));
  }
  for (const double value : {0.0, -0.01, kNan, kInfinity, -kInfinity}) {
    BOOST_TEST(names(message_of<InputError>([&] { to_damping_ratio(DampingMeasure::log_decrement, value); }),
                     "must be finite and above 0"));
    BOOST_TEST(message_of<InputError>([&] { calibrate(case_of(10), value); }) != "nothing thrown");
  }
  BOOST_TEST(names(message_of<InputError>([] { calibrate(case_of(10), 1.0); }), "there is no vibration"));
  // one bond with a dashpot in bending only: the shear spring lets it swing past
  BOOST_TEST(names(message_of<InputError>([] { calibrate(case_of(1, 0.3, DashpotLaw::bending_only), 0.9); }),
                   "cannot be reached at aspect ratio 1 with dashpots set by bending_only"));
  BOOST_TEST(names(message_of<InputError>([] { calibrate(case_of(2000), 0.01); }), "aspect ratio 2000"));
}

BOOST_AUTO_TEST_CASE(settings_without_vibration_say_why) {
  const auto reverse = [](double bond_damping) {
    CalibrationCase asked = case_of(10);
    asked.fiber.bond_damping = bond_damping;
    calibration_of(asked);
  };
  BOOST_TEST(names(message_of<InputError>([&] { reverse(0); }), "without damping"));
  BOOST_TEST(
      names(message_of<InputError>([&] { reverse(150); }), "bond damping = 150 overdamps the first mode"));
  BOOST_TEST(names(message_of<dem::InvalidInput>([&] { reverse(-1); }), "bond_damping = -1 is not allowed"));
  BOOST_TEST(
      names(message_of<dem::InvalidInput>([&] { reverse(kNan); }), "bond_damping = nan is not allowed"));
  CalibrationCase swinging = case_of(10);
  swinging.amplitude = -0.1;
  BOOST_TEST(names(message_of<InputError>([&] { calibrate(swinging, 0.01); }), "tip deflection = -0.1"));
  CalibrationCase stepping = case_of(10);
  stepping.step_ratio = 0.9;
  BOOST_TEST(names(message_of<InputError>([&] { calibrate(stepping, 0.01); }), "largest stable step"));
}

BOOST_AUTO_TEST_CASE(a_run_at_an_amplitude_is_held_against_what_is_expected_there) {
  for (const double ratio : {0.002, 0.02, 0.1}) {
    const Calibration found = calibrate(case_of(10), ratio);
    const Verification run = verify(found, 0.5);
    BOOST_TEST_CONTEXT("xi_f " << ratio) {
      BOOST_TEST(run.amplitude > 0.1);
      BOOST_TEST(run.amplitude < 0.5);
      // of peaks far apart in size the root mean square is more than the slope between them goes by
      BOOST_TEST(run.expected / ratio < 1 - 0.2 * run.amplitude * run.amplitude);
      BOOST_TEST(run.expected / ratio > 1 - 0.6 * run.amplitude * run.amplitude);
      BOOST_TEST(std::abs(run.difference) < 4e-3);
      BOOST_TEST(std::abs(run.bond_steps / verification_cost(found, 0.5) - 1) < 0.05);
    }
  }
  BOOST_TEST(names(message_of<InputError>([] { verify(calibrate(case_of(10), 0.8), 0.5); }),
                   "cannot be verified at an amplitude"));
}

BOOST_AUTO_TEST_CASE(a_step_too_small_for_a_double_is_refused) {
  for (const double step : {1e-300, 1e-200, 1e-12}) {
    CalibrationCase asked = case_of(10);
    asked.step_ratio = step;
    BOOST_TEST(names(message_of<InputError>([&] { calibrate(asked, 0.01); }), "step ratio"));
    asked.fiber.bond_damping = 1;
    BOOST_TEST(names(message_of<InputError>([&] { calibration_of(asked); }), "a double resolves"));
  }
  CalibrationCase fine = case_of(10);
  fine.step_ratio = 1e-7;
  BOOST_TEST(std::abs(calibrate(fine, 0.01).time_step_effect) < 1e-8);
}

BOOST_AUTO_TEST_CASE(run_that_costs_too_much_is_refused_with_its_cost) {
  const Calibration found = calibrate(case_of(500), 0.05);
  BOOST_TEST(verification_cost(found) > largest_verification);
  const std::string message = message_of<InputError>([&] { verify(found); });
  BOOST_TEST(names(message, "bond-steps"));
  BOOST_TEST(names(message, "aspect ratio 500"));
}

BOOST_AUTO_TEST_CASE(table_holds_what_was_found) {
  CalibrationCase asked = case_of(9, 0.23);
  asked.amplitude = 0.2;
  CalibrationAnswer answer{asked, 0.01, calibrate(asked, 0.01)};
  const dem::Table bare = calibration_table({answer});
  BOOST_TEST(std::isnan(bare.number(0, "fiber_damping")));
  answer.run = verify(answer.found);
  const dem::Table table = calibration_table({answer});
  BOOST_TEST(table.number(0, "bond_damping") == answer.found.setting);
  BOOST_TEST(std::abs(table.number(0, "quality_factor") - 50) < 1e-7);
  BOOST_TEST(std::abs(table.number(0, "loss_factor") - 0.02) < 1e-10);
  BOOST_TEST(std::abs(table.number(0, "poisson_ratio") - 0.23) < 1e-12);
  BOOST_TEST(table.number(0, "expected_error") ==
             table.number(0, "amplitude_effect") + table.number(0, "time_step_effect"));
  BOOST_TEST(std::abs(table.number(0, "fiber_damping") / 0.01 - 1) < 2e-4);
  BOOST_TEST(calibration_notes(answer).find("Run: ") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
