#include <fmt/format.h>

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

/// Runs at r_f = 50, nu = 0.3 against the waves of the endless chain, a row for each xi_b.
std::vector<MatrixRow> limit_rows(const ValidationInput& in) {
  const StabilitySweep sweep{.aspect_ratio = {50},
                             .poisson_ratio = {0.3},
                             .bond_damping = {0, 0.1, 0.25, 0.5, 1, 2, 5},
                             .bond = {BondModel::paper},
                             .scheme = {Integrator::leapfrog}};
  std::vector<MatrixRow> rows;
  for (const StabilityPoint& p : stability_points(cases(sweep), {.jobs = in.jobs})) {
    rows.push_back(method_row(
        fmt::format("stable-step-{:g}", p.asked.bond_damping), "stability", p.endless, p.measured,
        0.005 * p.endless,
        "spectral radius of the amplification matrix over all waves, lagged "
        "dashpots, over t_b",
        fmt::format("runs bracket it to 0.1 %: nu = 0.3, xi_b = {:g}, r_f = 50", p.asked.bond_damping)));
  }
  return rows;
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

/// Runs against modes over the map, both bonds.
std::vector<MatrixRow> agreement_rows(const ValidationInput& in) {
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
  constexpr const char* source = "largest stable step of the finite chain by its modes";
  return {
      method_row("stable-step-runs", "stability", 0, worst_difference(in, {lagged, spatial}), 0.01, source,
                 "largest relative difference of runs, lagged dashpots: planar clamped and spatial free "
                 "chains, nu = "
                 "-0.2 to 0.49, xi_b = 0 to 10, r_f = 5 and 13, both bonds"),
      method_row(
          "stable-step-runs-damped", "stability", 0, worst_difference(in, {solved}), 0.01, source,
          "the same with the dashpots solved within the step, whose limit is the undamped one: planar, nu = "
          "-0.2 to 0.49, xi_b = 0.3 and 10, r_f = 5, both bonds")};
}

/// The step that marches take their default from, against the spectral radius: largest relative difference.
MatrixRow own_step_row() {
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
  return method_row(
      "stable-step-own", "stability", 0, worst, 1e-5,
      "spectral radius of the amplification matrix over all waves",
      "largest relative difference of the step limit that marches use, nu = -0.2 to 0.49, xi_b = 0 to 10");
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

std::vector<MatrixRow> paper_rows(const ValidationInput& in) {
  const StabilityPoint one = stability_points({{.aspect_ratio = 10, .bond_damping = 1}})[0];
  return {disputed_row(
              in, "paper-quarter-step", one.measured,
              fmt::format(
                  "at xi_b = 1, nu = 0.3, r_f = 10 the largest stable step is {:.4f} t_b by runs, {:.4f} by "
                  "modes: 0.25 t_b is {}, its fastest mode grows {:.2f} times a step. It is small enough up "
                  "to xi_b = {:.3f}, at nu = -0.2 up to {:.3f}",
                  one.measured, one.modes, one.quarter_verdict, one.quarter_growth,
                  damping_of_quarter_step(one.asked),
                  damping_of_quarter_step({.aspect_ratio = 10, .poisson_ratio = -0.2}))),
          published_row(in, "paper-rayleigh-most", rayleigh_percent(0), 0.5,
                        "pi R sqrt(rho/G)/(0.1631 nu + 0.8766) at nu = 0"),
          disputed_row(
              in, "paper-rayleigh-least", rayleigh_percent(0.5),
              fmt::format(
                  "falls with nu: {:.1f} % at nu = 0, {:.1f} % at 0.3 and, the least an isotropic material "
                  "can have, {:.1f} % at 0.5",
                  rayleigh_percent(0), rayleigh_percent(0.3), rayleigh_percent(0.5)))};
}

}  // namespace

std::vector<MatrixRow> stability_rows(const ValidationInput& in) {
  std::vector<MatrixRow> rows = paper_rows(in);
  for (MatrixRow& row : limit_rows(in)) rows.push_back(std::move(row));
  for (MatrixRow& row : agreement_rows(in)) rows.push_back(std::move(row));
  rows.push_back(own_step_row());
  return rows;
}

}  // namespace fiberchain::compare
