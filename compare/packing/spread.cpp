#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compare/packing/study.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

/// What is asked but for the seed.
auto key(const PackingCase& c) {
  return std::tuple(c.fibers, c.side, c.periodic, c.stiffness, c.contact_modulus, c.bond_damping,
                    c.rolling_friction, c.step_ratio, c.integrator, c.loss_factor);
}

bool finished(const PackingRun& run) { return run.status == "finished"; }

/// So many fibers, on a floor that leaves the packing as deep as that of 2000.
std::vector<PackingCase> kinds_of(const PackingPlan& plan, int fibers) {
  PackingCase plain;
  plain.side *= std::sqrt(fibers / static_cast<double>(plain.fibers));
  plain.fibers = fibers, plain.duration = plan.duration, plain.bond_damping = plan.bond_dampings.front();
  std::vector<PackingCase> kinds;
  const auto add = [&](double PackingCase::*what, const std::vector<double>& values) {
    for (const double value : values) {
      kinds.push_back(plain);
      kinds.back().*what = value;
    }
  };
  add(&PackingCase::bond_damping, plan.bond_dampings);
  add(&PackingCase::rolling_friction, plan.rolling_frictions);
  add(&PackingCase::stiffness, plan.stiffnesses);
  return kinds;
}

}  // namespace

std::vector<PackingCase> figure_cases(const PackingPlan& plan) {
  if (plan.fibers == 0) return {};
  std::vector<PackingCase> cases = kinds_of(plan, plan.fibers);
  cases.front().accounted = cases.front().pictured = true;
  return cases;
}

std::vector<PackingCase> spread_cases(const PackingPlan& plan) {
  std::vector<PackingCase> kinds = kinds_of(plan, plan.spread_fibers);
  kinds.push_back(kinds.front());
  kinds.back().step_ratio = 0.5;
  std::vector<PackingCase> cases;
  for (PackingCase c : kinds) {
    c.periodic = true;  // a fiber is nearly as long as the floor is wide
    for (int seed = 1; seed <= plan.seeds; ++seed) {
      c.seed = static_cast<std::uint64_t>(seed);
      cases.push_back(c);
    }
  }
  return cases;
}

std::vector<SeedGroup> seed_groups(const std::vector<PackingRun>& runs) {
  std::vector<SeedGroup> groups;
  for (const PackingRun& run : runs) {
    auto same = std::ranges::find(groups, key(run.asked), [](const SeedGroup& g) { return key(g.asked); });
    if (same == groups.end()) same = groups.insert(same, {run.asked, {}});
    same->runs.push_back(&run);
  }
  return groups;
}

BendingSpread bending_spread(const SeedGroup& group) {
  std::vector<double> peak, trough, plateau;
  for (const PackingRun* run : group.runs) {
    if (!finished(*run)) continue;
    const BendingParts parts = bending_parts(run->history);
    peak.push_back(parts.peak), trough.push_back(parts.trough), plateau.push_back(parts.plateau);
  }
  return {spread_of(peak), spread_of(trough), spread_of(plateau)};
}

Spread paired_difference(const SeedGroup& a, const SeedGroup& b, double BendingParts::*part) {
  std::vector<double> differences;
  for (const PackingRun* first : a.runs) {
    const auto second =
        std::ranges::find(b.runs, first->asked.seed, [](const PackingRun* r) { return r->asked.seed; });
    if (second == b.runs.end() || !finished(*first) || !finished(**second)) continue;
    differences.push_back(bending_parts(first->history).*part - bending_parts((*second)->history).*part);
  }
  return spread_of(differences);
}

double energy_drift(const PackingRun& accounted) {
  if (!accounted.asked.accounted || accounted.history.empty()) throw InputError("energy is not accounted");
  const double start = total(accounted.history.front().energy);
  double largest = 0;
  for (const PackingSample& sample : accounted.history) {
    const double drift = std::abs(total(sample.energy) - start);
    largest = drift <= largest ? largest : drift;  // a NaN stays
  }
  const dem::EnergyBalance& first = accounted.history.front().energy;
  const dem::EnergyBalance& last = accounted.history.back().energy;
  return largest / (first.gravity + first.kinetic - last.gravity);
}

std::string label_of(const PackingCase& asked) {
  std::string label = fmt::format("ξ_b = {:g}", asked.bond_damping);
  if (asked.rolling_friction > 0) label += fmt::format(", ξ_r = {:g}", asked.rolling_friction);
  if (asked.stiffness != 1) label += fmt::format(", {:g} E", asked.stiffness);
  if (asked.contact_modulus != 1) label += fmt::format(", contacts of {:g} of it", asked.contact_modulus);
  if (asked.integrator != dem::Integrator::leapfrog) label += fmt::format(", {}", name(asked.integrator));
  if (asked.step_ratio != 1) label += fmt::format(", {:g} of the step", asked.step_ratio);
  return label;
}

}  // namespace fiberchain::compare
