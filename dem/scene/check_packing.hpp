#pragma once

#include "dem/scene/packing_scene.hpp"
#include "dem/scene/strict_mapping.hpp"

// What a packing's values must be together, beyond each by itself. All throw SceneError with the line of the
// key at fault; `top` is the scene's top mapping.
namespace fiberchain::dem {

/// No more spheres than there are numbers for.
void check_number(const StrictMapping& top, const PackingScene& scene);

/// Fibers of files clear of each other and of the walls that are there at the start (check_starts.hpp).
void check_starts(const StrictMapping& top, const PackingScene& scene);

/// Refuses fibers whose spheres do not touch (spacing other than 1) where that is not built: in a fluid, and
/// where spheres would have to stand for the fiber between them in contacts.
void check_spacing(const StrictMapping& top, const PackingScene& scene);

/// A time step, batches and a number of steps that make sense: plan_of.
void check_plan(const StrictMapping& top, const PackingScene& scene);

}  // namespace fiberchain::dem
