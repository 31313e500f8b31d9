#pragma once

#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/model/domain.hpp"

namespace fiberchain::dem {

/// A wall at a time [s] and the spheres near it, as the loops take them: its motion half a step [s] before.
/// `parameters` of the law, of each kind; contacts that begin get their numbers in `near`.
WallView wall_view_at(const Wall& wall, int shape_index, WallNeighbors& near, const double* parameters,
                      double time, double step);

}  // namespace fiberchain::dem
