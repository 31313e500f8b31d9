#pragma once

#include "compare/flow/study.hpp"

// What inertia does to a fiber in shear, and what it costs to follow it with and without.
namespace fiberchain::compare {

/// A fiber that starts at 45 degrees between gradient and vorticity (in space) or along the gradient (in the
/// plane).
struct InertiaCase {
  int spheres = 21;
  double elasto_viscous = 300;  ///< 3 pi mu rate L^4/(E I); at 300 it bends by less than 1 % of L
  double stokes = 0;  ///< m rate/(6 pi mu R), by the spheres' density; with a method that has inertia
  dem::FlowMethod method = dem::FlowMethod::inertialess;
  double tolerance = 1e-8;  ///< inertialess, cvode
};

template <int Dim>
FlowHistory run_inertia(const InertiaCase& asked, double strain, int intervals, bool shapes = false);

/// Largest distance over L of a sphere of the planar fiber from where it is without inertia, strains 0 to 10.
double inertia_distance(const InertiaCase& asked);

/// Relative change of Jeffery's orbit constant over a time, in space. Inertia takes a fiber toward the flow
/// plane, in proportion to the Stokes number; so does bending.
double orbit_drift(const InertiaCase& asked, double orbits);

FlowStudy inertia_study(const OrbitOptions& options);

/// Time of a step over the spheres, which does not change with their number where the cost is linear. To be
/// run while nothing else is.
dem::Table flow_cost_table();

}  // namespace fiberchain::compare
