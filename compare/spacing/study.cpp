#include "compare/spacing/study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/static/case.hpp"
#include "compare/static/tip.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/motion/time_step.hpp"
#include "dem/vibration/first_mode.hpp"
#include "reference/chain_modes.hpp"
#include "reference/damped_beam.hpp"
#include "reference/elastica.hpp"
#include "reference/reissner.hpp"

namespace fiberchain::compare {
namespace {

bool is_whole(int aspect_ratio, double spacing) {
  const double bonds = aspect_ratio / spacing;
  return std::round(bonds) >= 1 && std::abs(bonds / std::round(bonds) - 1) < 1e-5;
}

double beam_frequency(const dem::Fiber& fiber) {
  const double R = dem::sphere_radius(fiber), L = dem::fiber_length(fiber),
               per_length = fiber.material.density * std::numbers::pi * R * R;
  return std::pow(reference::clamped_free_beta(1) / L, 2) *
         std::sqrt(dem::bending_stiffness(fiber) / per_length);
}

double distance(const reference::TipState& one, const reference::TipState& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

/// xi_f / xi_b where it does not depend on xi_b.
double damping_of(dem::Fiber fiber) {
  fiber.bond_damping = 1e-3;
  return reference::first_bending_mode(linear_chain_of(fiber)).damping / fiber.bond_damping;
}

double undamped_step_gain(const dem::Fiber& fiber) {
  dem::Fiber touching = fiber;
  touching.spacing = 1, touching.bond_model = dem::BondModel::paper;
  return dem::undamped_time_step(fiber) / dem::undamped_time_step(touching);
}

SpacingPoint point(const SpacingCase& asked) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  const dem::Fiber fiber = spaced_fiber(asked);
  const double axial =
      dem::axial_stiffness(fiber) * std::pow(dem::fiber_length(fiber), 2) / dem::bending_stiffness(fiber);
  const reference::TipState tip = solve_tip(2, fiber, asked.load).tip;
  const double damping = damping_of(fiber);
  dem::Fiber unit = fiber;
  unit.bond_damping = 1;
  return {.asked = asked,
          .bonds = fiber.aspect_ratio,
          .distance = distance(tip, reference::elastica_shooting(asked.load)),
          .distance_unstretched = distance(tip, reference::reissner_tip(asked.load, axial, rigid)),
          .frequency_error = dem::first_mode(fiber).frequency / beam_frequency(fiber) - 1,
          .damping_ratio = damping,
          .damping_law_error = damping / damping_law(unit) - 1,
          .stable_step = undamped_step_gain(fiber)};
}

double error_of(const SpacingCase& asked, SpacingGoal goal) {
  const dem::Fiber fiber = spaced_fiber(asked);
  if (goal == SpacingGoal::first_mode)
    return std::abs(dem::first_mode(fiber).frequency / beam_frequency(fiber) - 1);
  return distance(solve_tip(2, fiber, asked.load).tip, reference::elastica_shooting(asked.load));
}

}  // namespace

std::vector<SpacingCase> cases(const SpacingSweep& sweep) {
  std::vector<SpacingCase> all;
  for (const auto bond : sweep.bond)
    for (const double nu : sweep.poisson_ratio)
      for (const int aspect_ratio : sweep.aspect_ratio)
        for (const double load : sweep.load)
          for (const double spacing : sweep.spacing)
            if (is_whole(aspect_ratio, spacing)) all.push_back({aspect_ratio, spacing, nu, load, bond});
  if (all.empty()) {
    throw InputError(
        "--spacing is not allowed: no --aspect-ratio is a whole number of bonds of any of these lengths");
  }
  return all;
}

dem::Fiber spaced_fiber(const SpacingCase& asked) {
  if (!is_whole(asked.aspect_ratio, asked.spacing)) {
    throw InputError(fmt::format("spacing = {:g} is not allowed: aspect ratio {} is no whole number of bonds",
                                 asked.spacing, asked.aspect_ratio));
  }
  const int bonds = static_cast<int>(std::round(asked.aspect_ratio / asked.spacing));
  dem::Fiber fiber = nominal_fiber(bonds, asked.poisson_ratio, asked.bond);
  fiber.spacing = static_cast<double>(asked.aspect_ratio) / bonds;
  fiber.mass = dem::MassModel::cylinder;
  return fiber;
}

double damping_law(const dem::Fiber& fiber) {
  const double beta = reference::clamped_free_beta(1), r_f = dem::slenderness(fiber);
  const double s = fiber.spacing * fiber.bond_damping;
  if (fiber.mass == dem::MassModel::cylinder) return beta * beta / 4 * s / (r_f * r_f);
  return beta * beta / std::sqrt(20.0) * s / ((r_f + 0.5) * (r_f + 0.5));
}

std::vector<SpacingPoint> spacing_points(const std::vector<SpacingCase>& cases,
                                         const SpacingOptions& options) {
  for (const SpacingCase& asked : cases) dem::check(spaced_fiber(asked));
  std::vector<SpacingPoint> points;
  for (const SpacingCase& asked : cases)
    points.push_back({asked, 0, nan, nan, nan, nan, nan, nan, std::string(not_begun)});
  options.jobs.run(cases.size(), [&](std::size_t i) {
    if (options.stopped()) return;
    points[i] = point(cases[i]);
    options.advance();
  });
  return points;
}

FewestBonds fewest_bonds(int aspect_ratio, double poisson_ratio, SpacingGoal goal, double load,
                         double wanted) {
  SpacingCase asked{aspect_ratio, 1, poisson_ratio, load, dem::BondModel::paper};
  FewestBonds found{.aspect_ratio = aspect_ratio,
                    .goal = goal,
                    .load = load,
                    .touching = error_of(asked, goal),
                    .wanted = wanted,
                    .bonds = 0,
                    .error = nan,
                    .times_fewer = nan,
                    .longest_step = nan};
  if (wanted == 0) found.wanted = found.touching;
  asked.bond = dem::BondModel::corrected;
  for (int bonds = 2; bonds <= 2 * aspect_ratio; ++bonds) {
    asked.spacing = static_cast<double>(aspect_ratio) / bonds;
    const double error = error_of(asked, goal);
    if (error > found.wanted) continue;
    found.bonds = bonds, found.error = error, found.times_fewer = asked.spacing;
    found.longest_step = undamped_step_gain(spaced_fiber(asked));
    break;
  }
  return found;
}

}  // namespace fiberchain::compare
