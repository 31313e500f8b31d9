#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "dem/assembly/assembly.hpp"

namespace fiberchain::compare {

/// The other fibers that each fiber touches, of assemblies whose fibers are all alike and in group 0; walls
/// do not count, a fiber that is touched at several places does once.
std::vector<std::set<std::int64_t>> touching_fibers(const dem::Assembly& assembly);

/// Mean number of them.
double fibers_touched(const std::vector<std::set<std::int64_t>>& touching);

}  // namespace fiberchain::compare
