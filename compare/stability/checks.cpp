#include <algorithm>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/table.hpp"
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
      {{"stable-step-own"}, own_step}};
  return checks;
}

}  // namespace fiberchain::compare
