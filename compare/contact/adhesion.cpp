#include "compare/contact/adhesion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/contact/sphere_scene.hpp"
#include "dem/contact/contact_law.hpp"
#include "reference/adhesion.hpp"

namespace fiberchain::compare {
namespace {

ImpactCase impact_of(const AdhesionCase& a) {
  const double share = 0.37;  // of the speed that the first has
  return {1,
          a.law,
          a.first,
          a.second,
          a.restitution,
          0.3,
          {{share * a.speed, 0}, 0},
          {{(share - 1) * a.speed, 0}, 0}};
}

SphereScene scene_of(const AdhesionCase& a, double bonds, double lead) {
  SphereScene scene = sphere_scene(impact_of(a), bonds, lead);
  scene.domain.contacts.law = &dem::contact_law(a.law);
  scene.domain.contacts.work_of_adhesion = a.work_of_adhesion;
  return scene;
}

/// Force of the law where both dashpots are out, positive where pressed.
double law_force(const AdhesionCase& a, const reference::HertzPair& pair, double overlap) {
  if (a.law == "jkr") return reference::jkr_force(pair, a.work_of_adhesion, overlap);
  return reference::hertz_stiffness(pair) * std::pow(std::max(overlap, 0.0), 1.5) -
         reference::dmt_pull_off(pair, a.work_of_adhesion);
}

}  // namespace

AdhesionCase adhesion_case(const std::string& law, double speed_over_sticking) {
  AdhesionCase adhesion{law, 0.053, {0.51e-3, 1.3e7, 0.31, 1130}, {0.51e-3, 0.9e7, 0.42, 2310}, 1};
  adhesion.speed =
      speed_over_sticking * reference::jkr_sticking_speed(hertz_pair_of(adhesion), adhesion.work_of_adhesion);
  return adhesion;
}

reference::HertzPair hertz_pair_of(const AdhesionCase& adhesion) {
  return reference::hertz_pair(elastic_body(adhesion.first), elastic_body(adhesion.second));
}

double default_step(const AdhesionCase& adhesion) {
  const SphereScene scene = scene_of(adhesion, 1, 0);
  return dem::assembly_time_step(scene.groups, scene.domain, {}).step;
}

AdhesionOutcome marched_adhesion(const AdhesionCase& adhesion, double step, double phase) {
  const reference::HertzPair pair = hertz_pair_of(adhesion);
  const double reach =
      adhesion.law == "jkr"
          ? std::pow(reference::jkr_radius_at_end(pair, adhesion.work_of_adhesion), 2) * 3 / pair.radius
          : 0;
  const double lead = phase * step + 1.5 * reach / adhesion.speed;
  // long enough for bodies that hold each other to swing thrice
  const double longest = 10 * reference::hertz_collision(pair, adhesion.speed).time + 2 * lead;
  const SphereScene scene = scene_of(adhesion, no_bonds, lead);
  dem::Assembly assembly(scene.groups, scene.domain, {.step = step, .account_energy = true});
  const double before = total(assembly.energy()), kinetic = assembly.energy().kinetic;
  const double most = adhesion.law == "jkr" ? reference::jkr_pull_off(pair, adhesion.work_of_adhesion)
                                            : reference::dmt_pull_off(pair, adhesion.work_of_adhesion);
  AdhesionOutcome outcome;
  std::vector<double> pulls;
  bool held = false;
  for (double t = 0; t < longest && !outcome.parted; t += step) {
    assembly.march(1);
    const auto contact = contact_of(assembly);
    const bool holds = contact && contact->overlap != 0;
    outcome.parted = held && !contact;
    held = held || holds;
    if (!holds) continue;
    const double force = -along(contact->force);
    if (pulls.empty()) outcome.first_force = force;
    pulls.push_back(-force);
    outcome.last_overlap = contact->overlap;
    if (adhesion.restitution == 1)
      outcome.work_off =
          std::max(outcome.work_off, std::abs(force - law_force(adhesion, pair, contact->overlap)) / most);
  }
  outcome.pull = peak_of(pulls);
  if (outcome.parted)
    outcome.restitution =
        (motion_of(assembly, 1).velocity[0] - motion_of(assembly, 0).velocity[0]) / adhesion.speed;
  // both spheres of a fiber meet their like
  outcome.taken = assembly.energy().contact_normal / 2;
  outcome.energy_change = (total(assembly.energy()) - before) / kinetic;
  return outcome;
}

}  // namespace fiberchain::compare
