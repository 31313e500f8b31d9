#pragma once

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <functional>
#include <vector>

#include "compare/app/context.hpp"
#include "compare/study/jobs.hpp"
#include "compare/study/stopping.hpp"

/// What commands that measure many cases share.
namespace fiberchain::app {

template <class Point, class Case, class Options>
using PointsOf = std::vector<Point> (*)(const std::vector<Case>&, const Options&);

/// Points of all cases, by a function such as compare::damping_points, with a bar of progress. A signal ends
/// it after those at work: `context.stopped` then, and the others keep the status not_begun.
template <class Point, class Case, class Options>
std::vector<Point> points_until_stopped(PointsOf<Point, Case, Options> points_of,
                                        const std::vector<Case>& cases, const compare::Jobs& jobs,
                                        const Context& context) {
  std::vector<Point> points;
  std::size_t left = 0;
  {
    const StopSignals signals;
    const auto progress = context.progress(cases.size());
    Options options;
    options.jobs = jobs;
    options.advance = [&] { progress->advance(); };
    options.stopped = [&] { return signals.received() != 0; };
    points = points_of(cases, options);
    left = static_cast<std::size_t>(std::ranges::count(points, compare::not_begun, &Point::status));
    if (left > 0) context.stopped = signals.received();
  }
  if (left > 0 && left == points.size()) std::raise(context.stopped);  // nothing to keep
  if (left > 0)
    context.log->info("stopped: {} of {} cases were measured", points.size() - left, points.size());
  return points;
}

/// Those that were begun.
template <class Point>
std::vector<Point> begun(std::vector<Point> points) {
  std::erase_if(points, [](const Point& point) { return point.status == compare::not_begun; });
  return points;
}

/// Points of all cases that were begun before a signal came.
template <class Point, class Case, class Options>
std::vector<Point> measured(PointsOf<Point, Case, Options> points_of, const std::vector<Case>& cases,
                            const compare::Jobs& jobs, const Context& context) {
  return begun(points_until_stopped(points_of, cases, jobs, context));
}

/// The same of several groups of cases, measured together; `all` of them and group by group.
template <class Point, class Case, class Options>
std::vector<std::vector<Point>> measured_groups(PointsOf<Point, Case, Options> points_of,
                                                const std::vector<std::vector<Case>>& groups,
                                                const compare::Jobs& jobs, const Context& context,
                                                std::vector<Point>& all) {
  std::vector<Case> cases;
  for (const auto& group : groups) cases.insert(cases.end(), group.begin(), group.end());
  all = points_until_stopped(points_of, cases, jobs, context);
  std::vector<std::vector<Point>> points;
  auto next = all.begin();
  for (const auto& group : groups) {
    const auto end = next + static_cast<std::ptrdiff_t>(group.size());
    points.push_back(begun(std::vector<Point>(next, end)));
    next = end;
  }
  all = begun(std::move(all));
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
