#include <algorithm>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/large_motion.hpp"
#include "compare/stability/marched_mode.hpp"
#include "compare/stability/table.hpp"
#include "compare/static/case.hpp"
#include "compare/study/validation.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::compare {
namespace {

using dem::BondModel;
using dem::Integrator;
using reference::ChainEnds;

/// Largest stable steps of runs at r_f = 50, nu = 0.3, a measure for each xi_b, and of the waves of the
/// endless chain.
std::vector<Measured> limits(const ValidationInput& in) {
  const StabilitySweep sweep{.aspect_ratio = {50},
                             .poisson_ratio = {0.3},
                             .bond_damping = {0, 0.1, 0.25, 0.5, 1, 2, 5},
                             .bond = {BondModel::paper},
                             .scheme = {Integrator::leapfrog}};
  std::vector<Measured> limits;
  for (const StabilityPoint& p : stability_points(cases(sweep), {.jobs = in.jobs})) {
    limits.push_back({.value = p.measured, .expected = p.endless});
  }
  return limits;
}

double worst_difference(const ValidationInput& in, const std::vector<StabilitySweep>& sweeps) {
  double worst = 0;
  for (const StabilitySweep& sweep : sweeps) {
    for (const StabilityPoint& p : stability_points(cases(sweep), {.jobs = in.jobs})) {
      worst = std::max(worst, std::abs(p.difference));
    }
  }
  return worst;
}

/// Runs against modes over the map, both bonds; lagged dashpots and solved ones.
std::vector<Measured> agreement(const ValidationInput& in) {
  const StabilitySweep lagged{.aspect_ratio = {5, 13},
                              .poisson_ratio = {-0.2, 0, 0.25, 0.49},
                              .bond_damping = {0, 0.3, 10},
                              .scheme = {Integrator::leapfrog}};
  StabilitySweep spatial = lagged;
  spatial.ends = {ChainEnds::free_free};
  spatial.dimension = {3};
  const StabilitySweep solved{.aspect_ratio = {5},
                              .poisson_ratio = {-0.2, 0.25, 0.49},
                              .bond_damping = {0.3, 10},
                              .scheme = {Integrator::leapfrog_damped}};
  return {{worst_difference(in, {lagged, spatial})}, {worst_difference(in, {solved})}};
}

/// The step that marches take their default from, against the spectral radius: largest relative difference.
std::vector<Measured> own_step(const ValidationInput&) {
  double worst = 0;
  for (const auto bond : {BondModel::paper, BondModel::corrected}) {
    for (const double nu : {-0.2, 0.0, 0.17, 0.3, 0.49}) {
      for (const double xi : {0.0, 0.3, 10.0}) {
        const StabilityCase asked{.poisson_ratio = nu, .bond_damping = xi, .bond = bond, .dimension = 3};
        const dem::Fiber fiber = stability_fiber(asked);
        const double own = dem::stable_time_step(fiber) / dem::bond_time_step(fiber);
        worst = std::max(worst, std::abs(own / endless_limit(asked) - 1));
      }
    }
  }
  return {{worst}};
}

/// Runs with bonds solved within the step, far beyond t_b.
std::vector<GrowthPoint> large_steps(const ValidationInput& in) {
  const StabilitySweep short_fibers{.aspect_ratio = {5, 20},
                                    .poisson_ratio = {-0.2, 0.3, 0.49},
                                    .bond_damping = {0, 0.1, 1, 10},
                                    .bond = {BondModel::paper},
                                    .dimension = {2, 3},
                                    .form = {dem::BondForm::incremental, dem::BondForm::total}};
  StabilitySweep long_fibers = short_fibers;
  long_fibers.aspect_ratio = {200};
  long_fibers.poisson_ratio = {0.3};
  long_fibers.bond_damping = {0, 1};
  long_fibers.dimension = {2};
  std::vector<GrowthCase> all = growth_cases(short_fibers);
  for (const GrowthCase& more : growth_cases(long_fibers)) all.push_back(more);
  return growth_points(all, {.jobs = in.jobs});
}

/// What explicit bonds do at ten times t_b: growth a step of the fastest mode.
double explicit_growth(Integrator scheme) {
  const reference::LinearChain chain = linear_chain_of(stability_fiber({.bond_damping = 0.1}));
  return reference::growth_per_step(chain, time_scheme(scheme), ChainEnds::clamped_free,
                                    10 * reference::bond_time(chain), true);
}

/// Largest step at which no run grew, over t_b; runs against modes, in parts of what their length allows.
std::vector<Measured> beyond_bond_time(const ValidationInput& in) {
  double largest = 1e300, apart = 0, swell = 0, root = 0;
  int runs = 0;
  for (const GrowthPoint& point : large_steps(in)) {
    double stable = 0;
    for (const Growth& growth : point.at) {
      ++runs;
      if (!growth.grows()) stable = std::max(stable, growth.step_ratio);
      swell = std::max(swell, growth.swell);
      root = std::max(root, growth.modes - 1);
      apart = std::max(apart, std::abs(growth.measured - growth.modes) / growth_margin(growth.steps));
    }
    largest = std::min(largest, stable);
  }
  return {{.value = largest,
           .evidence = {runs, swell, root, explicit_growth(Integrator::leapfrog),
                        explicit_growth(Integrator::leapfrog_damped)}},
          {apart}};
}

/// Errors of the first mode's damping ratio and frequency at a ninetieth of its period, against its
/// oscillator's root; the law beside them.
std::vector<Measured> first_mode_errors(const ValidationInput&) {
  dem::Fiber fiber = nominal_fiber(13, 0.17, BondModel::paper);
  fiber.dashpots = dem::DashpotLaw::retardation_time;
  fiber.retardation_time = 20 * dem::bond_time_step(fiber);
  const MarchedMode marched = marched_mode(
      {.chain = {.fiber = fiber, .scheme = Integrator::leapfrog_stiff}, .part_of_period = 1.0 / 90});
  const reference::TimeScheme scheme = time_scheme(Integrator::leapfrog_stiff);
  MarchedMode expected = marched;
  expected.z = reference::step_root(scheme, marched.angle, marched.damping);
  const reference::ModeError law = reference::error_law(scheme, marched.angle, marched.damping);
  return {{.value = marched.damping_error(), .evidence = {law.damping}, .expected = expected.damping_error()},
          {.value = marched.frequency_error(),
           .evidence = {law.frequency},
           .expected = expected.frequency_error()}};
}

/// Order of the path at large deflection in the plane and in space, and momenta, both forms.
std::vector<Measured> large_motions(const ValidationInput&) {
  double planar = 2, spatial = 2, momentum = 0, round_off = 0, ratio = 0, error = 0;
  const auto farther = [](double from, double now) {
    return std::abs(now - 2) > std::abs(from - 2) ? now : from;
  };
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const double load : {0.01, 3.1}) {
      const ObservedOrder plane = order_of_large_motion<2>(form, load),
                          space = order_of_large_motion<3>(form, load);
      planar = farther(planar, plane.order), spatial = farther(spatial, space.order);
      ratio = plane.ratio, error = std::max(error, space.error);
    }
    const MomentumChange change = momentum_change(form, 10), far = momentum_change(form, 100);
    momentum = std::max({momentum, change.linear, change.angular});
    round_off = std::max({round_off, far.linear, far.angular});
  }
  return {{planar, {ratio}}, {spatial, {ratio, error}}, {momentum, {round_off}}};
}

