#include "compare/damping/paper_checks.hpp"

#include <algorithm>
#include <cmath>

#include "compare/damping/case.hpp"
#include "compare/fit/choices.hpp"
#include "compare/fit/fit.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/errors.hpp"

namespace fiberchain::compare {
namespace {

using Found = std::vector<Measured>;

DampingPoints measured_points(const std::vector<DampingCase>& cases, const Jobs& jobs) {
  return damping_points(cases, {.jobs = jobs, .elastica = false});
}

/// Load P L^2/(E I) of a force on the nominal fiber.
double load_of_force(double force, int aspect_ratio, double shear_modulus = 1e6) {
  const DampingCase unit{.aspect_ratio = aspect_ratio, .youngs_modulus = 2.6 * shear_modulus};
  return force / dem::load_force(damped_fiber(unit), 1.0);
}

double fall_percent(double from, double to) { return 100 * (1 - to / from); }

/// Damping of the linear chain's first mode at xi_b.
double linear_damping(int aspect_ratio, double bond_damping = 1) {
  const DampingCase asked{.aspect_ratio = aspect_ratio, .bond_damping = bond_damping};
  return reference::first_bending_mode(linear_chain_of(asked)).damping;
}

// Loads of Fig 7 at which peaks 1..10 give its slopes, each alone; one force bends r_f = 8 by 0.64 of 10.
constexpr double kSlopeLoad8 = 1.47, kSlopeLoad10 = 0.94, kOneForce = 0.64;

Found slopes(const ValidationInput& in) {
  const DampingPoints p = measured_points({{.aspect_ratio = 8, .load = kSlopeLoad8},
                                           {.aspect_ratio = 10, .load = kSlopeLoad10},
                                           {.aspect_ratio = 8, .load = kOneForce * kSlopeLoad10},
                                           {.aspect_ratio = 10, .load = kSlopeLoad8 / kOneForce},
                                           {.aspect_ratio = 8, .load = 0.001},
                                           {.aspect_ratio = 10, .load = 0.001}},
                                          in.jobs);
  return {{.value = p[0].damping_paper, .otherwise = p[4].damping},
          {.value = p[1].damping_paper, .otherwise = p[5].damping},
          {p[2].damping_paper, {p[3].damping_paper}},
          {1 / p[4].damping},
          {1 / p[5].damping},
          {p[4].damping / p[5].damping}};
}

Found figure_7_load(const ValidationInput& in) {
  const double eight = load_of_force(0.02, 8), ten = load_of_force(0.02, 10);
  const DampingPoints p = measured_points(
      {{.aspect_ratio = 8, .load = eight}, {.load = ten}, {.load = 0.5}, {.load = 1.0}}, in.jobs);
  return {{fall_percent(p[1].damping_modes, p[1].damping),
           {ten, fall_percent(p[0].damping_modes, p[0].damping), eight,
            fall_percent(p[2].damping_modes, p[2].damping), fall_percent(p[3].damping_modes, p[3].damping)}}};
}

Found figure_8(const ValidationInput& in) {
  const auto at = [](double force, double shear_modulus) {
    return DampingCase{.load = load_of_force(force, 10, shear_modulus),
                       .youngs_modulus = 2.6 * shear_modulus};
  };
  const DampingPoints p =
      measured_points({at(0.001, 1e6), at(0.008, 1e6), at(0.001, 2e6), at(0.008, 2e6), at(0.001, 0.125e6),
                       at(0.0005, 0.2e6), at(0.0005, 2e6), at(0.002, 0.2e6), at(0.002, 2e6)},
                      in.jobs);
  const auto fall = [&](int from, int to) { return fall_percent(p[from].damping, p[to].damping); };
  return {{.value = fall(0, 1),
           .evidence = {fall_percent(p[0].damping_paper, p[1].damping_paper)},
           .otherwise = fall(2, 3)},
          {fall(0, 4) / fall(0, 1)},
          {.value = fall(6, 5), .otherwise = fall(8, 7)}};
}

bool swings(int aspect_ratio, double bond_damping) {
  const DampingCase asked{.aspect_ratio = aspect_ratio, .bond_damping = bond_damping};
  try {
    return reference::first_bending_mode(linear_chain_of(asked)).oscillates;
  } catch (const reference::NoConvergence&) {  // the mode and its conjugate meet
    return false;
  }
}

/// Bond damping at which the linear chain's first mode ceases to swing, by bisection.
double critical_bond_damping(int aspect_ratio) {
  double low = 1, high = 1e5;
  while (high / low > 1 + 1e-6) {
    const double middle = std::sqrt(low * high);
    (swings(aspect_ratio, middle) ? low : high) = middle;
  }
  return low;
}

/// Time from a release at small load until the free end of ten bonds stays within 1 % of where it was let
/// go, in periods of the undamped fiber: a march, dashpots solved within the step.
double time_to_rest(double bond_damping) {
  const reference::ChainMode mode =
      reference::first_bending_mode(linear_chain_of(DampingCase{.bond_damping = 1e-3}));
  dem::ReleaseOptions options;
  options.form = dem::BondForm::total;
  options.integrator = dem::Integrator::leapfrog_damped;
  const dem::Fiber fiber = damped_fiber({.bond_damping = bond_damping});
  const auto record = dem::ring_down<2>({static_release(fiber, mode, 1e-3, 6)}, options).front();
  const TipHistory tip = tip_history(record, dem::fiber_length(fiber));
  std::size_t last = 0;
  for (std::size_t i = 0; i < tip.y.size(); ++i) {
    if (std::abs(tip.y[i]) > 0.01 * tip.y[0]) last = i;
  }
  return tip.time[last] * mode.frequency / (2 * std::acos(-1.0));
}

Found critical(const ValidationInput&) {
  const double limit = critical_bond_damping(10);
  const auto sooner = [](double from) { return time_to_rest(from) / time_to_rest(2 * from); };
  double apart = 0;
  for (const double part : {1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    const double ratio = linear_damping(10, part * limit) / (part * limit * linear_damping(10, 0.01) / 0.01);
    apart = std::max(apart, std::abs(ratio - 1));
  }
  return {{limit},
          {.value = sooner(limit / 4),
           .evidence = {time_to_rest(limit / 4), time_to_rest(limit / 2), time_to_rest(limit),
                        time_to_rest(2 * limit)},
           .otherwise = sooner(limit)},
          {apart}};
}

Found equation_20_itself(const ValidationInput&) {
  const double printed_8 = 0.01045, printed_10 = 0.00698;  // slopes of Fig 7
  // falls of ln xi_f by one bond, which an exponential has alike everywhere
  const auto decline = [](int r_f) {
    return std::log(linear_damping(r_f - 1) / linear_damping(r_f + 1)) / 2;
  };
  const double chain = linear_damping(30);
  return {
      {equation_20(8, 1)},
      {equation_20(10, 1)},
      {100 * (equation_20(8, 1) / printed_8 - 1), {100 * (equation_20(8, 1) / linear_damping(8) - 1)}},
      {100 * (equation_20(10, 1) / printed_10 - 1), {100 * (equation_20(10, 1) / linear_damping(10) - 1)}},
      {equation_20(30, 1) / chain, {chain, chain / equation_20(30, 1)}},
      {decline(10) / decline(30), {decline(10), decline(30)}}};
}

/// a and b of Eq 20 by the choice nearest to them of `fiberchain fit`, and by the linear chain alone.
Found equation_20_fitted(const ValidationInput& in) {
  const FitChoice nearest{{8, 10, 15, 20}, {ChoiceLoad::Kind::force, 0.004}, {1, 10}, FitKind::logarithmic};
  const DampingFit found = choice_outcomes({nearest}, chain_slopes({}, in.jobs)).front().fit;
  std::vector<DampingDatum> points;
  for (int r_f = 5; r_f <= 30; ++r_f) points.push_back({r_f, linear_damping(r_f)});
  const DampingFit plain = fit_damping({DampingLaw::exponential, FitKind::unweighted}, points);
  return {{.value = found.parameters[0], .otherwise = plain.parameters[0]},
          {.value = found.parameters[1], .otherwise = plain.parameters[1]}};
}

/// xi_f that a march of the first mode at small amplitude has, dashpots solved within the step.
double marched_damping(const dem::Fiber& fiber) {
  const reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(fiber));
  dem::ReleaseOptions options;
  options.form = dem::BondForm::total;
  options.integrator = dem::Integrator::leapfrog_damped;
  const auto record = dem::ring_down<2>({mode_release(fiber, mode, 1e-5, 4.7)}, options).front();
  return damping_from_peaks(positive_peaks(tip_history(record, dem::fiber_length(fiber))), {0, 3}).ratio;
}

/// Bond damping that gives a fiber of 30 bonds the damping wanted, held by a march.
Measured needed_bond_damping(double wanted) {
  DampingCase asked{.aspect_ratio = 30};
  for (int i = 0; i < 20; ++i) asked.bond_damping *= wanted / linear_damping(30, asked.bond_damping);
  const dem::Fiber fiber = damped_fiber(asked);
  return {asked.bond_damping,
          {marched_damping(fiber), critical_bond_damping(30),
           dem::stable_time_step(fiber) / dem::bond_time_step(fiber)}};
}

Found long_fibers(const ValidationInput&) { return {needed_bond_damping(0.001), needed_bond_damping(0.05)}; }

}  // namespace

Checks paper_damping_checks() {
  return {{{"paper-fig7-slope-8", "paper-fig7-slope-10", "paper-fig7-one-force", "paper-fig7-two-orders-8",
            "paper-fig7-two-orders-10", "paper-fig7-aspect-ratio"},
           slopes},
          {{"paper-fig7-load"}, figure_7_load},
          {{"paper-fig8-load", "paper-fig8-modulus-load", "paper-fig8-modulus"}, figure_8},
          {{"paper-critical-damping", "paper-quick-rest", "paper-fig7-proportional"}, critical},
          {{"paper-eq20-8", "paper-eq20-10", "paper-eq20-slope-8", "paper-eq20-slope-10", "paper-eq20-30",
            "paper-fig9-exponential"},
           equation_20_itself},
          {{"paper-eq20-a", "paper-eq20-b"}, equation_20_fitted},
          {{"paper-rf30-metal", "paper-rf30-wood"}, long_fibers}};
}

}  // namespace fiberchain::compare
