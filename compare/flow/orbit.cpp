#include "compare/flow/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "compare/flow/setup.hpp"
#include "compare/flow/turn_detection.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {
namespace {

template <int Dim>
FlowHistory followed(const OrbitCase& c) {
  const dem::Fiber fiber = fiber_of_spheres(c.spheres, c.poisson_ratio);
  const dem::Fluid fluid{viscosity_of(fiber, c.elasto_viscous, 1), {dem::simple_shear(1)}, c.hydrodynamics};
  dem::FlowStart start;
  start.direction = c.direction;
  const double period = reference::jeffery_period(reference::free_draining_aspect_ratio(c.spheres), 1);
  const double duration = (c.turns + 0.25) * period;
  return integrate_in_flow_history<Dim>(
      {dem::straight_chain<Dim>(fiber), start_poses<Dim>(fiber, start), fluid, {}},
      even_times(duration, static_cast<int>(std::ceil(duration / c.interval))), {.tolerance = c.tolerance});
}

OrbitPoint point_of(OrbitCase c) {
  const double length = std::hypot(c.direction[0], c.direction[1], c.direction[2]);
  for (double& part : c.direction) part /= length;
  OrbitPoint point{.asked = c,
                   .history = c.direction[2] == 0 && !c.spatial ? followed<2>(c) : followed<3>(c),
                   .status = "finished"};
  if (!point.history.record.failure.empty()) point.status = point.history.record.failure;
  point.period = orbit_period(point.history.moments);
  for (const FlowMoment& m : point.history.moments) {
    point.bending_angle = std::max(point.bending_angle, m.bending_angle);
    point.stretch = std::max(point.stretch, std::abs(m.end_to_end - 1));
  }
  return point;
}

}  // namespace

std::vector<OrbitPoint> orbit_points(const std::vector<OrbitCase>& cases, const OrbitOptions& options) {
  std::vector<OrbitPoint> points(cases.size());
  options.jobs.run(cases.size(), [&](std::size_t i) {
    points[i] = point_of(cases[i]);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
