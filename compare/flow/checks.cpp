#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flow/buckling.hpp"
#include "compare/flow/inertia.hpp"
#include "compare/flow/setup.hpp"
#include "compare/flow/shear_passage.hpp"
#include "compare/study/validation.hpp"
#include "reference/compressed_chain.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/filament_buckling.hpp"
#include "reference/jeffery.hpp"
#include "reference/rigid_chain_mobility.hpp"

namespace fiberchain::compare {
namespace {

using dem::Hydrodynamics;
using Rows = std::vector<MatrixRow>;

const std::string kOrbits = "Jeffery orbits";
const std::string kBuckling = "buckling in flow";

double worst(const dem::Table& periods, std::string_view hydrodynamics) {
  double largest = 0;
  for (std::size_t i = 0; i < periods.rows().size(); ++i) {
    if (periods.text(i, "hydrodynamics") != hydrodynamics) continue;
    const double error = std::abs(periods.number(i, "period_error"));
    largest = error <= largest ? largest : error;  // a NaN stays
  }
  return largest;
}

/// The paper's statements on Fig 5, r = N = 50. `fifty` are the periods there: free draining and with
/// interactions.
Rows figure_rows(const ValidationInput& in, double draining, double interacting) {
  const auto over = [](double period, double r_e) {
    return 100 * (period / reference::jeffery_period(r_e, 1) - 1);
  };
  const double cox = reference::cox_aspect_ratio(50), measured = reference::goldsmith_mason_aspect_ratio(50);
  using enum reference::ChainCoupling;
  const auto resistance = reference::rigid_chain_resistance({50, force_torque});
  const double resolved = reference::rigid_chain_period({50, force_torque_stresslet}, 1);
  return {
      published_row(
          in, "paper-fig5-longer", draining > reference::jeffery_period(measured, 1) ? 1 : 0, 0,
          fmt::format(
              "rate T = {:.2f} free draining, {:.2f} with the spheres' interactions, {:.2f} with their "
              "stresslets (rigid chain). That is {:.1f}, {:.1f} and {:.1f} % over Cox's slender body and "
              "{:.1f}, {:.1f} and {:.1f} % over Goldsmith and Mason's fit to measured periods, which "
              "stands in for Anczurowski and Mason's points: those are not in the text. What remains "
              "with interactions is of the size of what is left out of them, higher moments of the "
              "forces (stresslets alone change the period by {:.1f} %), and of shape: Cox's and the "
              "measured rods are cylinders with blunt ends, a chain of spheres is none",
              draining, interacting, resolved, over(draining, cox), over(interacting, cox),
              over(resolved, cox), over(draining, measured), over(interacting, measured),
              over(resolved, measured), 100 * (resolved / interacting - 1))),
      disputed_row(
          in, "paper-fig5-drag", 50 / resistance.across,
          fmt::format(
              "free draining overestimates drag: {:.2f} times that with interactions across the fiber, "
              "{:.2f} times along it; the torque of turning it is {:.2f} times too large. A fiber free "
              "of torque does not turn more slowly for that: all torques scale alike. The period is set "
              "by the torque of a fiber that lies along the flow over that of one across it; free "
              "draining leaves the first to the spheres' own spin alone, so that r_e/r tends to "
              "1/sqrt(2), where it falls as 1.24/sqrt(ln r) by slender-body theory",
              50 / resistance.across, 50 / resistance.along, 50 * (50.0 * 50 + 3) / 4 / resistance.turning))};
}

Rows orbit_rows(const ValidationInput& in) {
  const OrbitOptions options{.jobs = in.jobs};
  const FlowStudy periods = period_study(
      {.spheres = {2, 3, 4, 7, 11, 20, 50, 101}, .interacting = {2, 5, 11, 20, 50}, .stresslets = {2, 5, 11}},
      options);
  double fifty[2] = {};
  for (std::size_t i = 0; i < periods.table.rows().size(); ++i) {
    if (periods.table.number(i, "spheres") != 50) continue;
    fifty[periods.table.text(i, "hydrodynamics") == "interactions"] = periods.table.number(i, "period");
  }
  const std::vector<JefferyRun> runs = jeffery_runs(11, 1, kOrbitConstants, options);
  const double distance = std::ranges::max(runs, {}, &JefferyRun::distance).distance;
  const JefferyRun hundred = jeffery_runs(7, 100, {0.5}, options).front();
  const double order = stiffness_points(5, {3e-4, 1e-3}, options).back().order;
  Rows rows = figure_rows(in, fifty[0], fifty[1]);
  const std::string exact =
      "rigid chain, free draining: Lambda = (N^2 - 1)/(N^2 + 3), Jeffery 1922, Bretherton 1962";
  const std::string other = "rigid chain by scalar functions along the line of centers, one dense solve";
  rows.push_back(
      exact_row("jeffery-period", kOrbits, 0, worst(periods.table, "free_draining"), 1e-4, exact,
                "largest relative error of the period of chains of 2, 3, 4, 7, 11, 20, 50 and 101 spheres"));
  rows.push_back(exact_row(
      "jeffery-orbit", kOrbits, 0, distance, 1e-4, exact + ", closed form",
      "largest distance of the axis (unit vector) over an orbit, 11 spheres, C/(1 + C) = 0.2, 0.5, 0.8, 1"));
  rows.push_back(exact_row("jeffery-drift", kOrbits, 0, hundred.drift, 1e-3, exact,
                           "largest relative change of C over 100 orbits, 7 spheres, C = 1"));
  rows.push_back(exact_row("jeffery-stiffness", kOrbits, 2, order, 0.1,
                           "the flow turns and stretches alike: no term of first order",
                           "order in mu rate/E of the period's correction, 5 spheres, from 3e-4 to 1e-3"));
  rows.push_back(method_row(
      "interactions-period", kOrbits, 0, worst(periods.table, "interactions"), 1e-4, other,
      "largest relative difference of the period, 2, 5, 11, 20 and 50 spheres, Rotne-Prager-Yamakawa"));
  rows.push_back(
      method_row("stresslets-period", kOrbits, 0, worst(periods.table, "stresslets"), 1e-4, other,
                 "largest relative difference of the period, 2, 5 and 11 spheres, with stresslets"));
  return rows;
}

Rows buckling_rows(const ValidationInput&) {
  Rows rows;
  const std::string source = "eigenvalues of the chain's own linearization about its compressed state";
  for (const int N : {10, 20, 40}) {
    const double expected = reference::chain_buckling_threshold({N, 0.3}, 1);
    const Threshold found = buckling_threshold_of(N, 0.97 * expected, 1.03 * expected, 0.1);
    rows.push_back(method_row(
        fmt::format("buckling-threshold-{}", N), kBuckling, expected, found.middle(), 0.005 * expected,
        source,
        fmt::format("planar extension that compresses {} spheres: a small even bend decays at {:.2f} and "
                    "grows at {:.2f}; thin inextensible filament {:.3f}",
                    N, found.below, found.above, reference::buckling_threshold(1))));
    const double growth = reference::chain_growth_mode({N, 0.3}, 200, 1).growth;
    rows.push_back(method_row(
        fmt::format("buckling-growth-{}", N), kBuckling, growth,
        run_buckling({.spheres = N, .number = 200}).growth, 0.01 * growth, source,
        fmt::format("growth over the rate of compression at 3 pi mu rate L^4/(E I) = 200, {} spheres; "
                    "filament {:.4f}",
                    N, reference::growth_rates(200, 1)[0])));
  }
  const double in_shear = 2 * reference::chain_buckling_threshold({20, 0.3}, 1);
  rows.push_back(method_row("buckling-shear-20", kBuckling, in_shear,
                            passage_threshold(20, 0.97 * in_shear, 1.03 * in_shear, 0.2), 0.005 * in_shear, source,
                            fmt::format("20 spheres that pass 45 degrees in simple shear: shear rate at which a small even "
                                        "bend neither decays nor grows there, twice the rate in extension; thin "
                                        "inextensible filament {:.3f}",
                                        2 * reference::buckling_threshold(1))));
  return rows;
}

/// Largest relative departure of a sphere's velocity from F/(6 pi mu R N), a force F at the middle sphere of
/// 11, across and along.
double worst_drag() {
  const dem::Fiber fiber = fiber_of_spheres(11);
  const double viscosity = 3, speed = 1e-6;
  const double drag = 6 * std::numbers::pi * viscosity * dem::sphere_radius(fiber) * 11;
  double largest = 0;
  for (const bool along : {false, true}) {
    const dem::Load<2> load{5, {along ? drag * speed : 0, along ? 0 : drag * speed}, {0}};
    const dem::Chain<2> chain = dem::straight_chain<2>(fiber);
    dem::follow<2>({chain, chain.poses, {viscosity, {}}, {{}, {load}}}, {10}, {.tolerance = 1e-11},
                   [&](double, const dem::ChainState<2>& state) {
                     for (const auto& v : state.velocity) {
                       largest = std::max(largest,
                                          std::hypot(v[along ? 0 : 1] / speed - 1, v[along ? 1 : 0] / speed));
                     }
                   });
  }
  return largest;
}

Rows motion_rows(const ValidationInput&) {
  const InertiaCase coarse{.stokes = 0.03, .method = dem::FlowMethod::leapfrog},
      fine{.stokes = 0.01, .method = dem::FlowMethod::leapfrog},
      implicit{.stokes = 0.01, .method = dem::FlowMethod::cvode, .tolerance = 1e-6};
  const double near = inertia_distance(fine);
  const double order = std::log(inertia_distance(coarse) / near) / std::log(coarse.stokes / fine.stokes);
  return {
      exact_row("drag-translation", "drag", 0, worst_drag(), 1e-4, "free draining: 6 pi mu R on every sphere",
                "largest relative departure of a sphere's velocity from F/(6 pi mu R N), 11 spheres pulled "
                "at the middle, "
                "across and along"),
      exact_row(
          "inertia-order", "inertia", 1, order, 0.1, "m dV/dt over 6 pi mu R V is the Stokes number",
          fmt::format(
              "order in the Stokes number at which the leapfrog's places come to those without inertia, 21 "
              "spheres in shear, 0.03 to 0.01, where they are {:.1e} L apart",
              near)),
      method_row(
          "inertia-methods", "inertia", 1, inertia_distance(implicit) / near, 0.01,
          "leapfrog, drag in the step",
          "distance from the places without inertia by CVODE over that by the leapfrog, Stokes number 0.01")};
}

}  // namespace

std::vector<MatrixRow> flow_rows(const ValidationInput& in) {
  Rows rows = orbit_rows(in);
  std::ranges::move(buckling_rows(in), std::back_inserter(rows));
  std::ranges::move(motion_rows(in), std::back_inserter(rows));
  return rows;
}

}  // namespace fiberchain::compare
