#pragma once

#include "dem/io/scene.hpp"
#include "dem/io/section.hpp"

// What scenes of several kinds have in common. All functions throw SceneError.
namespace fiberchain::dem::io {

/// Keys of a section that describes a fiber.
inline const std::vector<std::string> kFiberKeys = {"diameter",      "aspect_ratio",  "youngs_modulus",
                                                    "poisson_ratio", "shear_modulus", "density"};

/// The fiber that a section with these keys describes; the bonds are left as they are by default.
Fiber read_fiber_keys(const Section& section);

/// Section "fiber"; the bonds are left as they are by default.
Fiber read_fiber(const Section& top);

/// Refuses a fiber whose numbers make no sense together.
void check_fiber(const Section& section, const Fiber& fiber, const char* key = "fiber");

/// Keys model, form and damping of section "bond"; what is absent stays as it is.
void read_bond(const Section& section, Fiber& fiber, BondForm& form);

/// Section "load": reduced or force, and its direction.
EndPull read_load(const Section& top, const Fiber& fiber, Dimension dimension);

/// Unit vector along the three numbers of a key; in the x-y plane where the scene is planar.
std::array<double, 3> read_direction(const Section& section, const char* key, Dimension dimension);

/// "dimension", planar if absent.
Dimension read_dimension(const Section& top);

ReleaseScene read_release(const Section& top);

/// Section "fluid": viscosity, flow and hydrodynamics of a flow scene, with its rate.
void read_fluid(const Section& top, FlowScene& scene);

FlowScene read_flow(const Section& top);

PackingScene read_packing(const Section& top);

/// Sections "walls", "periodic", "gravity", "fluid" and "contacts" of a packing, and the room they leave.
void read_room(const Section& top, PackingScene& scene);

/// Gives the room the sides that neither walls nor periods give: of the region, and of what stands in it.
void complete_room(PackingScene& scene);

}  // namespace fiberchain::dem::io
