#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
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

/// All parts in one list, to be measured together.
template <class Case>
std::vector<Case> joined(std::initializer_list<std::span<const Case>> parts) {
  std::vector<Case> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Hands measured points back part by part, in the order they were joined in.
template <class Point>
class Portions {
 public:
  explicit Portions(const std::vector<Point>& points) : rest_(points) {}

  std::vector<Point> next(std::size_t count) {
    const auto portion = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(portion.size());
    return {portion.begin(), portion.end()};
  }

 private:
  std::span<const Point> rest_;
};

/// Exit status, with an error in the log if a point's damping could not be measured.
template <class Point>
int status_of(const std::vector<Point>& points, const Context& context) {
  const auto failed =
      std::ranges::count_if(points, [](const auto& point) { return std::isnan(point.damping); });
  if (context.stopped != 0) return kSignaled + context.stopped;
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases could not be measured, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
