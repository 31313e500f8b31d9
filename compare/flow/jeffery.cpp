#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "compare/flow/study.hpp"
#include "compare/study/tabulate.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {
namespace {

/// In the plane of gradient and vorticity, where tan(theta) = C.
Triple start_direction(double bounded) {
  return bounded == 1 ? Triple{0, 1, 0} : Triple{0, bounded / (1 - bounded), 1};
}

JefferyRun measured(OrbitPoint point, double bounded) {
  const double r_e = reference::free_draining_aspect_ratio(point.asked.spheres);
  const auto orbit = reference::jeffery_orbit(r_e, 1, point.asked.direction);
  const double period = reference::jeffery_period(r_e, 1);
  const double C = reference::orbit_constant(r_e, point.asked.direction);
  JefferyRun run{std::move(point), 0, 0, bounded};
  for (const FlowMoment& m : run.point.history.moments) {
    if (m.time <= period) {
      const auto q = reference::direction_on_orbit(orbit, m.time);
      const Triple& p = m.direction;
      run.distance = std::max(run.distance, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    const double change = bounded == 1 ? m.direction[2] : reference::orbit_constant(r_e, m.direction) / C - 1;
    run.drift = std::max(run.drift, std::abs(change));
  }
  return run;
}

/// A point of the unit sphere as it is drawn: seen from above the x-z plane, x to the right, z (vorticity)
/// up.
std::pair<double, double> drawn(const Triple& p) {
  const double a = 0.45, b = 0.35;  // azimuth and height of the view
  const double right = p[0] * std::cos(a) - p[1] * std::sin(a),
               deep = p[0] * std::sin(a) + p[1] * std::cos(a);
  return {right, p[2] * std::cos(b) + deep * std::sin(b)};
}

Figure sphere_figure(const std::vector<JefferyRun>& runs) {
  Figure figure{"Orbits of a chain of 11 spheres on the unit sphere, free draining",
                {"flow, seen aslant"},
                {"vorticity, seen aslant"},
                {}};
  figure.equal_axes = true;
  figure.legend_title = "C/(1 + C)";
  int color = 0;
  const double r_e = reference::free_draining_aspect_ratio(runs.front().point.asked.spheres);
  const double period = reference::jeffery_period(r_e, 1);
  for (const JefferyRun& run : runs) {
    Series exact{"", {}, {}, Mark::line, Dash::solid, color};
    Series chain{fmt::format("{:.1f}", run.constant), {}, {}, Mark::points, Dash::solid, color++};
    const auto orbit = reference::jeffery_orbit(r_e, 1, run.point.asked.direction);
    for (double t = 0; t <= period * 1.001; t += period / 4000) {
      const auto [x, y] = drawn(reference::direction_on_orbit(orbit, t));
      exact.add(x, y);
    }
    double last = -1;
    for (const FlowMoment& m : run.point.history.moments) {
      if (m.time > period || m.time - last < 0.4) continue;
      const auto [x, y] = drawn(m.direction);
      chain.add(x, y);
      last = m.time;
    }
    figure.series.push_back(std::move(exact));
    figure.series.push_back(std::move(chain));
  }
  Series rim{"", {}, {}, Mark::line, Dash::dotted, 6};
  for (int i = 0; i <= 200; ++i)
    rim.add(std::cos(std::numbers::pi * i / 100), std::sin(std::numbers::pi * i / 100));
  figure.series.push_back(std::move(rim));
  return figure;
}

dem::Table table_of(const std::vector<JefferyRun>& runs) {
  return tabulate(runs, [&](const JefferyRun& run) -> dem::NamedRow {
    const OrbitCase& c = run.point.asked;
    const double period = reference::jeffery_period(reference::free_draining_aspect_ratio(c.spheres), 1);
    return {{"aspect_ratio", std::int64_t{c.spheres - 1}},
            {"spheres", std::int64_t{c.spheres}},
            {"hydrodynamics", std::string(name(c.hydrodynamics))},
            {"elasto_viscous", c.elasto_viscous},
            {"orbit_constant", run.constant},
            {"orbits", run.point.history.record.reached / period},
            {"period", run.point.period},
            {"period_jeffery", period},
            {"period_error", run.point.period / period - 1},
            {"direction_error", run.distance},
            {"orbit_constant_drift", run.drift},
            {"bending_angle", run.point.bending_angle},
            {"steps", static_cast<std::int64_t>(run.point.history.record.work.steps)},
            {"run_time", run.point.history.run_time},
            {"status", run.point.status}};
  });
}

}  // namespace

std::vector<JefferyRun> jeffery_runs(int spheres, double orbits, const std::vector<double>& constants,
                                     const OrbitOptions& options) {
  std::vector<OrbitCase> cases;
  for (const double bounded : constants) {
    cases.push_back({.spheres = spheres,
                     .direction = start_direction(bounded),
                     .turns = orbits,
                     .interval = orbits > 10 ? 0.4 : 0.1,
                     .tolerance = 1e-10,
                     .spatial = true});
  }
  std::vector<OrbitPoint> points = orbit_points(cases, options);
  std::vector<JefferyRun> runs;
  for (std::size_t i = 0; i < points.size(); ++i)
    runs.push_back(measured(std::move(points[i]), constants[i]));
  return runs;
}

FlowStudy jeffery_study(const OrbitOptions& options) {
  std::vector<JefferyRun> runs = jeffery_runs(11, 100, kOrbitConstants, options);
  const Figure figure = sphere_figure(runs);
  for (const int spheres : {2, 5, 30, 101}) {
    std::ranges::move(jeffery_runs(spheres, 1, kOrbitConstants, options), std::back_inserter(runs));
  }
  const auto failed =
      std::ranges::count_if(runs, [](const JefferyRun& r) { return std::isnan(r.point.period); });
  return {.table = table_of(runs), .figures = {{"shear-sphere", figure}}, .failed = static_cast<int>(failed)};
}

}  // namespace fiberchain::compare
