#include "reference/spatial_rod.hpp"

#include <algorithm>
#include <cmath>

#include "reference/errors.hpp"
#include "reference/rod_newton.hpp"

namespace fiberchain::reference {
namespace detail {
namespace {

SpaceVector array(const Vector3d& u) { return {u[0], u[1], u[2]}; }

double length_of(const SpatialRod& rod) {
  double length = 0;
  for (const RodSegment& part : rod.segments) {
    require_positive("length", part.length);
    length += part.length;
  }
  require_positive("length", length);
  return length;
}

ScaledLoads scaled(const RodLoads& loads, double force, double length) {
  return {vector(loads.force) / force,
          vector(loads.moment) / (force * length),
          vector(loads.weight) * length / force,
          vector(loads.following_force) / force,
          vector(loads.following_weight) * length / force,
          vector(loads.begin_force) / force,
          vector(loads.begin_moment) / (force * length)};
}

SpaceVector times(SpaceVector v, double factor) {
  for (double& component : v) component *= factor;
  return v;
}

/// Where the rest shape has the end.
SectionState resting_end(const ScaledRod& rod) {
  ScaledRod bare = rod;
  bare.steady = bare.varied = {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                               Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  return shoot(bare, {}, 0).sections.back();
}

}  // namespace

ScaledRod scaled(const RodProblem& problem) {
  const SpatialRod& rod = problem.rod;
  const double length = length_of(rod);
  require_positive("bending", rod.bending);
  require_positive("torsion", rod.torsion);
  require_positive_or_infinite("axial", rod.axial);
  require_positive_or_infinite("shear", rod.shear);
  if (rod.sideways != 0) require_positive("sideways", rod.sideways);
  const double force = rod.bending / (length * length);
  ScaledRod one{.segments = rod.segments,
                .torsion = rod.torsion / rod.bending,
                .sideways = rod.sideways > 0 ? rod.sideways / rod.bending : 1,
                .stretch = force / rod.axial,
                .shear = force / rod.shear,
                .steady = scaled(problem.steady, force, length),
                .varied = scaled(problem.varied, force, length),
                .begin = problem.begin,
                .end = problem.end,
                .end_position = Vector3d::Zero(),
                .end_frame = Eigen::Quaterniond::Identity(),
                .planar = problem.planar,
                .length = length,
                .force = force};
  for (RodSegment& part : one.segments) {
    part.length /= length;
    part.rest_curvature = times(part.rest_curvature, length);
    part.joint_force = times(part.joint_force, 1 / force);
  }
  for (RodEnd* end : {&one.begin, &one.end}) end->moved = times(end->moved, 1 / length);
  if (problem.end_pose) {
    Unknowns by = Unknowns::Zero();
    by.head<3>() = vector(problem.end_pose->position) / length;
    by.segment<3>(3) = vector(problem.end_pose->rotation);
    const SectionState end = moved({}, by);
    one.end_position = end.position, one.end_frame = end.frame;
  } else {
    const SectionState end = resting_end(one);
    one.end_position = end.position, one.end_frame = end.frame;
  }
  return one;
}

SectionState scaled(const RodSection& section, const ScaledRod& rod) {
  const auto& q = section.orientation;
  return {vector(section.position) / rod.length, Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized(),
          vector(section.force) / rod.force, vector(section.moment) / (rod.force * rod.length)};
}

RodSection section_of(const SectionState& state, const ScaledRod& rod) {
  const Eigen::Quaterniond& q = state.frame;
  return {array(state.position * rod.length),
          {q.x(), q.y(), q.z(), q.w()},
          array(state.force * rod.force),
          array(state.moment * rod.force * rod.length)};
}

namespace {

RodPoint at_factor(const ScaledRod& rod, const SectionState& begin, double factor) {
  return converged(rod, begin, factor, {Unknowns::Unit(12), 0});
}

/// Begin of the next point, as far ahead of the last as that was of the one before.
SectionState ahead(const SectionState& before, const SectionState& last, double ratio) {
  const Eigen::AngleAxisd turn(last.frame * before.frame.conjugate());
  return {last.position + ratio * (last.position - before.position),
          Eigen::Quaterniond(Eigen::AngleAxisd(ratio * turn.angle(), turn.axis())) * last.frame,
          last.force + ratio * (last.force - before.force),
          last.moment + ratio * (last.moment - before.moment)};
}

RodPoint followed(const ScaledRod& rod, double factor, int steps) {
  RodPoint last = at_factor(rod, {}, 0);
  SectionState before = last.begin;
  double step = factor / steps, done_step = step;
  int left = 2000;
  while (last.factor != factor && left-- > 0) {
    const double next = std::abs(factor - last.factor) < 1.001 * std::abs(step) ? factor : last.factor + step;
    try {
      RodPoint found = at_factor(rod, ahead(before, last.begin, (next - last.factor) / done_step), next);
      before = last.begin, done_step = next - last.factor;
      last = std::move(found);
    } catch (const NoConvergence&) {
      step /= 2;
      if (std::abs(step) < 1e-6 * std::abs(factor)) throw;
    }
  }
  return last;
}

}  // namespace
}  // namespace detail

RodSection rod_at_rest() { return {{}, {0, 0, 0, 1}, {}, {}}; }

RodEquilibrium solve_rod(const RodProblem& problem, double factor, const RodSection& begin) {
  const detail::ScaledRod rod = detail::scaled(problem);
  return detail::equilibrium_of(rod, detail::at_factor(rod, detail::scaled(begin, rod), factor));
}

RodEquilibrium follow_rod(const RodProblem& problem, double factor, int steps) {
  const detail::ScaledRod rod = detail::scaled(problem);
  return detail::equilibrium_of(rod, detail::followed(rod, factor, steps));
}

std::vector<RodSection> rod_shape(const RodProblem& problem, const RodEquilibrium& equilibrium, int points) {
  const detail::ScaledRod rod = detail::scaled(problem);
  std::vector<RodSection> shape;
  const auto begin = detail::scaled(equilibrium.sections.front(), rod);
  for (const auto& state : detail::shape_of(rod, begin, equilibrium.factor, points))
    shape.push_back(detail::section_of(state, rod));
  return shape;
}

SpaceVector spatial_rod_end(const SpatialRod& rod, const RodLoads& loads, int load_steps) {
  return follow_rod({.rod = rod, .varied = loads}, 1, load_steps).sections.back().position;
}

}  // namespace fiberchain::reference
