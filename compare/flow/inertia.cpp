#include "compare/flow/inertia.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/flow/setup.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/model/errors.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {
namespace {

/// m rate/(6 pi mu R) = 2 rho rate R^2/(9 mu)
double density_of(double stokes, double viscosity, double radius) {
  return 4.5 * stokes * viscosity / (radius * radius);
}

constexpr double kStokes[] = {0.1, 0.03, 0.01, 0.003, 0.001};

}  // namespace

template <int Dim>
FlowHistory run_inertia(const InertiaCase& c, double strain, int intervals, bool shapes) {
  dem::Fiber fiber = fiber_of_spheres(c.spheres);
  const double viscosity = viscosity_of(fiber, c.elasto_viscous, 1);
  if (c.stokes > 0) fiber.material.density = density_of(c.stokes, viscosity, dem::sphere_radius(fiber));
  dem::FlowStart start;
  start.direction = Dim == 2 ? Triple{0, 1, 0} : Triple{0, std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
  FlowHistory history = integrate_in_flow_history<Dim>(
      {dem::straight_chain<Dim>(fiber),
       start_poses<Dim>(fiber, start),
       {viscosity, {dem::simple_shear(1)}},
       {}},
      even_times(strain, intervals), {.method = c.method, .tolerance = c.tolerance}, shapes ? 1 : 0);
  if (!history.record.failure.empty()) throw dem::Diverged(history.record.failure);
  return history;
}

double inertia_distance(const InertiaCase& c) {
  const double strain = 10;
  const int intervals = 100;
  const FlowHistory with = run_inertia<2>(c, strain, intervals, true);
  const FlowHistory without =
      run_inertia<2>({.spheres = c.spheres, .elasto_viscous = c.elasto_viscous, .tolerance = 1e-10}, strain,
                     intervals, true);
  double largest = 0;
  for (std::size_t i = 0; i < with.shapes.size(); ++i) {
    for (std::size_t k = 0; k < with.shapes[i].spheres.size(); ++k) {
      const Triple &a = with.shapes[i].spheres[k], &b = without.shapes[i].spheres[k];
      largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1]));
    }
  }
  return largest;
}

double orbit_drift(const InertiaCase& c, double orbits) {
  const double r_e = reference::free_draining_aspect_ratio(c.spheres);
  const FlowHistory history = run_inertia<3>(c, orbits * reference::jeffery_period(r_e, 1), 1);
  return reference::orbit_constant(r_e, history.moments.back().direction) /
             reference::orbit_constant(r_e, history.moments.front().direction) -
         1;
}

dem::Table flow_cost_table() {
  dem::Table table({"aspect_ratio", "spheres", "hydrodynamics", "steps", "run_time", "sphere_step_ns"});
  for (const int N : {26, 51, 101, 201, 401}) {
    double least = std::numeric_limits<double>::infinity();
    FlowHistory history{};
    for (int run = 0; run < 3; ++run) {
      history = run_inertia<2>({.spheres = N, .elasto_viscous = 1000}, 20, 2);
      least = std::min(least, history.run_time);
    }
    const double steps = history.record.work.steps;
    table.append({{"aspect_ratio", std::int64_t{N - 1}},
                  {"spheres", std::int64_t{N}},
                  {"hydrodynamics", std::string(name(dem::Hydrodynamics::free_draining))},
                  {"steps", static_cast<std::int64_t>(steps)},
                  {"run_time", least},
                  {"sphere_step_ns", 1e9 * least / (steps * N)}});
  }
  return table;
}

FlowStudy inertia_study(const OrbitOptions& options) {
  using enum dem::FlowMethod;
  std::vector<InertiaCase> cases;
  for (const auto method : {cvode, leapfrog}) {
    for (const double stokes : kStokes)
      cases.push_back({.stokes = stokes, .method = method, .tolerance = 1e-8});
  }
  std::vector<double> distance(cases.size()), drift(cases.size(), nan);
  options.jobs.run(cases.size(), [&](std::size_t i) {
    distance[i] = inertia_distance(cases[i]);
    if (cases[i].method == leapfrog) drift[i] = orbit_drift(cases[i], 1);
  });
  const double without = orbit_drift({.tolerance = 1e-11}, 1);
  FlowStudy study{dem::Table({"aspect_ratio", "spheres", "elasto_viscous", "flow_method", "stokes",
                              "inertia_distance", "order", "orbit_drift", "orbit_drift_inertialess"})};
  Figure figure{"What inertia does to a fiber of 21 spheres in shear",
                {"Stokes number {/:Italic m} rate/(6πμ{/:Italic R})", true},
                {"distance/{/:Italic L}; change of C in an orbit", true},
                {}};
  Series by_cvode{"places, cvode", {}, {}}, by_leapfrog{"places, leapfrog", {}, {}, Mark::points},
      drifts{"C, leapfrog", {}, {}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool first = i % std::size(kStokes) == 0;
    const double order =
        first ? nan
              : std::log(distance[i] / distance[i - 1]) / std::log(cases[i].stokes / cases[i - 1].stokes);
    study.table.append({{"aspect_ratio", std::int64_t{cases[i].spheres - 1}},
                        {"spheres", std::int64_t{cases[i].spheres}},
                        {"elasto_viscous", cases[i].elasto_viscous},
                        {"flow_method", std::string(name(cases[i].method))},
                        {"stokes", cases[i].stokes},
                        {"inertia_distance", distance[i]},
                        {"order", dem::known(order)},
                        {"orbit_drift", dem::known(drift[i])},
                        {"orbit_drift_inertialess", without}});
    Series& places = cases[i].method == cvode ? by_cvode : by_leapfrog;
    places.add(cases[i].stokes, distance[i]);
    if (std::isfinite(drift[i])) drifts.add(cases[i].stokes, drift[i] - without);
  }
  figure.series = {by_cvode, by_leapfrog, drifts};
  study.figures = {{"shear-inertia", std::move(figure)}};
  return study;
}

template FlowHistory run_inertia<2>(const InertiaCase&, double, int, bool);
template FlowHistory run_inertia<3>(const InertiaCase&, double, int, bool);

}  // namespace fiberchain::compare
