#include "dem/equilibrium/rod_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/equilibrium/rod_examine.hpp"
#include "dem/equilibrium/rod_loads.hpp"
#include "dem/equilibrium/rod_singular.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Newton iterations of a step that is as long as it should be.
constexpr double usual_iterations = 5;
/// Cosine between the ways before and after a step below which the step was too long.
constexpr double least_cosine = 0.4;

void require(bool allowed, std::string_view what, double value, std::string_view rule) {
  if (!allowed) throw InvalidInput(fmt::format("{} = {} is not allowed: {}", what, value, rule));
}

void check_options(const RodProblem& problem, const RodPathOptions& options) {
  require(options.points >= 1, "points", options.points, "at least 1");
  require(options.most_points >= 1, "most_points", options.most_points, "at least 1");
  require(std::isfinite(options.end_factor) && options.end_factor != 0, "end_factor", options.end_factor,
          "finite and not 0");
  require(options.largest_step >= 0, "largest_step", options.largest_step, "not below 0");
  require(options.tolerance > 0 && options.tolerance < 1e-2, "tolerance", options.tolerance,
          "above 0, below 0.01");
  require(options.max_iterations >= 3, "max_iterations", options.max_iterations, "at least 3");
  const bool probed = options.control == RodControl::displacement || options.end_displacement != 0;
  const RodProbe& probe = options.probe;
  require(probe.sphere >= 0 && probe.sphere <= problem.chain.fiber.aspect_ratio, "probe", probe.sphere,
          "a sphere of the rod");
  const double size = norm(probe.direction);
  require(!probed || std::abs(size - 1) < 1e-9, "length of the probe's direction", size, "1");
  require(options.control != RodControl::displacement || std::abs(options.end_displacement) > 0,
          "end_displacement", options.end_displacement, "not 0 where the displacement leads");
}

RodDirection nowhere(const RodContext& context) {
  return {ChainVector<3>(context.start.size(), SphereVector<3>::Zero()), 0};
}

/// The problem with a part of what does not go with the load factor.
RodProblem with_steady_part(RodProblem problem, double part) {
  problem.gravity = part * problem.gravity;
  const auto reduce = [&](auto& load) {
    if (load.steady) load.force = part * load.force;
  };
  for (RodLineLoad& load : problem.line_loads) reduce(load);
  for (RodPointLoad& load : problem.point_loads) {
    reduce(load);
    if (load.steady) load.moment = part * load.moment;
  }
  return problem;
}

/// Equilibrium at load factor 0, steady loads brought on in as many parts as it takes.
RodState equilibrium_at_start(const RodContext& context, int& iterations) {
  RodState state{context.start, 0};
  const PathEquation unloaded{.row = {}, .factor_row = 1, .target = 0};
  double part = 0, step = 1;
  while (part < 1) {
    const double next = std::min(part + step, 1.0);
    const RodProblem problem = with_steady_part(context.problem, next);
    const RodContext reduced{problem, context.start, context.options};
    if (auto found = rod_newton(reduced, state, unloaded, nowhere(context), iterations)) {
      state = std::move(*found);
      part = next;
      step *= 2;
    } else {
      step /= 2;
    }
    if (step < 1e-4 || (step < 1 && !has_steady_loads(context.problem))) {
      throw NoConvergence(fmt::format(
          "no equilibrium found near the start at load factor 0, beyond {:.6g} of the steady loads", part));
    }
  }
  return state;
}

/// The first station: the way on as the load factor grows toward the end.
RodStation first_station(const RodContext& context, const RodState& state) {
  RodPathOptions by_load = context.options;
  if (by_load.control == RodControl::arc_length) by_load.control = RodControl::load;
  const RodContext loaded{context.problem, context.start, by_load};
  RodStation station = station_at(loaded, state, nowhere(context));
  if (context.options.control == RodControl::arc_length) {
    const double size = std::copysign(std::sqrt(inner_product(context, station.tangent, station.tangent)),
                                      context.options.end_factor);
    station.tangent *= 1 / size;
  }
  return station;
}

