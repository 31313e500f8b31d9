#include "dem/scene/located_error.hpp"

#include "dem/model/invalid_key.hpp"
#include "dem/scene/strict_mapping.hpp"

namespace fiberchain::dem {

void throw_located(const SceneText& scene, const InvalidInput& error) {
  const StrictMapping top(scene);
  if (const auto* at = dynamic_cast<const InvalidKey*>(&error)) top.fail_within(at->key, error.what());
  top.fail("", error.what());
}

}  // namespace fiberchain::dem
