#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flow/buckling.hpp"
#include "compare/flow/inertia.hpp"
#include "compare/flow/setup.hpp"
#include "compare/flow/shear_passage.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/validation.hpp"
#include "reference/compressed_chain.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/filament_buckling.hpp"
#include "reference/jeffery.hpp"
#include "reference/rigid_chain_mobility.hpp"

namespace fiberchain::compare {
namespace {

using dem::Hydrodynamics;
using Found = std::vector<Measured>;

double worst(const dem::Table& periods, std::string_view hydrodynamics) {
  double largest = 0;
  for (std::size_t i = 0; i < periods.rows().size(); ++i) {
    if (periods.text(i, "hydrodynamics") != hydrodynamics) continue;
    const double error = std::abs(periods.number(i, "period_error"));
    largest = error <= largest ? largest : error;  // a NaN stays
  }
  return largest;
}

/// What the paper says of Fig 5 at r = N = 50, from the periods there, free draining and with interactions,
/// and from the free-draining one at 11.
Found figure_5(double draining, double interacting, double eleven) {
  const auto over = [](double period, double r_e) {
    return 100 * (period / reference::jeffery_period(r_e, 1) - 1);
  };
  const double cox = reference::cox_aspect_ratio(50), measured = reference::goldsmith_mason_aspect_ratio(50);
  using enum reference::ChainCoupling;
  const auto resistance = reference::rigid_chain_resistance({50, force_torque});
  const double resolved = reference::rigid_chain_period({50, force_torque_stresslet}, 1);
  const double to_measured = reference::jeffery_period(measured, 1);
  const double to_measured_11 = reference::jeffery_period(reference::goldsmith_mason_aspect_ratio(11), 1);
  return {{draining / to_measured,
           {draining, interacting, resolved, over(draining, cox), over(interacting, cox), over(resolved, cox),
            over(draining, measured), over(interacting, measured), over(resolved, measured),
            100 * (resolved / interacting - 1)}},
          {100 * (draining / to_measured - eleven / to_measured_11), {100 * (eleven / to_measured_11 - 1)}},
          {50 / resistance.across, {50 / resistance.along}},
          {50 * (50.0 * 50 + 3) / 4 / resistance.turning}};
}

Found periods(const ValidationInput& in) {
  const FlowStudy study = period_study(
      {.spheres = {2, 3, 4, 7, 11, 20, 50, 101}, .interacting = {2, 5, 11, 20, 50}, .stresslets = {2, 5, 11}},
      {.jobs = in.jobs});
  const auto period = [&](double spheres, std::string_view hydrodynamics) {
    for (std::size_t i = 0; i < study.table.rows().size(); ++i) {
      if (study.table.number(i, "spheres") == spheres &&
          study.table.text(i, "hydrodynamics") == hydrodynamics)
        return study.table.number(i, "period");
    }
    throw InputError(fmt::format("no period of {} spheres, {}", spheres, hydrodynamics));
  };
  Found found =
      figure_5(period(50, "free_draining"), period(50, "interactions"), period(11, "free_draining"));
  for (const char* kind : {"free_draining", "interactions", "stresslets"})
    found.push_back({worst(study.table, kind)});
  return found;
}

Found orbits(const ValidationInput& in) {
  const OrbitOptions options{.jobs = in.jobs};
  const std::vector<JefferyRun> runs = jeffery_runs(11, 1, kOrbitConstants, options);
  return {{std::ranges::max(runs, {}, &JefferyRun::distance).distance},
          {jeffery_runs(7, 100, {0.5}, options).front().drift},
          {stiffness_points(5, {3e-4, 1e-3}, options).back().order}};
}

/// Threshold of buckling in extension and growth above it, against the chain's own linearization.
Found buckling(const ValidationInput&) {
  Found found;
  for (const int N : {10, 20, 40}) {
    const double expected = reference::chain_buckling_threshold({N, 0.3}, 1);
    const Threshold threshold = buckling_threshold_of(N, 0.97 * expected, 1.03 * expected, 0.1);
    found.push_back(
        {threshold.middle(), {threshold.below, threshold.above, reference::buckling_threshold(1)}, expected});
    found.push_back({run_buckling({.spheres = N, .number = 200}).growth,
                     {reference::growth_rates(200, 1)[0]},
                     reference::chain_growth_mode({N, 0.3}, 200, 1).growth});
  }
  return found;
}

Found buckling_in_shear(const ValidationInput&) {
  const double in_shear = 2 * reference::chain_buckling_threshold({20, 0.3}, 1);
  return {{passage_threshold(20, 0.97 * in_shear, 1.03 * in_shear, 0.2),
           {2 * reference::buckling_threshold(1)},
           in_shear}};
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
    dem::integrate_in_flow<2>(
        {chain, chain.poses, {viscosity, {}}, {{}, {load}}}, {10}, {.tolerance = 1e-11},
        [&](double, const dem::ChainState<2>& state) {
          for (const auto& v : state.velocity) {
            largest = std::max(largest, std::hypot(v[along ? 0 : 1] / speed - 1, v[along ? 1 : 0] / speed));
          }
        });
  }
  return largest;
}

Found inertia(const ValidationInput&) {
  const InertiaCase coarse{.stokes = 0.03, .method = dem::FlowMethod::leapfrog},
      fine{.stokes = 0.01, .method = dem::FlowMethod::leapfrog},
      implicit{.stokes = 0.01, .method = dem::FlowMethod::cvode, .tolerance = 1e-6};
  const double near = inertia_distance(fine);
  const double order = std::log(inertia_distance(coarse) / near) / std::log(coarse.stokes / fine.stokes);
  return {{order, {near}}, {inertia_distance(implicit) / near}};
}

}  // namespace

const Checks& flow_checks() {
  static const Checks checks{
      {{"paper-fig5-longer", "paper-fig5-large", "paper-fig5-drag", "paper-fig5-torque", "jeffery-period",
        "interactions-period", "stresslets-period"},
       periods},
      {{"jeffery-orbit", "jeffery-drift", "jeffery-stiffness"}, orbits},
      {{"buckling-threshold-10", "buckling-growth-10", "buckling-threshold-20", "buckling-growth-20",
        "buckling-threshold-40", "buckling-growth-40"},
       buckling},
      {{"buckling-shear-20"}, buckling_in_shear},
      {{"drag-translation"}, [](const ValidationInput&) -> Found { return {{worst_drag()}}; }},
      {{"inertia-order", "inertia-methods"}, inertia}};
  return checks;
}

}  // namespace fiberchain::compare