/// Work of everything outside of the bonds over a step, whose forces the bonds balance: the trapezoid.
double work_between(const RodContext& context, const Poses<3>& a, const Poses<3>& b) {
  const ChainVector<3> before = bond_forces(context.problem.chain, a),
                       after = bond_forces(context.problem.chain, b);
  double work = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec<double, 3> turn = rotation_vector(b[i].orientation * conjugate(a[i].orientation));
    work -= 0.5 * (before[i] + after[i]).dot(motion_of<3>(b[i].position - a[i].position, turn));
  }
  return work;
}

/// Walks from station to station; holds the step's length.
class Walk {
 public:
  Walk(const RodContext& context, RodStation first, double first_step, RodPath path)
      : context_(context),
        here_(std::move(first)),
        path_(std::move(path)),
        step_(first_step),
        largest_(largest(first_step)),
        smallest_(context.options.smallest_step * std::abs(first_step)),
        begun_at_(here_.state.factor) {
    path_.points.push_back(here_.point);
  }

  RodPath to_the_end() {
    while (!done_) {
      if (std::abs(step_) < smallest_) {
        throw NoConvergence(fmt::format(
            "no equilibrium found beyond {:.6g} of the load ({} path points, {} Newton iterations)",
            here_.state.factor, path_.points.size(), path_.newton_iterations));
      }
      one_step();
      const bool arc = context_.options.control == RodControl::arc_length;
      if (arc && static_cast<int>(path_.points.size()) >= context_.options.most_points) done_ = true;
    }
    return std::move(path_);
  }

 private:
  double largest(double first_step) const {
    const RodPathOptions& options = context_.options;
    if (options.control != RodControl::arc_length) return std::abs(first_step);
    return options.largest_step > 0 ? options.largest_step : 4 * std::abs(first_step);
  }

  void one_step() {
    const double step = limited(step_);
    auto next = station_after(context_, here_, step, path_.newton_iterations);
    if (!next || turned_sharply(*next)) return halve();
    if (passes_end(*next)) {
      if (!land(step, *next)) halve();
      return;
    }
    accept(std::move(*next), step);
  }

  /// The step of load and displacement ends at the end.
  double limited(double step) const {
    if (context_.options.control == RodControl::arc_length) return step;
    const double left = remaining();
    return std::abs(step) >= std::abs(left) * (1 - 1e-12) ? left : step;
  }

  double remaining() const {
    const RodPathOptions& options = context_.options;
    return options.control == RodControl::load ? options.end_factor - here_.state.factor
                                               : options.end_displacement - here_.point.probe;
  }

  bool turned_sharply(const RodStation& next) const {
    if (context_.options.control != RodControl::arc_length) return false;
    return inner_product(context_, here_.tangent, next.tangent) < least_cosine;
  }

  bool passes_end(const RodStation& next) const {
    if (context_.options.control != RodControl::arc_length) return false;
    const double end = context_.options.end_factor, way = std::copysign(1.0, end - begun_at_);
    return way * (next.state.factor - end) >= 0 && way * (here_.state.factor - end) < 0;
  }

  /// The point at the end's load factor itself, `next` being the first beyond it.
  bool land(double step, const RodStation& next) {
    const double missing = context_.options.end_factor - here_.state.factor;
    const double part = missing / (next.state.factor - here_.state.factor);
    RodDirection predictor = here_.tangent;
    predictor *= part * step;
    predictor.factor = missing;
    int iterations = 0;
    const auto state = rod_newton(context_, here_.state, {.row = {}, .factor_row = 1, .target = missing},
                                  predictor, iterations);
    path_.newton_iterations += iterations;
    if (!state) return false;
    RodStation last = station_at(context_, *state, here_.tangent);
    last.point.iterations = iterations;
    last.point.arc = here_.point.arc + part * step;
    accept(std::move(last), part * step);
    done_ = true;
    return true;
  }

  void halve() {
    step_ /= 2;
    ++path_.halvings;
  }

