#pragma once

#include "dem/assembly/carried_state.hpp"
#include "dem/trajectory/frame.hpp"

namespace fiberchain::dem {

/// The fibers of a frame: consecutive ones of the same shape are a group. Their orientations follow from
/// their places, spins are zero, histories are not known.
/// @throws InvalidInput for a fiber of one sphere, or of spheres of several sizes
CarriedState state_of_frame(const TrajectoryFrame& frame);

}  // namespace fiberchain::dem
