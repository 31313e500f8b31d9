#pragma once

#include <optional>

#include "compare/contact/impact_case.hpp"

// An impact through the whole engine of packings (dem::Assembly).
namespace fiberchain::compare {

/// What came of an impact.
struct ImpactOutcome {
  reference::PlanarMotion first, second;
  double force = 0, overlap = 0;  ///< largest [N], [m]; of a march by a parabola through the largest three
  double time = 0;                ///< of contact, from the straight paths before and after [s]
  double steps = 0;               ///< of the march in contact
};

/// The step that the program chooses for fibers of these spheres, with bonds of the spheres' material, at
/// these speeds (dem::assembly_time_step) [s].
double default_step(const ImpactCase& impact);

/// In steps of `step` [s], the touch `phase` of one after the start. An assembly has fibers of at least two
/// spheres: here of two, across the plane of motion, whose bond is as good as none (1e-18 of the modulus), so
/// that each sphere is alone; what is reported is that of their first spheres. The plane is tilted against
/// all axes.
ImpactOutcome marched_impact(const ImpactCase& impact, double step, double phase);

}  // namespace fiberchain::compare
