#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "compare/app/context.hpp"

/// What commands that measure many cases share.
namespace fiberchain::app {

/// Points of all cases, by a function such as compare::damping_points, with a bar of progress. A signal ends
/// it after the cases at work: `context.stopped` then, and the points measured until then.
template <class Point, class Case, class Options>
std::vector<Point> measured(std::vector<Point> (*points_of)(const std::vector<Case>&, const Options&),
                            const std::vector<Case>& cases, int jobs, const Context& context) {
  const StopSignals signals;
  const auto progress = context.progress(cases.size());
  Options options;
  options.jobs = jobs;
  options.advance = [&] { progress->advance(); };
  const std::size_t part = 4 * static_cast<std::size_t>(std::max(jobs, 1));
  std::vector<Point> points;
  for (std::size_t n = 0; n < cases.size() && context.stopped == 0; n += part) {
    const auto end = std::min(n + part, cases.size());
    const auto more = points_of(
        {cases.begin() + static_cast<std::ptrdiff_t>(n), cases.begin() + static_cast<std::ptrdiff_t>(end)},
        options);
    points.insert(points.end(), more.begin(), more.end());
    if (end < cases.size()) context.stopped = signals.received();
  }
  if (context.stopped != 0)
    context.log->info("stopped: {} of {} cases were measured", points.size(), cases.size());
  return points;
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
  std::span<const Point> rest = all;
  for (const auto& group : groups) {
    const auto part = rest.first(std::min(group.size(), rest.size()));
    points.emplace_back(part.begin(), part.end());
    rest = rest.subspan(part.size());
  }
  return points;
}

struct HasDamping {
  bool operator()(const auto& point) const { return !std::isnan(point.damping); }
};

/// Exit status, with an error in the log if a point could not be measured: of its damping, unless told.
template <class Point, class IsMeasured = HasDamping>
int status_of(const std::vector<Point>& points, const Context& context, const IsMeasured& is_measured = {}) {
  const auto failed = std::ranges::count_if(points, std::not_fn(is_measured));
  if (context.stopped != 0) return kSignaled + context.stopped;
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases could not be measured, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
