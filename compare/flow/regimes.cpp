#include "compare/flow/regimes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flow/setup.hpp"
#include "compare/flow/turn_detection.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {
namespace {

constexpr double pi = std::numbers::pi;

double unwrapped(double angle, double before, double turn) {
  return angle + turn * std::round((before - angle) / turn);
}

/// Directions of the bonds in the x-y plane, without jumps.
std::vector<double> directions(const FlowShape& shape) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < shape.spheres.size(); ++i) {
    const Triple &a = shape.spheres[i], &b = shape.spheres[i + 1];
    const double angle = std::atan2(b[1] - a[1], b[0] - a[0]);
    all.push_back(all.empty() ? angle : unwrapped(angle, all.back(), 2 * pi));
  }
  return all;
}

double extent(const FlowShape& shape, std::size_t axis) {
  const auto [least, most] =
      std::ranges::minmax_element(shape.spheres, {}, [=](const Triple& at) { return at[axis]; });
  return (*most)[axis] - (*least)[axis];
}

double contour(const FlowShape& shape) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < shape.spheres.size(); ++i) {
    const Triple &a = shape.spheres[i], &b = shape.spheres[i + 1];
    length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return length;
}

/// Angle of the gyration tensor's long axis, up to half turns.
double long_axis(const FlowShape& shape) {
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  const auto n = static_cast<double>(shape.spheres.size());
  for (const Triple& at : shape.spheres) x += at[0] / n, y += at[1] / n;
  for (const Triple& at : shape.spheres) {
    xx += (at[0] - x) * (at[0] - x), yy += (at[1] - y) * (at[1] - y), xy += (at[0] - x) * (at[1] - y);
  }
  return std::atan2(2 * xy, xx - yy) / 2;
}

/// Changes of sign of the bends that are more than a fifth of the largest; none in a fiber that is as good as
/// straight.
int inflections(const std::vector<double>& directions) {
  double largest = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    largest = std::max(largest, std::abs(directions[i] - directions[i - 1]));
  }
  if (largest < 0.01) return 0;
  int changes = 0;
  double last = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    const double bend = directions[i] - directions[i - 1];
    if (std::abs(bend) < largest / 5) continue;
    changes += bend * last < 0;
    last = bend;
  }
  return changes;
}

FlowHistory followed(const RegimeCase& c) {
  const dem::Fiber fiber = fiber_of_spheres(c.spheres);
  const dem::Fluid fluid{viscosity_of(fiber, c.elasto_viscous, 1), {dem::simple_shear(1)}};
  dem::FlowStart start;
  const double length = std::hypot(1, 0.05);
  start.direction = {-1 / length, 0.05 / length, 0};
  start.bend_direction = {-0.05 / length, -1 / length, 0};
  start.bend = c.bend;
  start.s_bend = c.bend / 3;
  const double strain =
      c.turns * reference::jeffery_period(reference::free_draining_aspect_ratio(c.spheres), 1);
  return integrate_in_flow_history<2>(
      {dem::straight_chain<2>(fiber), start_poses<2>(fiber, start), fluid, {}},
      even_times(strain, static_cast<int>(20 * strain)), {.tolerance = c.tolerance}, 1);
}

/// The shapes of the first interval in which the fiber is short in the flow's direction.
std::vector<FlowShape> first_turn(const std::vector<FlowShape>& shapes) {
  std::vector<FlowShape> turn;
  for (const FlowShape& shape : shapes) {
    if (extent(shape, 0) < 0.95) {
      turn.push_back(shape);
    } else if (!turn.empty()) {
      break;
    }
  }
  return turn;
}

Regime regime_of(const RegimePoint& p) {
  if (p.direction_span >= 1.5 * pi) return Regime::coil;
  if (p.half_turns > 2 * p.axis_half_turns) return Regime::snake_turn;
  if (p.end_to_end_least < 0.9) return Regime::c_shaped;
  return p.end_to_end_least < 0.99 ? Regime::springy : Regime::rigid;
}

RegimePoint point_of(const RegimeCase& asked) {
  const FlowHistory history = followed(asked);
  RegimePoint p{};
  p.asked = asked;
  p.end_to_end_least = 1;
  double axis = 0;
  for (std::size_t i = 0; i < history.shapes.size(); ++i) {
    const FlowShape& shape = history.shapes[i];
    const std::vector<double> along = directions(shape);
    const auto [least, most] = std::ranges::minmax(along);
    p.direction_span = std::max(p.direction_span, most - least);
    p.stretch = std::max(p.stretch, std::abs(contour(shape) - 1));
    p.inflections = std::max(p.inflections, inflections(along));
    p.gradient_extent = std::max(p.gradient_extent, extent(shape, 1));
    p.end_to_end_least = std::min(p.end_to_end_least, history.moments[i].end_to_end);
    axis = unwrapped(long_axis(shape), axis, pi);
  }
  p.half_turns = static_cast<int>(half_turns(history.moments).size());
  p.axis_half_turns = static_cast<int>(std::lround(std::abs(axis) / pi));
  p.period = orbit_period(history.moments);
  p.turning = first_turn(history.shapes);
  p.run_time = history.run_time;
  p.status = history.record.failure.empty() ? "finished" : history.record.failure;
  p.regime = regime_of(p);
  return p;
}

}  // namespace

std::string_view name(Regime regime) {
  constexpr std::string_view names[] = {"rigid", "springy", "C-shaped", "snake turn", "coil"};
  return names[static_cast<int>(regime)];
}

std::vector<RegimePoint> regime_points(const std::vector<RegimeCase>& cases, const OrbitOptions& options) {
  std::vector<RegimePoint> points(cases.size());
  options.jobs.run(cases.size(), [&](std::size_t i) {
    points[i] = point_of(cases[i]);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
