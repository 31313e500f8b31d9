#include "compare/contact/lone_spheres.hpp"

#include <vector>

#include "compare/contact/sphere_scene.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {

double default_step(const ImpactCase& impact) {
  const SphereScene scene = sphere_scene(impact, 1, 0);
  return dem::assembly_time_step(scene.groups, scene.domain, {}).step;
}

ImpactOutcome marched_impact(const ImpactCase& impact, double step, double phase) {
  constexpr int most_steps = 1000000;
  const double lead = phase * step;
  const SphereScene scene = sphere_scene(impact, no_bonds, lead);
  dem::Assembly assembly(scene.groups, scene.domain, {.step = step});
  std::vector<double> forces, overlaps;
  int n = 0;
  const auto march = [&] {
    assembly.march(1), ++n;
    const auto contact = contact_of(assembly);
    if (contact) forces.push_back(norm(contact->force)), overlaps.push_back(contact->overlap);
    return contact.has_value();
  };
  while (!march() && n < most_steps) {
  }
  while (march() && n < most_steps) {
  }
  if (n >= most_steps) throw InputError("bodies that impact do not part");
  ImpactOutcome outcome{motion_of(assembly, 0), {}, peak_of(forces), peak_of(overlaps)};
  outcome.second = impact.second ? motion_of(assembly, 1) : impact.second_motion;
  const double parting = outcome.second.velocity[0] - outcome.first.velocity[0];
  outcome.time = n * step - gap_of(assembly, impact) / parting - lead;
  outcome.steps = outcome.time / step;
  return outcome;
}

}  // namespace fiberchain::compare
