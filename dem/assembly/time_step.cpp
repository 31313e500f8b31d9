#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/assembly/packing_law.hpp"
#include "dem/contact/contact_rates.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

/// Part of what stability allows that the bonds use up at a step: dt^2 K / 4 + dt C / 2 of their worst wave,
/// whose limits without and with dashpots are known.
double used_by_bonds(double undamped, double damped, double dt) {
  const double stiff = dt / undamped;
  return stiff * stiff + dt * (1 / damped - damped / (undamped * undamped));
}

/// Where a rising function that is 0 at 0 reaches 1; not above `high`.
template <class Used>
double step_that_uses_all(const Used& used, double high) {
  double low = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (used(middle) < 1 ? low : high) = middle;
  }
  return low;
}

/// The stiffest and the most damped contacts that spheres of a group take part in.
ContactRates worst_contacts(const FiberGroup& group, const std::vector<FiberGroup>& groups,
                            const Domain& domain) {
  constexpr double pressed = 0.1;  // overlap over the radius that contacts are expected to stay below
  constexpr int neighbors = 6;     // of a sphere, so pressed
  const ContactBody body = sphere_body(group.chain.fiber);
  ContactRates worst{};
  const auto meet = [&](const ContactBody& other) {
    const double overlap = pressed * std::min(body.radius, other.radius);
    const ContactRates rates = contact_rates(body, other, domain.contacts, overlap, neighbors);
    worst = {std::max(worst.stiffness, rates.stiffness), std::max(worst.dashpots, rates.dashpots)};
  };
  for (const FiberGroup& other : groups) meet(sphere_body(other.chain.fiber));
  if (!domain.walls.empty()) meet(wall_body(domain));
  return worst;
}

}  // namespace

// Stability needs 4 M - dt^2 K - 2 dt C positive definite, C twice for normal contact
// (contact_rates.hpp). K and C are sums over bonds and contacts: what each uses up alone, in its own
// worst mode, adds up to no less than what both do.
StepChoice assembly_time_step(const std::vector<FiberGroup>& groups, const Domain& domain,
                              const AssemblyOptions& options) {
  constexpr double none = std::numeric_limits<double>::infinity();
  StepChoice choice{.step = none, .set_by = "", .bonds = none, .damped_bonds = none, .contacts = none};
  for (const FiberGroup& group : groups) {
    // springs k times stiffer than the parameters say: with dt / sqrt(k) neither dt^2 K nor dt C is larger
    // than allowed
    const double stiffer = std::sqrt(packing_law(options).largest_stiffness(group.chain.fiber));
    const double undamped = undamped_time_step(group.chain.fiber) / stiffer,
                 damped = stable_time_step(group.chain.fiber) / stiffer;
    const ContactRates contacts = worst_contacts(group, groups, domain);
    choice.bonds = std::min(choice.bonds, undamped);
    choice.damped_bonds = std::min(choice.damped_bonds, damped);
    choice.contacts = std::min(
        choice.contacts,
        step_that_uses_all([&](double dt) { return contacts.used(dt); }, 4 / std::sqrt(contacts.stiffness)));
    const auto used = [&](double dt) { return used_by_bonds(undamped, damped, dt) + contacts.used(dt); };
    choice.step = std::min(choice.step, chosen_part * step_that_uses_all(used, damped));
  }
  const double least = std::min({choice.bonds, choice.damped_bonds, choice.contacts});
  choice.set_by = least == choice.contacts ? "contacts" : least == choice.bonds ? "bonds" : "bond damping";
  return choice;
}

}  // namespace fiberchain::dem
