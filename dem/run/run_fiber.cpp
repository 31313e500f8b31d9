#include "dem/run/run_fiber.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/build_fiber.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
Vec<double, 3> in_space(const Vec<double, Dim>& v) {
  return {v[0], v[1], Dim == 3 ? v[Dim - 1] : 0.0};
}

template <int Dim>
Positions positions_of(const Poses<Dim>& poses) {
  Positions positions;
  for (const auto& pose : poses) positions.push_back(in_space<Dim>(pose.position));
  return positions;
}

template <int Dim>
CantileverResult cantilever(const CantileverScene& scene) {
  const RestState<Dim> rest = find_rest<Dim>(scene);
  return {positions_of<Dim>(rest.poses), rest.residual, rest.stability};
}

template <int Dim>
ReleaseResult release(const ReleaseScene& scene) {
  ReleaseResult result{};
  result.mode = first_mode(scene.fiber);
  ReleaseOptions options = scene.motion;
  options.energy = has_energy(scene);
  const ReleaseRecord<Dim> record =
      ring_down<Dim>({build_release<Dim>(scene, result.mode.period)}, options)[0];
  for (const TipSample<Dim>& tip : record.samples) {
    result.samples.push_back(
        {tip.time, in_space<Dim>(tip.position), in_space<Dim>(tip.velocity), tip.energy});
  }
  result.time_step = record.time_step;
  result.integrator = record.integrator;
  result.failure = record.failure;
  return result;
}

template <int Dim>
FlowResult flow(const FlowScene& scene) {
  FlowResult result{};
  const std::vector<double> times = even_times(scene.duration, scene.samples);
  result.record = integrate_in_flow<Dim>(build_flow<Dim>(scene), times, scene.motion,
                                         [&](double time, const ChainState<Dim>& state) {
                                           result.samples.push_back({time, positions_of<Dim>(state.poses)});
                                         });
  return result;
}

}  // namespace

template <int Dim>
RestState<Dim> find_rest(const CantileverScene& scene) {
  const CantileverCase<Dim> cantilever = build_cantilever<Dim>(scene);
  if (scene.method == Method::solve) {
    const SolveOptions options{.allow_unstable = scene.allow_unstable};
    const Equilibrium<Dim> found = solve_equilibrium<Dim>(cantilever.chain, cantilever.boundary, options);
    return {found.poses, found.residual, found.stability, found.statistics.newton_iterations, std::nullopt};
  }
  const RelaxCase<Dim> only{cantilever.chain, {cantilever.boundary}};
  const RelaxResult<Dim> found = relax_to_equilibrium<Dim>({only}, scene.march).front();
  const Stability stability = stability_of(cantilever.chain, found.poses, cantilever.boundary);
  if (stability == Stability::unstable && !scene.allow_unstable) {
    throw NoConvergence(
        "the march came to rest on an unstable equilibrium, which the least disturbance leaves: turn the "
        "load a "
        "little off the axis, use method: solve, or ask for it with allow_unstable: true");
  }
  return {found.poses, found.residual, stability, std::nullopt, std::llround(found.steps)};
}

CantileverResult run_scene(const CantileverScene& scene) {
  return scene.dimension == Dimension::planar ? cantilever<2>(scene) : cantilever<3>(scene);
}

ReleaseResult run_scene(const ReleaseScene& scene) {
  return scene.dimension == Dimension::planar ? release<2>(scene) : release<3>(scene);
}

FlowResult run_scene(const FlowScene& scene) {
  return scene.dimension == Dimension::planar ? flow<2>(scene) : flow<3>(scene);
}

RodResult run_scene(const RodScene& scene) {
  RodResult result{trace_rod(scene.problem, scene.path), std::nullopt};
  if (!scene.branch) return result;
  int left = scene.branch->bifurcation;
  for (const SingularPoint& point : result.path.singular) {
    if (point.kind != SingularKind::bifurcation || --left > 0) continue;
    result.branch =
        trace_branch(scene.problem, point, scene.branch->sign, scene.branch->amplitude, scene.path);
    return result;
  }
  throw NoConvergence(fmt::format(
      "branch.bifurcation = {}: the path has {} bifurcations up to load factor {:.6g}",
      scene.branch->bifurcation, scene.branch->bifurcation - left, result.path.points.back().factor));
}

template RestState<2> find_rest<2>(const CantileverScene&);
template RestState<3> find_rest<3>(const CantileverScene&);

}  // namespace fiberchain::dem
