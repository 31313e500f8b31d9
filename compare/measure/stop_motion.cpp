#include "compare/measure/stop_motion.hpp"

#include <algorithm>
#include <variant>
#include <vector>

namespace fiberchain::compare {

void stop_motion(dem::Assembly& assembly) {
  dem::SavedState state = assembly.saved();
  std::ranges::fill(std::get<std::vector<double>>(state.at("velocity_spin").values), 0.0);
  assembly.restore(state);
}

}  // namespace fiberchain::compare
