#pragma once

#include <string>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::compare {

/// Time of a packing of many sizes.
struct SizesTime {
  std::string sizes;  ///< which
  std::int64_t spheres;
  double all, search;  ///< [ns a sphere-step]
};

/// Fibers that fall in one room, one thread, in turns: of one size (first), these beside one large body (200
/// times their diameter), and of diameters from 1 to 100 mixed. The fastest of some runs each.
std::vector<SizesTime> sizes_times(const BenchOptions& options);

/// With what each takes over the first.
dem::Table sizes_time_table(const std::vector<SizesTime>& times);

}  // namespace fiberchain::compare