double rayleigh_percent(double nu) {
  const reference::ChainMaterial material{10, 1e-3, 2.6e6, nu, 1000};
  return 100 * reference::bond_time(reference::linear_chain(material)) / reference::rayleigh_step(material);
}

/// xi_b at which 0.25 t_b is the limit of the chain at hand.
double damping_of_quarter_step(StabilityCase asked) {
  double low = 0, high = 10;
  while (high - low > 1e-6) {
    asked.bond_damping = (low + high) / 2;
    (modal_limit(asked) > 0.25 ? low : high) = asked.bond_damping;
  }
  return low;
}

std::vector<Measured> paper_steps(const ValidationInput&) {
  const std::vector<StabilityPoint> p =
      stability_points({{.aspect_ratio = 10, .bond_damping = 0.8}, {.aspect_ratio = 10, .bond_damping = 1}});
  return {{.value = p[0].measured,
           .evidence = {p[0].modes, p[1].modes, p[1].quarter_growth, damping_of_quarter_step(p[1].asked),
                        damping_of_quarter_step({.aspect_ratio = 10, .poisson_ratio = -0.2})},
           .otherwise = p[1].measured},
          {rayleigh_percent(0)},
          {rayleigh_percent(0.5), {rayleigh_percent(0), rayleigh_percent(0.3), rayleigh_percent(0.5)}}};
}

}  // namespace

const Checks& stability_checks() {
  static const Checks checks{
      {{"paper-quarter-step", "paper-rayleigh-most", "paper-rayleigh-least"}, paper_steps},
      {{"stable-step-0", "stable-step-0.1", "stable-step-0.25", "stable-step-0.5", "stable-step-1",
        "stable-step-2", "stable-step-5"},
       limits},
      {{"stable-step-runs", "stable-step-runs-damped"}, agreement, 2},
      {{"stable-step-own"}, own_step},
      {{"paper-critical-step", "large-step-runs"}, beyond_bond_time, 16},
      {{"large-step-damping", "large-step-frequency"}, first_mode_errors},
      {{"large-step-order-planar", "large-step-order-spatial", "large-step-momentum"}, large_motions}};
  return checks;
}

}  // namespace fiberchain::compare
