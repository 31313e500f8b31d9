#include "reference/rod_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/errors.hpp"

namespace fiberchain::reference::detail {
namespace {

/// Residuals and unknowns of motions in the plane of x and y: places x, y, turn z, force x, y, moment z.
constexpr std::array<int, 6> plane_unknowns{0, 1, 5, 6, 7, 11}, plane_rows{0, 1, 5, 6, 7, 11},
    other_unknowns{2, 3, 4, 8, 9, 10}, other_rows{2, 3, 4, 8, 9, 10};

double determinant(const ResidualSlope& slope, const std::array<int, 6>& rows,
                   const std::array<int, 6>& columns) {
  return slope(rows, columns).determinant();
}

/// Solution of slope x = residual, row x = value; in the plane where the rod stays in it.
Unknowns solution(const ScaledRod& rod, const ResidualSlope& slope, const Residual& residual,
                  const Unknowns& row, double value) {
  Eigen::Matrix<double, 13, 13> A;
  A << slope, row.transpose();
  Eigen::Matrix<double, 13, 1> b;
  b << residual, value;
  if (!rod.planar) return A.fullPivLu().solve(b);
  constexpr std::array<int, 7> rows{0, 1, 5, 6, 7, 11, 12}, unknowns{0, 1, 5, 6, 7, 11, 12};
  Unknowns x = Unknowns::Zero();
  const Eigen::Matrix<double, 7, 7> plane = A(rows, unknowns);
  x(unknowns) = plane.fullPivLu().solve(Eigen::Matrix<double, 7, 1>(b(rows)));
  return x;
}

/// Largest miss: of places over L, of turns, of forces and moments over the largest there is (at least E I /
/// L^2, E I / L).
double largest(const ScaledRod& rod, const Shot& shot) {
  double force = 1;
  for (const SectionState& at : shot.sections)
    force = std::max({force, at.force.lpNorm<Eigen::Infinity>(), at.moment.lpNorm<Eigen::Infinity>()});
  const auto is_force = [](const RodEnd& end, int i) {
    return i < 3 ? !end.held[static_cast<std::size_t>(i)] : end.joint != RodJoint::clamped;
  };
  Residual miss = shot.residual;
  for (int i = 0; i < 12; ++i)
    if (is_force(i < 6 ? rod.begin : rod.end, i % 6)) miss[i] /= force;
  if (!rod.planar) return miss.lpNorm<Eigen::Infinity>();
  return miss(plane_rows).lpNorm<Eigen::Infinity>();
}

}  // namespace

RodPoint converged(const ScaledRod& rod, const SectionState& start, double factor, const StepRow& step) {
  constexpr double enough = 1e-11;
  RodPoint point{start, factor, shoot(rod, start, factor)};
  double left = step.value;
  for (int i = 0; i < 30; ++i) {
    const double residual = largest(rod, point.shot);
    if (!std::isfinite(residual)) break;
    if (residual < enough && std::abs(left) < 1e-9) return point;
    const Unknowns by = solution(rod, point.shot.slope, Residual(-point.shot.residual), step.row, left);
    if (!by.allFinite() || by.segment<3>(3).norm() > 2) break;
    left -= step.row.dot(by);
    point.begin = moved(point.begin, by);
    point.factor += by[12];
    point.shot = shoot(rod, point.begin, point.factor);
  }
  throw NoConvergence("the ends of a rod in space");
}

Unknowns metric(const ScaledRod& rod) {
  const auto size = [](const ScaledLoads& loads) {
    return std::max({1.0, loads.force.norm(), loads.weight.norm(), loads.following_force.norm(),
                     loads.following_weight.norm(), loads.begin_force.norm()});
  };
  double force = std::max(size(rod.steady), size(rod.varied));
  for (const RodSegment& part : rod.segments)
    for (const double component : part.joint_force) force = std::max(force, std::abs(component));
  Unknowns weights = Unknowns::Ones();
  weights.segment<3>(6).setConstant(1 / (force * force));
  weights.segment<3>(9).setConstant(1 / force);
  return weights;
}

Unknowns tangent(const ScaledRod& rod, const ResidualSlope& slope, const Unknowns& along) {
  const Unknowns weights = metric(rod);
  Unknowns t = solution(rod, slope, Residual::Zero(), weights.cwiseProduct(along), 1);
  t /= std::sqrt(t.dot(weights.cwiseProduct(t)));
  return t;
}

RodEquilibrium equilibrium_of(const ScaledRod& rod, const RodPoint& point) {
  RodEquilibrium out{.factor = point.factor,
                     .sections = {},
                     .residual = largest(rod, point.shot),
                     .slope = point.tangent[12],
                     .in_plane = determinant(point.shot.slope, plane_rows, plane_unknowns),
                     .out_of_plane = determinant(point.shot.slope, other_rows, other_unknowns)};
  for (const SectionState& section : point.shot.sections) out.sections.push_back(section_of(section, rod));
  return out;
}

}  // namespace fiberchain::reference::detail
