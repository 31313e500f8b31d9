#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/app/context.hpp"

/// What commands that measure many cases share.
namespace fiberchain::app {

/// Points of all cases, by a function such as compare::damping_points, with a bar of progress.
template <class Point, class Case, class Options>
std::vector<Point> measured(std::vector<Point> (*points_of)(const std::vector<Case>&, const Options&),
                            const std::vector<Case>& cases, int jobs, const Context& context) {
  const auto progress = context.progress(cases.size());
  Options options;
  options.jobs = jobs;
  options.advance = [&] { progress->advance(); };
  return points_of(cases, options);
}

/// Points of several groups of cases, measured together; `all` of them and group by group.
template <class Point, class Case, class Options>
std::vector<std::vector<Point>> measured_groups(std::vector<Point> (*points_of)(const std::vector<Case>&,
                                                                                const Options&),
                                                const std::vector<std::vector<Case>>& groups, int jobs,
                                                const Context& context, std::vector<Point>& all) {
  std::vector<Case> cases;
  for (const auto& group : groups) cases.insert(cases.end(), group.begin(), group.end());
  all = measured(points_of, cases, jobs, context);
  std::vector<std::vector<Point>> points;
  auto next = all.begin();
  for (const auto& group : groups) {
    const auto begin = next;
    next += static_cast<std::ptrdiff_t>(group.size());
    points.emplace_back(begin, next);
  }
  return points;
}

/// Exit status, with an error in the log if a point's damping could not be measured.
template <class Point>
int status_of(const std::vector<Point>& points, const Context& context) {
  const auto failed =
      std::ranges::count_if(points, [](const auto& point) { return std::isnan(point.damping); });
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases could not be measured, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
