#pragma once

#include <optional>
#include <vector>

#include "compare/contact/impact_case.hpp"
#include "dem/assembly/assembly.hpp"

namespace fiberchain::compare {

/// Fibers of two spheres across a plane that is tilted against all axes, whose bonds have `bonds` of the
/// modulus of the spheres: 1e-18 is as good as none, so that each sphere is alone. They touch after `lead`
/// [s].
struct SphereScene {
  std::vector<dem::FiberGroup> groups;
  dem::Domain domain;
};

SphereScene sphere_scene(const ImpactCase& impact, double bonds, double lead);

inline constexpr double no_bonds = 1e-18;

/// Of the first sphere of a group.
reference::PlanarMotion motion_of(const dem::Assembly& assembly, int group);
/// Component along x of the plane.
double along(const dem::Vec<double, 3>& vector);
/// Between the surfaces of the first spheres, along the line of centers [m].
double gap_of(const dem::Assembly& assembly, const ImpactCase& impact);
/// The contact that the first sphere of all has.
std::optional<dem::ContactState> contact_of(const dem::Assembly& assembly);
/// Largest value of a parabola through the largest of these and its neighbors.
double peak_of(const std::vector<double>& values);

}  // namespace fiberchain::compare
