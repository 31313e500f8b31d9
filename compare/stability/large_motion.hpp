#pragma once

#include "dem/motion/physics.hpp"

// Large motions with bonds solved for within the step (leapfrog-stiff), at odd parameters.
namespace fiberchain::compare {

/// Observed order in the step, from three steps, of the tip of a cantilever on which a dead load PL^2/EI
/// rises over the first of two periods; in space one that also turns it out of the plane.
struct ObservedOrder {
  double order;
  double error;  ///< of the tip over L at the largest of the steps
  double ratio;  ///< of that step to t_b
};

template <int Dim>
ObservedOrder order_of_large_motion(dem::BondForm form, double load);

/// Change of momentum and of angular momentum of a free chain in wild motion over 2000 steps of `ratio` t_b,
/// over the sums of the spheres' own sizes.
struct MomentumChange {
  double linear, angular;
};

MomentumChange momentum_change(dem::BondForm form, double ratio);

}  // namespace fiberchain::compare
