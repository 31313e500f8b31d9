#include <algorithm>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/spacing/study.hpp"
#include "compare/stability/run.hpp"
#include "compare/static/case.hpp"
#include "compare/study/validation.hpp"
#include "dem/motion/time_step.hpp"
#include "dem/vibration/first_mode.hpp"
#include "reference/chain_modes.hpp"

namespace fiberchain::compare {
namespace {

using dem::BondModel;

constexpr double kSpacings[] = {0.5, 1.7, 2.6};

/// 13 bonds of an odd material.
dem::Fiber odd_fiber(double spacing, BondModel bond, dem::MassModel mass, double bond_damping) {
  dem::Fiber fiber = nominal_fiber(13, 0.17, bond);
  fiber.spacing = spacing, fiber.mass = mass, fiber.bond_damping = bond_damping;
  return fiber;
}

/// Observed order in the number of bonds, of 20 and 40 at load 6: the farthest from `expected`.
double farthest_order(BondModel bond, double expected, double SpacingPoint::*distance) {
  double worst = expected;
  for (const double s : kSpacings) {
    const auto of_bonds = [&](int bonds) -> SpacingCase {
      return {static_cast<int>(std::lround(bonds * s)), s, 0.17, 6, bond};
    };
    const auto points = spacing_points({of_bonds(20), of_bonds(40)});
    const double order = std::log2(points[0].*distance / (points[1].*distance));
    if (std::abs(order - expected) > std::abs(worst - expected)) worst = order;
  }
  return worst;
}

/// The engine's first mode against the linear chain's, the largest relative difference of frequency and
/// damping.
double mode_difference() {
  double worst = 0;
  for (const double s : kSpacings) {
    for (const auto bond : {BondModel::paper, BondModel::corrected}) {
      for (const auto mass : {dem::MassModel::spheres, dem::MassModel::cylinder}) {
        const dem::Fiber fiber = odd_fiber(s, bond, mass, 0.01);
        const dem::FirstMode own = dem::first_mode(fiber);
        const auto mode = reference::first_bending_mode(linear_chain_of(fiber));
        worst = std::max(
            {worst, std::abs(own.frequency / mode.frequency - 1), std::abs(own.damping / mode.damping - 1)});
      }
    }
  }
  return worst;
}

/// xi_f over its law, the farthest from 1.
double damping_against_law() {
  double worst = 1;
  for (const double s : kSpacings) {
    for (const auto mass : {dem::MassModel::spheres, dem::MassModel::cylinder}) {
      dem::Fiber fiber = odd_fiber(s, BondModel::paper, mass, 0.01);
      fiber.aspect_ratio = static_cast<int>(std::lround(65 / s));
      const double found = reference::first_bending_mode(linear_chain_of(fiber)).damping / damping_law(fiber);
      if (std::abs(found - 1) > std::abs(worst - 1)) worst = found;
    }
  }
  return worst;
}

/// Largest stable step by runs over that by the finite chain's modes, the farthest from 1.
std::vector<Measured> stable_step(const ValidationInput& in) {
  std::vector<dem::Fiber> fibers;
  for (const double s : kSpacings)
    for (const auto bond : {BondModel::paper, BondModel::corrected})
      for (const double xi_b : {0.0, 0.3})
        fibers.push_back(odd_fiber(s, bond, dem::MassModel::spheres, xi_b));
  std::vector<double> ratios(fibers.size()), said(fibers.size());
  in.jobs.run(fibers.size(), [&](std::size_t i) {
    const auto limit = measured_limit({.fiber = fibers[i]});
    const double modes = reference::finite_stable_step(linear_chain_of(fibers[i]), reference::lagged_dashpots,
                                                       reference::ChainEnds::clamped_free, true);
    ratios[i] = (limit.stable + limit.unstable) / 2 / modes;
    said[i] = dem::stable_time_step(fibers[i]) / modes;
  });
  double worst = 1;
  for (const double ratio : ratios)
    if (std::abs(ratio - 1) > std::abs(worst - 1)) worst = ratio;
  const auto [least, most] = std::ranges::minmax(said);
  return {{worst, {static_cast<int>(fibers.size()), least, most}}};
}

/// Bonds that a fiber of 120 diameters needs fewer.
std::vector<Measured> fewer_bonds(const ValidationInput& in) {
  std::vector<FewestBonds> found(3);
  in.jobs.run(found.size(), [&](std::size_t i) {
    found[i] = i < 2 ? fewest_bonds(120, 0.3, SpacingGoal::statics, i == 0 ? 1 : 6, 0)
                     : fewest_bonds(120, 0.3, SpacingGoal::first_mode, 0, 0);
  });
  return {{found[0].times_fewer, {found[0].bonds, found[0].wanted, found[1].times_fewer, found[1].wanted}},
          {found[2].times_fewer, {found[2].bonds, found[2].wanted, found[2].longest_step}}};
}

}  // namespace

const Checks& spacing_checks() {
  using In = ValidationInput;
  using Found = std::vector<Measured>;
  static const Checks checks{
      {{"spacing-order-paper"},
       [](const In&) -> Found { return {{farthest_order(BondModel::paper, 2, &SpacingPoint::distance)}}; }},
      {{"spacing-order-corrected"},
       [](const In&) -> Found {
         return {{farthest_order(BondModel::corrected, 4, &SpacingPoint::distance_unstretched)}};
       }},
      {{"spacing-first-mode"}, [](const In&) -> Found { return {{mode_difference()}}; }},
      {{"spacing-damping-law"}, [](const In&) -> Found { return {{damping_against_law()}}; }},
      {.ids = {"spacing-stable-step"}, .measure = stable_step, .cost = 1},
      {.ids = {"spacing-fewer-bonds", "spacing-fewer-bonds-mode"}, .measure = fewer_bonds}};
  return checks;
}

}  // namespace fiberchain::compare
