#pragma once

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <functional>
#include <vector>

#include "compare/app/context.hpp"
#include "compare/app/sharded.hpp"
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

/// The exit status of points that were until_stopped; an error in words if some have not converged.
template <class Point>
int status_of_unconverged(const std::vector<Point>& points, const Context& context) {
  const auto failed = std::ranges::count_if(points, [](const Point& point) { return !has_converged(point); });
  if (context.stopped != 0) return kSignaled + context.stopped;
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases did not converge, see column status", failed, points.size());
  return kRunFailed;
}

/// Points, and the numbers that their cases have in the whole, from 0.
template <class Point>
struct CasePoints {
  std::vector<Point> points;
  std::vector<std::size_t> numbers;
};

/// Those of cases [from, to) that were begun.
template <class Point>
CasePoints<Point> begun(const CasePoints<Point>& all, std::size_t from, std::size_t to) {
  CasePoints<Point> some;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    const std::size_t number = all.numbers[i];
    if (number < from || number >= to || all.points[i].status == compare::not_begun) continue;
    some.points.push_back(all.points[i]);
    some.numbers.push_back(number);
  }
  return some;
}

/// Points of these of the cases that were begun before a signal came.
template <class Point, class Case, class Options>
CasePoints<Point> measured(PointsOf<Point, Case, Options> points_of, const std::vector<Case>& cases,
                           const std::vector<std::size_t>& numbers, const compare::Jobs& jobs,
                           const Context& context) {
  const std::vector<Case> own = chosen(cases, numbers);
  if (own.empty()) return {};
  return begun(CasePoints<Point>{points_until_stopped(points_of, own, jobs, context), numbers}, 0,
               cases.size());
}

/// The same of all cases, or the shard's.
template <class Point, class Case, class Options>
CasePoints<Point> measured(PointsOf<Point, Case, Options> points_of, const std::vector<Case>& cases,
                           const OutputOptions& output, Context& context) {
  return measured(points_of, cases, deal(cases.size(), output, context), output.jobs, context);
}

/// The same of several groups of cases, measured together; `all` of them and group by group.
template <class Point, class Case, class Options>
std::vector<CasePoints<Point>> measured_groups(PointsOf<Point, Case, Options> points_of,
                                               const std::vector<std::vector<Case>>& groups,
                                               const OutputOptions& output, Context& context,
                                               CasePoints<Point>& all) {
  std::vector<Case> cases;
  for (const auto& group : groups) cases.insert(cases.end(), group.begin(), group.end());
  all = measured(points_of, cases, output, context);
  std::vector<CasePoints<Point>> points;
  std::size_t next = 0;
  for (const auto& group : groups) {
    points.push_back(begun(all, next, next + group.size()));
    next += group.size();
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
