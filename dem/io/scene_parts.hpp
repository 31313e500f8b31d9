#pragma once

#include "dem/io/scene.hpp"
#include "dem/io/section.hpp"

// What scenes of several kinds have in common. All functions throw SceneError.
namespace fiberchain::dem::io {

/// Section "fiber"; the bonds are left as they are by default.
Fiber read_fiber(const Section& top);

/// Refuses a fiber whose numbers make no sense together.
void check_fiber(const Section& top, const Fiber& fiber);

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

}  // namespace fiberchain::dem::io
