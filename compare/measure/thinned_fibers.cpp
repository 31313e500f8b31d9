#include "compare/measure/thinned_fibers.hpp"

#include <utility>

namespace fiberchain::compare {

dem::FiberGroup thinned_fibers(const dem::FiberGroup& rows, dem::Chain<3> chain, int every) {
  dem::FiberGroup group{std::move(chain), {}};
  for (const dem::ChainState<3>& row : rows.fibers) {
    dem::ChainState<3> fiber = dem::at_rest<3>(group.chain.poses);
    for (std::size_t i = 0; i < fiber.poses.size(); ++i)
      fiber.poses[i] = row.poses[i * static_cast<std::size_t>(every)];
    group.fibers.push_back(std::move(fiber));
  }
  return group;
}

}  // namespace fiberchain::compare
