// Damping and frequency of the first mode by each integrator, against the linear chain's eigenvalue: not only
// the order of the error but the error itself, from the scheme's own expansion in w dt.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "dem/motion/implicit_bond.hpp"
#include "dem/vibration/release.hpp"

BOOST_AUTO_TEST_SUITE(integrator_damping_test)

namespace compare = fiberchain::compare;
namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;

namespace {

struct Errors {
  double damping, frequency, step_angle;  ///< relative; w dt of the step taken
};

Errors errors_of(const dem::Fiber& fiber, const reference::ChainMode& mode, dem::Integrator integrator,
                 int samples, std::optional<double> step_ratio) {
  const auto release = compare::mode_release(fiber, mode, 1e-5, 4.7);
  dem::ReleaseOptions options{.integrator = integrator, .step_ratio = step_ratio};
  options.samples_per_period = samples;
  const auto record = dem::ring_down<2>({release}, options)[0];
  const auto found = compare::damping_from_peaks(
      compare::positive_peaks(compare::tip_history(record, dem::fiber_length(fiber))), {0, 3});
  return {found.ratio / mode.damping - 1, found.frequency / mode.eigenvalue.imag() - 1,
          mode.eigenvalue.imag() * record.time_step};
}

const dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 7, dem::BondModel::paper, 0.6};

}  // namespace

// leapfrog, dashpots solved: -q/24 in xi_f, +q/24 in w, q = (w dt)^2
BOOST_AUTO_TEST_CASE(dashpots_solved_within_the_step_are_second_order_in_damping) {
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(fiber));
  Errors last{};
  for (const double ratio : {0.9, 0.45}) {
    const Errors e = errors_of(fiber, mode, dem::Integrator::leapfrog_damped, 200, ratio);
    const double expected = e.step_angle * e.step_angle / 24;
    BOOST_TEST(std::abs(e.damping / -expected - 1) < 0.03);
    BOOST_TEST(std::abs(e.frequency / expected - 1) < 0.03);
    if (last.step_angle > 0) {
      BOOST_TEST(std::abs(std::log(last.damping / e.damping) / std::log(last.step_angle / e.step_angle) - 2) <
                 0.1);
    }
    last = e;
  }
}

// bonds solved: -(beta/2 + 1/24) q in xi_f, -(beta - 1/12)/2 q in w, whatever the bond's own step
BOOST_AUTO_TEST_CASE(bonds_solved_within_the_step_are_second_order_in_damping) {
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(fiber));
  for (const int samples : {90, 180}) {
    const Errors e = errors_of(fiber, mode, dem::Integrator::leapfrog_stiff, samples, std::nullopt);
    const double q = e.step_angle * e.step_angle;
    BOOST_TEST(std::abs(e.step_angle - 2 * std::acos(-1) / samples) < 0.02 * e.step_angle);
    BOOST_TEST(std::abs(e.damping / (-(dem::stiff_beta / 2 + 1.0 / 24) * q) - 1) < 0.03);
    BOOST_TEST(std::abs(e.frequency / (-(dem::stiff_beta - 1.0 / 12) / 2 * q) - 1) < 0.03);
    if (samples == 90) BOOST_TEST(std::abs(e.damping) < 1e-3);
  }
}

// dashpots lagged: the force lies half a step behind, an error of xi_f w dt / 2 in both
BOOST_AUTO_TEST_CASE(lagged_dashpots_are_first_order_in_damping) {
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(fiber));
  for (const double ratio : {0.3, 0.15}) {
    const Errors e = errors_of(fiber, mode, dem::Integrator::leapfrog, 200, ratio);
    const double expected = mode.damping * e.step_angle / 2, second = e.step_angle * e.step_angle / 24;
    BOOST_TEST(std::abs((e.frequency - second) / expected - 1) < 0.05);
    BOOST_TEST(e.damping > 0.3 * expected);
    BOOST_TEST(e.damping < 1.7 * expected);
  }
}

// midpoint: lambda -> (2/dt) artanh(lambda dt/2), -q/6 in xi_f, -q/12 in w
BOOST_AUTO_TEST_CASE(implicit_midpoint_is_second_order_in_damping) {
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(fiber));
  for (const int samples : {60, 120}) {
    const Errors e = errors_of(fiber, mode, dem::Integrator::implicit, samples, std::nullopt);
    const double q = e.step_angle * e.step_angle;
    BOOST_TEST(std::abs(e.damping / (-q / 6) - 1) < 0.03);
    BOOST_TEST(std::abs(e.frequency / (-q / 12) - 1) < 0.03);
  }
}

BOOST_AUTO_TEST_SUITE_END()
