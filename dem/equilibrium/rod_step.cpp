#include "dem/equilibrium/rod_step.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {
namespace {

/// As of newton.cpp: a step beyond the first means nothing; below the second it may have ended in rounding.
constexpr double largest_rod_step = 1.0, rod_round_off = 1e-6;

void add(RodDirection& sum, const RodDirection& step) {
  for (std::size_t i = 0; i < sum.motion.size(); ++i) sum.motion[i] += step.motion[i];
  sum.factor += step.factor;
}

/// What the equation measures since the point before.
double measured(const PathEquation& equation, const RodDirection& sum, const RodState& from,
                const RodState& now) {
  if (equation.probe) {
    const auto i = static_cast<std::size_t>(equation.probe->sphere);
    return dot(equation.probe->direction, now.poses[i].position - from.poses[i].position);
  }
  return (equation.row.empty() ? 0 : dot_product<3>(equation.row, sum.motion)) +
         equation.factor_row * sum.factor;
}

/// The sphere whose position the others follow: one that does not move, or the first.
int anchor_of(const RodProblem& problem) {
  for (const RodSupport& support : problem.supports) {
    if (std::ranges::all_of(support.hold_displacement, [](bool held) { return held; })) return support.sphere;
  }
  return 0;
}

/// Whether the rotations turned out against those foreseen: onto another branch.
bool turned_against(const RodDirection& predictor, const RodDirection& sum) {
  double product = 0;
  for (std::size_t i = 0; i < sum.motion.size(); ++i) {
    product += predictor.motion[i].tail<3>().dot(sum.motion[i].tail<3>());
  }
  return product < 0;
}

}  // namespace

RodDirection& RodDirection::operator*=(double by) {
  for (auto& part : motion) part *= by;
  factor *= by;
  return *this;
}

double inner_product(const RodContext& context, const RodDirection& a, const RodDirection& b) {
  const double length = fiber_length(context.problem.chain.fiber);
  double sum = 0;
  for (std::size_t i = 0; i < a.motion.size(); ++i) {
    sum += a.motion[i].head<3>().dot(b.motion[i].head<3>()) / (length * length) +
           a.motion[i].tail<3>().dot(b.motion[i].tail<3>());
  }
  return sum / static_cast<double>(a.motion.size()) + a.factor * b.factor;
}

PathEquation along(const RodContext& context, const RodDirection& a, double target) {
  const double length = fiber_length(context.problem.chain.fiber);
  PathEquation equation{.row = a.motion, .factor_row = a.factor, .target = target};
  for (auto& part : equation.row) {
    part.head<3>() /= length * length;
    part /= static_cast<double>(a.motion.size());
  }
  return equation;
}

RodDirection bordered_solve(const RodSystem& system, const PathEquation& equation, double missing,
                            bool with_unbalanced) {
  const ChainFactors<6> factors(system.K);
  RodDirection step{system.unbalanced, 0};
  ChainVector<3> by_factor = system.by_factor;
  factors.solve_in_place(by_factor);
  to_global(system.held, by_factor);
  if (with_unbalanced) {
    factors.solve_in_place(step.motion);
    to_global(system.held, step.motion);
  } else {
    std::ranges::fill(step.motion, SphereVector<3>::Zero());
  }
  double row_a = equation.factor_row, row_r = 0;
  if (!equation.row.empty()) {
    row_a -= dot_product<3>(equation.row, by_factor);
    row_r = dot_product<3>(equation.row, step.motion);
  }
  step.factor = (missing - row_r) / row_a;
  for (std::size_t i = 0; i < by_factor.size(); ++i) step.motion[i] -= step.factor * by_factor[i];
  return step;
}

void advance(const RodContext& context, RodState& state, const RodDirection& direction) {
  const int anchor = anchor_of(context.problem);
  const Vec<double, 3> moved = displacement_part<3>(direction.motion[static_cast<std::size_t>(anchor)]);
  for (auto& pose : state.poses) pose.position = pose.position + moved;
  move(context.problem.chain, Boundary<3>{{anchor}, {}}, state.poses, direction.motion);
  state.factor += direction.factor;
}

std::optional<RodState> rod_newton(const RodContext& context, const RodState& from,
                                   const PathEquation& equation, const RodDirection& predictor,
                                   int& iterations) {
  const double length = fiber_length(context.problem.chain.fiber);
  RodState state = from;
  RodDirection sum = predictor;
  advance(context, state, predictor);
  double previous = largest_rod_step;
  for (int iteration = 0; iteration < context.options.max_iterations; ++iteration) {
    stop_if_asked(context.options.asked_to_stop, "stopped on the rod's path");
    const RodSystem system = rod_system(context.problem, context.start, state.poses, state.factor);
    const RodDirection step =
        bordered_solve(system, equation, equation.target - measured(equation, sum, from, state), true);
    ++iterations;
    const double size = std::max(size_of<3>(step.motion, length),
                                 std::abs(step.factor) / std::max(std::abs(state.factor), 1.0));
    const bool at_round_off = size < rod_round_off && size > 0.25 * previous;
    if (!(size <= largest_rod_step) || (iteration > 2 && size > 2 * previous && !at_round_off)) {
      return std::nullopt;
    }
    advance(context, state, step);
    add(sum, step);
    if (previous < context.options.tolerance || size == 0 || at_round_off) {
      if (turned_against(predictor, sum)) return std::nullopt;
      return state;
    }
    previous = size;
  }
  return std::nullopt;
}

double probe_displacement(const RodContext& context, const Poses<3>& poses) {
  const RodProbe& probe = context.options.probe;
  const auto i = static_cast<std::size_t>(probe.sphere);
  return dot(probe.direction, poses[i].position - context.start[i].position);
}

}  // namespace fiberchain::dem
