#include <algorithm>

#include "dem/assembly/assembly.hpp"
#include "dem/assembly/contact_parameters.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {

StepChoice assembly_time_step(const std::vector<FiberGroup>& groups, const Surroundings& surroundings) {
  constexpr double part = 0.8;     // of the largest stable step
  constexpr double pressed = 0.1;  // overlap over the radius that contacts are expected to stay below
  constexpr int neighbors = 6;     // of a sphere, at most
  StepChoice choice{0, "", 1e300, 1e300, 1e300};
  for (const FiberGroup& group : groups) {
    const Fiber& fiber = group.chain.fiber;
    choice.bonds = std::min(choice.bonds, undamped_time_step(fiber));
    choice.damped_bonds = std::min(choice.damped_bonds, stable_time_step(fiber));
    const ContactBody body = sphere_body(fiber);
    for (const FiberGroup& other : groups) {
      choice.contacts = std::min(choice.contacts, contact_step_limit(body, sphere_body(other.chain.fiber),
                                                                     surroundings.contacts, pressed * body.radius, neighbors));
    }
    choice.contacts = std::min(choice.contacts, contact_step_limit(body, wall_body(surroundings), surroundings.contacts,
                                                                   pressed * body.radius, neighbors));
  }
  const double least = std::min({choice.bonds, choice.damped_bonds, choice.contacts});
  choice.step = part * least;
  choice.set_by = least == choice.contacts ? "contacts" : least == choice.bonds ? "bonds" : "bond damping";
  return choice;
}

}  // namespace fiberchain::dem
