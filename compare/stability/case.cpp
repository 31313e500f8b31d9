#include "compare/stability/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/motion/implicit_bond.hpp"

namespace fiberchain::compare {
namespace {

constexpr double width = 1.4e-3;  // of the measured bracket

/// What a run at that time step does, watched for longer the nearer it is to the limit.
std::string verdict(const StabilityRun& run, double dt, const MeasuredLimit& limit, double& all_steps) {
  const int steps = steps_to_grow(run, std::clamp(std::abs(dt / limit.stable - 1) / 2, width / 2, 0.1));
  all_steps += steps;
  return motion_grows(run, {dt}, steps)[0] ? "unstable" : "stable";
}

void measure(StabilityPoint& point) {
  const StabilityRun run = run_of(point.asked);
  const double t_b = dem::bond_time_step(run.fiber);
  const MeasuredLimit limit = measured_limit(run, width);
  point.measured = (limit.stable + limit.unstable) / 2 / t_b;
  point.half_width = (limit.unstable - limit.stable) / 2 / t_b;
  point.difference = point.measured / point.modes - 1;
  point.steps = limit.steps;
  point.quarter_verdict = verdict(run, 0.25 * t_b, limit, point.steps);
  point.bond_time_verdict = verdict(run, t_b, limit, point.steps);
  point.status = limit.ordered ? "measured" : "measured, but a smaller step grew and a larger one did not";
}

StabilityPoint unmeasured(const StabilityCase& asked) {
  return {asked, nan, nan, nan, nan, nan, nan, "", "", 0, std::string(not_begun)};
}

/// Spheres times steps, about.
double cost_of(const StabilityCase& asked) {
  return (asked.aspect_ratio + 1.0) * steps_to_grow(run_of(asked), width / 2);
}

StabilityPoint point_of(const StabilityCase& asked) {
  const reference::LinearChain chain = linear_chain_of(stability_fiber(asked));
  const bool planar = asked.dimension == 2;
  StabilityPoint point{asked, endless_limit(asked), modal_limit(asked), nan, nan, nan, nan, "", "", 0, ""};
  point.quarter_growth = reference::growth_per_step(chain, time_scheme(asked.scheme), asked.ends,
                                                    0.25 * reference::bond_time(chain), planar);
  measure(point);
  return point;
}

}  // namespace

reference::TimeScheme time_scheme(dem::Integrator scheme) {
  if (scheme == dem::Integrator::leapfrog) return reference::lagged_dashpots;
  if (scheme == dem::Integrator::leapfrog_damped) return reference::damped_in_step;
  if (scheme == dem::Integrator::leapfrog_stiff) return reference::bonds_in_step(dem::stiff_beta);
  throw InputError(fmt::format("scheme = {} is not allowed: leapfrog, leapfrog-damped or leapfrog-stiff",
                               dem::name(scheme)));
}

bool has_stable_step(dem::Integrator scheme) { return time_scheme(scheme).beta < 0.25; }

StabilityRun run_of(const StabilityCase& asked) {
  return {.fiber = stability_fiber(asked),
          .ends = asked.ends,
          .dimension = asked.dimension,
          .form = asked.form,
          .scheme = asked.scheme};
}

void check(const StabilityCase& asked) {
  dem::check(stability_fiber(asked));
  time_scheme(asked.scheme);
  if (asked.dimension != 2 && asked.dimension != 3) {
    throw InputError(fmt::format("dimension = {} is not allowed: 2 or 3", asked.dimension));
  }
}

dem::Fiber stability_fiber(const StabilityCase& asked) {
  dem::Fiber fiber = nominal_fiber(asked.aspect_ratio, asked.poisson_ratio, asked.bond);
  fiber.bond_damping = asked.bond_damping;
  return fiber;
}

double modal_limit(const StabilityCase& asked) {
  const reference::LinearChain chain = linear_chain_of(stability_fiber(asked));
  return reference::finite_stable_step(chain, time_scheme(asked.scheme), asked.ends, asked.dimension == 2) /
         reference::bond_time(chain);
}

double endless_limit(const StabilityCase& asked) {
  const reference::LinearChain chain = linear_chain_of(stability_fiber(asked));
  return reference::endless_stable_step(chain, time_scheme(asked.scheme), asked.dimension == 2) /
         reference::bond_time(chain);
}

std::vector<StabilityPoint> stability_points(const std::vector<StabilityCase>& cases,
                                             const StabilityOptions& options) {
  for (const StabilityCase& asked : cases) {
    check(asked);
    if (!has_stable_step(asked.scheme))
      throw InputError(fmt::format("scheme = {} has no stable step to be found", dem::name(asked.scheme)));
  }
  std::vector<double> costs;
  std::vector<StabilityPoint> points;
  for (const StabilityCase& asked : cases) {
    costs.push_back(cost_of(asked));
    points.push_back(unmeasured(asked));
  }
  options.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (options.stopped()) return;
    points[i] = point_of(cases[i]);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
