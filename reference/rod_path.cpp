#include "reference/rod_path.hpp"

#include <algorithm>
#include <cmath>

#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"
#include "reference/rod_newton.hpp"

namespace fiberchain::reference {
namespace {

using detail::RodPoint;
using detail::ScaledRod;
using detail::Unknowns;

/// A step of this length along the path, and the tangent there.
RodPoint stepped(const ScaledRod& rod, const RodPoint& from, double length) {
  const Unknowns by = length * from.tangent, row = detail::metric(rod).cwiseProduct(from.tangent);
  RodPoint next = detail::converged(rod, detail::moved(from.begin, by), from.factor + by[12], {row, 0});
  next.tangent = detail::tangent(rod, next.shot.slope, from.tangent);
  return next;
}

RodPoint point_of(const ScaledRod& rod, const RodEquilibrium& at, const Unknowns& along) {
  const auto begin = detail::scaled(at.sections.front(), rod);
  RodPoint point{begin, at.factor, detail::shoot(rod, begin, at.factor)};
  point.tangent = detail::tangent(rod, point.shot.slope, along);
  return point;
}

}  // namespace

std::vector<RodEquilibrium> rod_path(const RodProblem& problem, const RodEquilibrium& start,
                                     const RodPathOptions& options) {
  const ScaledRod rod = detail::scaled(problem);
  RodPoint last = point_of(rod, start, Unknowns::Unit(12));
  std::vector<RodEquilibrium> path{detail::equilibrium_of(rod, last)};
  double step = options.first_step;
  while (static_cast<int>(path.size()) < options.points && !options.ends(path.back())) {
    try {
      RodPoint next = stepped(rod, last, step);
      // a sharp turn would leave points of the path out
      if (next.tangent.dot(detail::metric(rod).cwiseProduct(last.tangent)) < 0.9)
        throw NoConvergence("a sharp turn of a path");
      last = std::move(next);
      path.push_back(detail::equilibrium_of(rod, last));
      step = std::min(1.3 * step, options.largest_step);
    } catch (const NoConvergence&) {
      step /= 2;
      if (step < 1e-9) throw;
    }
  }
  return path;
}

std::vector<RodEquilibrium> rod_limit_points(const RodProblem& problem,
                                             const std::vector<RodEquilibrium>& path) {
  const ScaledRod rod = detail::scaled(problem);
  std::vector<RodEquilibrium> found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path[i].slope * path[i + 1].slope >= 0) continue;
    Unknowns along = Unknowns::Unit(12) * path[i].slope;
    const RodPoint from = point_of(rod, path[i], along);
    // the distance to the next point, a little more
    double far = 0.01;
    while (stepped(rod, from, far).tangent[12] * from.tangent[12] > 0 && far < 1) far *= 1.5;
    const double length = detail::find_root([&](double s) { return stepped(rod, from, s).tangent[12]; }, 0,
                                            far, {1e-12, 1e-13, 100}, "a limit point of a rod");
    found.push_back(detail::equilibrium_of(rod, stepped(rod, from, length)));
  }
  return found;
}

double rod_critical_factor(const RodProblem& problem, double low, double high, RodMotion motion) {
  RodEquilibrium near = follow_rod(problem, low);
  const auto determinant = [&](double factor) {
    near = solve_rod(problem, factor, near.sections.front());
    return motion == RodMotion::in_plane ? near.in_plane : near.out_of_plane;
  };
  return detail::find_root(determinant, low, high, {0, 1e-13, 200}, "a critical load of a rod");
}

}  // namespace fiberchain::reference
