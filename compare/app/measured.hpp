#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
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
    const auto portion = rest_.first(count);
    rest_ = rest_.subspan(count);
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
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases could not be measured, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
