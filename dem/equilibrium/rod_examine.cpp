#include "dem/equilibrium/rod_examine.hpp"

#include <algorithm>
#include <cmath>

#include "dem/chain/pivots.hpp"

namespace fiberchain::dem {
namespace {

/// Negative eigenvalues and what they say. Without a potential only the determinant's sign is told: 1 where
/// it is negative.
void tell_stability(const RodContext& context, const RodSystem& system, RodPoint& point) {
  const RodProblem& problem = context.problem;
  if (!has_potential(problem)) {
    point.negative = negative_determinant(system.K);
    point.stability = Stability::undecided;
    return;
  }
  const double zero = zero_eigenvalue(problem.chain);
  if (negative_pivots(held_tangent(problem, system, zero)) == 0) {
    point.negative = 0;
    point.stability = Stability::stable;
    return;
  }
  point.negative = negative_pivots(held_tangent(problem, system, -zero));
  point.stability = point.negative == 0 ? Stability::neutral : Stability::unstable;
}

/// The way on. The row of the arc length is the way that led there: no sudden turn back.
RodDirection tangent_at(const RodContext& context, const RodSystem& system, const RodDirection& before) {
  PathEquation equation = path_equation(context, before, 1);
  RodDirection tangent = bordered_solve(system, equation, 1, false);
  if (context.options.control == RodControl::arc_length)
    tangent *= 1 / std::sqrt(inner_product(context, tangent, tangent));
  return tangent;
}

/// W v with W of stability.hpp, zero where held.
void weigh(const RodContext& context, const std::vector<HeldSphere>& held, ChainVector<3>& v) {
  const Fiber& fiber = context.problem.chain.fiber;
  const double length = fiber_length(fiber), unit = bending_stiffness(fiber) / length;
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i].head<3>() *= unit / (length * length);
    v[i].tail<3>() *= unit;
    for (int k = 0; k < 6; ++k) {
      if (held[i].held[static_cast<std::size_t>(k)]) v[i][k] = 0;
    }
  }
}

/// A vector that no mode is orthogonal to.
ChainVector<3> any_vector(const RodContext& context, std::size_t spheres) {
  const double length = fiber_length(context.problem.chain.fiber);
  ChainVector<3> v(spheres);
  for (std::size_t i = 0; i < spheres; ++i) {
    for (int k = 0; k < 6; ++k)
      v[i][k] = std::sin(1.7 * static_cast<double>(i + 1) + 2.3 * k) + 0.4 + 0.1 * k;
    v[i].head<3>() *= length;
  }
  return v;
}

void point_upwards(ChainVector<3>& mode, double length) {
  SphereVector<3> sum = SphereVector<3>::Zero();
  for (const auto& part : mode) sum += part;
  sum.head<3>() /= length;
  for (const int k : {1, 2, 0, 5, 4, 3}) {
    if (std::abs(sum[k]) < 1e-6 * static_cast<double>(mode.size())) continue;
    if (sum[k] < 0) {
      for (auto& part : mode) part = -part;
    }
    return;
  }
}

}  // namespace

PathEquation path_equation(const RodContext& context, const RodDirection& tangent, double step) {
  switch (context.options.control) {
    case RodControl::load:
      return {.row = {}, .factor_row = 1, .target = step};
    case RodControl::displacement: {
      const RodProbe& probe = context.options.probe;
      PathEquation equation{.row = ChainVector<3>(context.start.size(), SphereVector<3>::Zero()),
                            .target = step,
                            .probe = probe};
      equation.row[static_cast<std::size_t>(probe.sphere)] = motion_of<3>(probe.direction, {});
      return equation;
    }
    default:
      return along(context, tangent, step);
  }
}

RodStation station_at(const RodContext& context, const RodState& state, const RodDirection& before) {
  const RodSystem system = rod_system(context.problem, context.start, state.poses, state.factor);
  RodStation station{state, {}, tangent_at(context, system, before)};
  RodPoint& point = station.point;
  point.factor = state.factor;
  point.poses = state.poses;
  point.elastic_energy = elastic_energy(context.problem.chain, state.poses);
  point.probe = probe_displacement(context, state.poses);
  tell_stability(context, system, point);
  return station;
}

std::optional<RodStation> station_after(const RodContext& context, const RodStation& from, double step,
                                        int& iterations) {
  RodDirection predictor = from.tangent;
  predictor *= step;
  int here = 0;
  const auto state =
      rod_newton(context, from.state, path_equation(context, from.tangent, step), predictor, here);
  iterations += here;
  if (!state) return std::nullopt;
  RodStation station = station_at(context, *state, from.tangent);
  station.point.iterations = here;
  station.point.arc =
      from.point.arc + std::abs(step) * std::sqrt(inner_product(context, from.tangent, from.tangent));
  return station;
}

NearestMode nearest_mode(const RodContext& context, const RodState& state) {
  const RodSystem system = rod_system(context.problem, context.start, state.poses, state.factor);
  const ChainFactors<6> factors(system.K);
  const double length = fiber_length(context.problem.chain.fiber);
  ChainVector<3> v = any_vector(context, state.poses.size());
  double eigenvalue = 0;
  for (int n = 0; n < 12; ++n) {
    stop_if_asked(context.options.asked_to_stop, "stopped on the rod's path");
    ChainVector<3> weighted = v;
    weigh(context, system.held, weighted);
    const double size = dot_product<3>(v, weighted);
    ChainVector<3> next = weighted;
    factors.solve_in_place(next);
    const double before = eigenvalue;
    eigenvalue = size / dot_product<3>(weighted, next);
    const double largest = size_of<3>(next, length);
    if (!(largest < 1e300)) break;
    for (auto& part : next) part /= largest;
    v = std::move(next);
    if (n > 2 && std::abs(eigenvalue - before) < 1e-10 * std::abs(eigenvalue)) break;
  }
  to_global(system.held, v);
  point_upwards(v, length);
  return {eigenvalue, std::move(v)};
}

}  // namespace fiberchain::dem
