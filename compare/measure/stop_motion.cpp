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

double stop_past_peak(dem::Assembly& assembly, double last) {
  double energy = 0;
  for (const dem::ChainState<3>& fiber : assembly.states(0)) {
    for (const auto& v : fiber.velocity) energy += dot(v, v);
  }
  if (!(energy < last)) return energy;
  stop_motion(assembly);
  return 0;
}

}  // namespace fiberchain::compare
