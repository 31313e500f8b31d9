#pragma once

#include "dem/scene/scene.hpp"
#include "dem/scene/strict_mapping.hpp"

// What scenes of several kinds have in common. All functions throw SceneError.
namespace fiberchain::dem {

/// Keys of a section that describes a fiber.
inline const std::vector<std::string> kFiberKeys = {"diameter",      "aspect_ratio",  "youngs_modulus",
                                                    "poisson_ratio", "shear_modulus", "density"};

/// The fiber that a section with these keys describes; the bonds are left as they are by default.
Fiber read_fiber_keys(const StrictMapping& section);

/// StrictMapping "fiber"; the bonds are left as they are by default.
Fiber read_fiber(const StrictMapping& top);

/// Refuses a fiber whose numbers make no sense together.
void check_fiber(const StrictMapping& section, const Fiber& fiber, const char* key = "fiber");

/// Keys model, form and damping of section "bond"; what is absent stays as it is.
void read_bond(const StrictMapping& section, Fiber& fiber, BondForm& form);

/// StrictMapping "load": reduced or force, and its direction.
EndPull read_load(const StrictMapping& top, const Fiber& fiber, Dimension dimension);

/// Unit vector along the three numbers of a key; in the x-y plane where the scene is planar.
std::array<double, 3> read_direction(const StrictMapping& section, const char* key, Dimension dimension);

/// "dimension", planar if absent.
Dimension read_dimension(const StrictMapping& top);

ReleaseScene read_release(const StrictMapping& top);

/// StrictMapping "fluid": viscosity, flow and hydrodynamics of a flow scene, with its rate.
void read_fluid(const StrictMapping& top, FlowScene& scene);

FlowScene read_flow(const StrictMapping& top);

PackingScene read_packing(const StrictMapping& top);

/// Sections "walls", "periodic", "gravity", "fluid" and "contacts" of a packing, and the room they leave.
void read_domain(const StrictMapping& top, PackingScene& scene);

/// Gives the room the sides that neither walls nor periods give: of the region, and of what stands in it.
void complete_domain(PackingScene& scene);

}  // namespace fiberchain::dem