  void accept(RodStation next, double step) {
    if (context_.options.find_singular) find_singular_points(context_, here_, next, step, path_);
    next.point.work = here_.point.work + work_between(context_, here_.state.poses, next.state.poses);
    path_.points.push_back(next.point);
    const double growth = std::clamp(usual_iterations / std::max(next.point.iterations, 1), 0.5, 2.0);
    step_ = std::copysign(std::min(growth * std::abs(step_), largest_), step_);
    here_ = std::move(next);
    const RodPathOptions& options = context_.options;
    if (options.control != RodControl::arc_length) {
      done_ = std::abs(remaining()) <= 1e-12 * std::max(std::abs(step), std::abs(largest_));
    } else if (options.end_displacement != 0) {
      done_ = here_.point.probe / options.end_displacement >= 1;
    }
  }

  const RodContext& context_;
  RodStation here_;
  RodPath path_;
  double step_, largest_, smallest_, begun_at_;
  bool done_ = false;
};

RodContext context_of(const RodProblem& problem, const RodPathOptions& options) {
  check(problem);
  check_options(problem, options);
  return {problem, problem.start.empty() ? problem.chain.poses : problem.start, options};
}

double first_step(const RodPathOptions& options, const RodStation& first) {
  const double part = 1.0 / options.points;
  if (options.control == RodControl::load) return part * options.end_factor;
  if (options.control == RodControl::displacement) return part * options.end_displacement;
  return part * std::abs(options.end_factor / first.tangent.factor);
}

}  // namespace

RodPath trace_rod(const RodProblem& problem, const RodPathOptions& options) {
  const RodContext context = context_of(problem, options);
  RodPath path;
  const RodState state = equilibrium_at_start(context, path.newton_iterations);
  RodStation first = first_station(context, state);
  const double step = first_step(options, first);
  return Walk(context, std::move(first), step, std::move(path)).to_the_end();
}

RodPath trace_branch(const RodProblem& problem, const SingularPoint& bifurcation, int sign, double amplitude,
                     const RodPathOptions& options) {
  const RodContext context = context_of(problem, options);
  require(sign == 1 || sign == -1, "sign", sign, "1 or -1");
  require(amplitude > 0 && amplitude < 1, "amplitude", amplitude, "above 0, below 1");
  RodPath path;
  const RodState state{bifurcation.point.poses, bifurcation.point.factor};
  RodDirection off{bifurcation.mode, 0};
  off *= sign * amplitude;
  const double size = std::sqrt(inner_product(context, off, off));
  const auto branch =
      rod_newton(context, state, along(context, off, size * size), off, path.newton_iterations);
  if (!branch) throw NoConvergence(fmt::format("no branch found at load factor {:.6g}", state.factor));
  off *= 1 / size;
  RodPathOptions by_arc = options;
  by_arc.control = RodControl::arc_length;
  const RodContext on_branch{problem, context.start, by_arc};
  RodPoint crossing = bifurcation.point;
  crossing.arc = crossing.work = 0;
  RodStation first = station_at(on_branch, *branch, off);
  first.point.arc = size;
  first.point.work = work_between(context, crossing.poses, branch->poses);
  path.points.push_back(std::move(crossing));
  const double step =
      by_arc.largest_step > 0 ? std::min(by_arc.largest_step, 4 * size) : 1.0 / options.points;
  return Walk(on_branch, std::move(first), step, std::move(path)).to_the_end();
}

RodPoint solve_rod(const RodProblem& problem, double factor, const RodPathOptions& options) {
  RodPathOptions by_load = options;
  by_load.control = RodControl::load;
  by_load.end_factor = factor;
  by_load.points = 1;
  by_load.find_singular = false;
  by_load.smallest_step = 1e-3;
  try {
    return trace_rod(problem, by_load).points.back();
  } catch (const NoConvergence&) {
    by_load.control = RodControl::arc_length;
    by_load.points = options.points;
    by_load.smallest_step = options.smallest_step;
    const RodPath path = trace_rod(problem, by_load);
    if (std::abs(path.points.back().factor - factor) > 1e-9 * std::abs(factor)) {
      throw NoConvergence(
          fmt::format("load factor {} not reached within {} path points", factor, path.points.size()));
    }
    return path.points.back();
  }
}

}  // namespace fiberchain::dem
