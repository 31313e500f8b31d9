#include "compare/flow/shear_passage.hpp"

#include <cmath>
#include <numbers>

#include "compare/flow/buckling.hpp"
#include "compare/flow/history.hpp"
#include "compare/flow/setup.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Amplitude across the line of the ends.
double bend_of(const FlowShape& shape) {
  const auto& x = shape.spheres;
  const double dx = x.back()[0] - x.front()[0], dy = x.back()[1] - x.front()[1], length = std::hypot(dx, dy);
  return even_part(shape, -dy / length, dx / length);
}

double angle_of(const FlowShape& shape) {
  return std::atan2(shape.spheres.back()[1] - shape.spheres.front()[1],
                    shape.spheres.back()[0] - shape.spheres.front()[0]);
}

}  // namespace

double growth_at_passage(const ShearPassage& c) {
  constexpr double before = 0.35, passage = 0.75 * std::numbers::pi;
  const dem::Fiber fiber = fiber_of_spheres(c.spheres, c.poisson_ratio);
  const dem::Fluid fluid{viscosity_of(fiber, c.number, 1), {dem::simple_shear(1)}};
  dem::FlowStart start;
  start.direction = {std::cos(passage + before), std::sin(passage + before), 0};
  start.bend_direction = {-start.direction[1], start.direction[0], 0};
  start.bend = c.bend;
  const FlowHistory history =
      integrate_in_flow_history<2>({dem::straight_chain<2>(fiber), start_poses<2>(fiber, start), fluid, {}},
                                   even_times(1.5, 600), {.tolerance = c.tolerance}, 1);
  if (!history.record.failure.empty()) throw dem::Diverged(history.record.failure);
  // the interval in which it passes: central differences at both ends, linear in between
  for (std::size_t i = 2; i + 3 < history.shapes.size(); ++i) {
    const double here = angle_of(history.shapes[i]), next = angle_of(history.shapes[i + 1]);
    if (here < passage || next >= passage) continue;
    const auto log_at = [&](std::size_t k) { return std::log(std::abs(bend_of(history.shapes[k]))); };
    const double h = history.shapes[i + 1].time - history.shapes[i].time;
    const auto slope = [&](std::size_t k) { return (log_at(k + 1) - log_at(k - 1)) / (2 * h); };
    const double part = (here - passage) / (here - next);
    return (1 - part) * slope(i) + part * slope(i + 1);
  }
  throw InputError("the fiber did not pass the direction of greatest compression");
}

double passage_threshold(int spheres, double low, double high, double width) {
  return threshold_between(
             spheres, low, high, width,
             [&](double number) { return growth_at_passage({.spheres = spheres, .number = number}) > 0; })
      .middle();
}

}  // namespace fiberchain::compare
