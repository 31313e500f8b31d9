#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/assembly/packing_law.hpp"
#include "dem/contact/contact_rates.hpp"
#include "dem/contact/impact.hpp"
#include "dem/contact/restitution_error.hpp"
#include "dem/motion/stiff_limits.hpp"
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
  const ContactBody body = sphere_body(group.chain, domain);
  ContactRates worst{};
  // the law knows spheres between the ends; what it gives acts on end spheres, too
  const auto meet = [&](const ContactBody& other, double lightest) {
    const double overlap = pressed * std::min(body.radius, other.radius);
    const ContactPair pair = contact_pair(domain, body, other);
    const ContactRates rates = contact_rates(pair.first, pair.second, pair.properties, overlap, neighbors);
    worst = {std::max(worst.stiffness, rates.stiffness / lightest),
             std::max(worst.dashpots, rates.dashpots / lightest)};
  };
  const double own = std::min(end_mass_share(group.chain.fiber), 1.0);
  for (const FiberGroup& other : groups)
    meet(sphere_body(other.chain, domain), std::min(own, end_mass_share(other.chain.fiber)));
  for (const ContactBody& wall : wall_bodies(domain)) meet(wall, own);
  return worst;
}

/// Of fibers now, of walls and grips, and what is expected beside [m/s].
double largest_speed(const std::vector<FiberGroup>& groups, const Domain& domain,
                     const AssemblyOptions& options) {
  double fastest = options.speed, wall = 0;
  for (const FiberGroup& group : groups) {
    for (const ChainState<3>& state : group.fibers) {
      for (const auto& v : state.velocity) fastest = std::max(fastest, norm(v));
    }
  }
  for (const Wall& each : domain.walls) {
    double reach = 0;
    for (const FiberGroup& group : groups) {
      for (const ChainState<3>& state : group.fibers) {
        for (const auto& pose : state.poses) reach = std::max(reach, distance_from_axis(each, pose.position));
      }
    }
    wall = std::max(wall, largest_speed(each, reach));
  }
  for (const Grip& grip : options.grips) {
    for (const SphereAddress& at : grip.spheres) {
      if (at.group >= std::ssize(groups) || at.fiber >= std::ssize(groups[at.group].fibers)) continue;
      const auto& poses = groups[at.group].fibers[at.fiber].poses;
      if (at.sphere >= std::ssize(poses)) continue;
      const double reach = distance_from_axis(grip.body, poses[at.sphere].position);
      wall = std::max(wall, largest_speed(grip.body, reach));
    }
  }
  return fastest + wall;
}

/// Every pair of kinds of bodies that may meet.
std::vector<ContactPair> pairs_of_bodies(const std::vector<FiberGroup>& groups, const Domain& domain) {
  std::vector<ContactBody> bodies;
  for (const FiberGroup& group : groups) {
    const ContactBody body = sphere_body(group.chain, domain);
    if (std::ranges::find(bodies, body) == bodies.end()) bodies.push_back(body);
  }
  return contact_pairs(domain, bodies);
}

/// Largest step up to `high` that keeps the coefficient of restitution of every pair of bodies.
double restitution_step(const std::vector<FiberGroup>& groups, const Domain& domain, double speed,
                        double allowed, double high) {
  for (const ContactPair& pair : pairs_of_bodies(groups, domain))
    high = step_for_restitution(pair.first, pair.second, pair.properties, speed, allowed, high);
  return high;
}

/// Shortest impact of two bodies at `speed` [s].
double shortest_impact(const std::vector<FiberGroup>& groups, const Domain& domain, double speed) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const ContactPair& pair : pairs_of_bodies(groups, domain))
    shortest = std::min(shortest, elastic_impact(pair.first, pair.second, pair.properties, speed).time);
  return shortest;
}

void take(StepChoice& choice, double step, std::string_view set_by) {
  if (step < choice.step) choice.step = step, choice.set_by = set_by;
}

