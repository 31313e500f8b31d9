#include "compare/flow/buckling.hpp"

#include <fmt/format.h>
#include <cmath>

#include "compare/flow/setup.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {

double even_part(const FlowShape& shape, double across_x, double across_y) {
  const auto n = static_cast<double>(shape.spheres.size());
  double square = 0, sum = 0;
  const auto xi = [&](std::size_t i) { return 2 * static_cast<double>(i) / (n - 1) - 1; };
  for (std::size_t i = 0; i < shape.spheres.size(); ++i) square += xi(i) * xi(i) / n;
  for (std::size_t i = 0; i < shape.spheres.size(); ++i) {
    sum += (xi(i) * xi(i) - square) * (across_x * shape.spheres[i][0] + across_y * shape.spheres[i][1]);
  }
  return sum;
}

Threshold threshold_between(int spheres, double low, double high, double width,
                            const std::function<bool(double)>& grows) {
  if (grows(low) || !grows(high)) {
    throw InputError(
        fmt::format("a chain of {} spheres does not begin to buckle from {} to {}", spheres, low, high));
  }
  while (high - low > width) {
    const double middle = (low + high) / 2;
    (grows(middle) ? high : low) = middle;
  }
  return {low, high};
}

namespace {

/// Slope of ln|amplitude| from a third of the time on.
double fitted_growth(const std::vector<double>& time, const std::vector<double>& amplitude) {
  double n = 0, t = 0, y = 0, tt = 0, ty = 0;
  for (std::size_t i = time.size() / 3; i < time.size(); ++i) {
    const double log = std::log(std::abs(amplitude[i]));
    n += 1, t += time[i], y += log, tt += time[i] * time[i], ty += time[i] * log;
  }
  return (n * ty - t * y) / (n * tt - t * t);
}

}  // namespace

BucklingRun run_buckling(const BucklingCase& c, int shapes) {
  constexpr int intervals = 60;
  const dem::Fiber fiber = fiber_of_spheres(c.spheres, c.poisson_ratio);
  const dem::Fluid fluid{viscosity_of(fiber, c.number, 1), {dem::planar_extension(-1)}};
  dem::FlowStart start;
  start.direction = {1, 0, 0};
  start.bend_direction = {0, 1, 0};
  start.bend = c.bend;
  FlowHistory history =
      integrate_in_flow_history<2>({dem::straight_chain<2>(fiber), start_poses<2>(fiber, start), fluid, {}},
                                   even_times(c.duration, intervals), {.tolerance = c.tolerance}, 1);
  if (!history.record.failure.empty()) throw dem::Diverged(history.record.failure);
  BucklingRun run{};
  const double first = even_part(history.shapes.front(), 0, 1);
  for (const FlowShape& shape : history.shapes) {
    run.time.push_back(shape.time);
    run.amplitude.push_back(even_part(shape, 0, 1) / first);
  }
  run.growth = fitted_growth(run.time, run.amplitude);
  for (int k = 0; k < shapes; ++k)
    run.shapes.push_back(history.shapes[static_cast<std::size_t>(k * intervals / (shapes - 1))]);
  return run;
}

Threshold buckling_threshold_of(int spheres, double low, double high, double width) {
  return threshold_between(spheres, low, high, width, [&](double number) {
    return run_buckling({.spheres = spheres, .number = number}).growth > 0;
  });
}

}  // namespace fiberchain::compare
