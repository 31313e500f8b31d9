#include "dem/scene/expected_impact.hpp"

#include <algorithm>
#include <vector>

#include "dem/contact/impact.hpp"

namespace fiberchain::dem {

double expected_impact_overlap(const PackingScene& scene, double speed) {
  double deepest = 0;
  if (!(speed > 0)) return deepest;
  const ContactProperties& contacts = scene.domain.contacts;
  std::vector<ContactBody> bodies;
  for (const PackingFiberKind& kind : scene.kinds) bodies.push_back(sphere_body(kind.fiber, contacts));
  if (!scene.domain.walls.empty()) bodies.push_back(wall_body(scene.domain));
  for (std::size_t a = 0; a < scene.kinds.size(); ++a) {
    for (std::size_t b = a; b < bodies.size(); ++b) {
      const double overlap = elastic_impact(bodies[a], bodies[b], contacts, speed).overlap;
      deepest = std::max(deepest, overlap / std::min(bodies[a].radius, bodies[b].radius));
    }
  }
  return deepest;
}

}  // namespace fiberchain::dem
