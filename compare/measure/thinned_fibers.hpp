#pragma once

#include "dem/assembly/assembly.hpp"

namespace fiberchain::compare {

/// Fibers at rest whose nodes are every so many spheres of these rows: fibers that are cut into long bonds
/// begin where those of touching spheres do. `chain` has as many bonds as that gives.
dem::FiberGroup thinned_fibers(const dem::FiberGroup& rows, dem::Chain<3> chain, int every);

}  // namespace fiberchain::compare