/// Where bonds are solved for, speeds want that impacts are resolved and that bonds turn little: a bond's
/// spheres part at up to twice the speed.
void count_stiff_speeds(StepChoice& choice, const std::vector<FiberGroup>& groups, const Domain& domain) {
  choice.impact = impact_part * shortest_impact(groups, domain, choice.speed);
  choice.turning = std::numeric_limits<double>::infinity();
  for (const FiberGroup& group : groups)
    choice.turning =
        std::min(choice.turning, safe_turn * bond_length(group.chain.fiber) / (2 * choice.speed));
  take(choice, choice.impact, "impacts");
  take(choice, choice.turning, "turning");
}

/// The step that is chosen goes no further than the speeds there are and the collisions at them allow.
void count_speeds(StepChoice& choice, const std::vector<FiberGroup>& groups, const Domain& domain,
                  const AssemblyOptions& options) {
  choice.speed = largest_speed(groups, domain, options);
  if (!(choice.speed > 0)) return;
  double radius = sphere_radius(groups.front().chain.fiber);
  for (const FiberGroup& group : groups) radius = std::min(radius, sphere_radius(group.chain.fiber));
  choice.path = chosen_path * radius / choice.speed;
  const double stable = choice.step;
  choice.restitution = restitution_step(groups, domain, choice.speed, options.restitution_error, choice.step);
  choice.step = std::min({stable, choice.path, choice.restitution});
  if (choice.step < stable) choice.set_by = choice.step == choice.path ? "speed" : "restitution";
  if (options.integrator == Integrator::leapfrog_stiff) count_stiff_speeds(choice, groups, domain);
  choice.restitution_error = restitution_error(groups, domain, choice.speed, choice.step);
}

}  // namespace

double restitution_error(const std::vector<FiberGroup>& groups, const Domain& domain, double speed,
                         double step) {
  double worst = 0;
  if (!(speed > 0)) return worst;
  for (const ContactPair& pair : pairs_of_bodies(groups, domain)) {
    const double here = restitution_error(pair.first, pair.second, pair.properties, speed, step);
    if (!(here <= worst)) worst = here;
  }
  return worst;
}

// Stability needs 4 M - dt^2 K - 2 dt C positive definite, C twice for normal contact
// (contact_rates.hpp). K and C are sums over bonds and contacts: what each uses up alone, in its own
// worst mode, adds up to no less than what both do.
StepChoice stable_time_step(const std::vector<FiberGroup>& groups, const Domain& domain,
                            const AssemblyOptions& options) {
  constexpr double none = std::numeric_limits<double>::infinity();
  StepChoice choice{.step = none,
                    .set_by = "",
                    .bonds = none,
                    .damped_bonds = none,
                    .contacts = none,
                    .restitution = none,
                    .path = none,
                    .speed = 0,
                    .bending = none,
                    .impact = none,
                    .turning = none};
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
    if (options.integrator == Integrator::leapfrog_stiff) {
      // what is solved for makes contacts no less stable: spheres that bonds hold are no lighter
      choice.bonds = choice.damped_bonds = none;
      choice.bending = std::min(choice.bending, bending_part * free_bending_period(group.chain.fiber));
      choice.step = std::min({choice.step, chosen_part * choice.contacts, choice.bending});
      choice.set_by = choice.step == choice.bending ? "bending" : "contacts";
      continue;
    }
    const auto used = [&](double dt) { return used_by_bonds(undamped, damped, dt) + contacts.used(dt); };
    choice.step = std::min(choice.step, chosen_part * step_that_uses_all(used, damped));
  }
  if (options.integrator == Integrator::leapfrog_stiff) return choice;
  const double least = std::min({choice.bonds, choice.damped_bonds, choice.contacts});
  choice.set_by = least == choice.contacts ? "contacts" : least == choice.bonds ? "bonds" : "bond damping";
  return choice;
}

double largest_bond_step(const StepChoice& choice) { return std::min(choice.bonds, choice.damped_bonds); }

StepChoice assembly_time_step(const std::vector<FiberGroup>& groups, const Domain& domain,
                              const AssemblyOptions& options) {
  StepChoice choice = stable_time_step(groups, domain, options);
  count_speeds(choice, groups, domain, options);
  return choice;
}

}  // namespace fiberchain::dem
