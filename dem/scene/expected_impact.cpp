#include "dem/scene/expected_impact.hpp"

#include <algorithm>
#include <vector>

#include "dem/contact/impact.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {

double expected_impact_overlap(const PackingScene& scene, double speed) {
  double deepest = 0;
  if (!(speed > 0)) return deepest;
  std::vector<ContactBody> spheres;
  for (const PackingFiberKind& kind : scene.kinds)
    spheres.push_back(sphere_body(chain_of(kind), scene.domain));
  for (const ContactPair& pair : contact_pairs(scene.domain, spheres)) {
    const double overlap = elastic_impact(pair.first, pair.second, pair.properties, speed).overlap;
    deepest = std::max(deepest, overlap / std::min(pair.first.radius, pair.second.radius));
  }
  return deepest;
}

}  // namespace fiberchain::dem
