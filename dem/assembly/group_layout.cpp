#include "dem/assembly/group_layout.hpp"

#include "dem/assembly/assembly_state.hpp"

namespace fiberchain::dem {

std::vector<GroupLayout> group_layouts(const Assembly::State& state) {
  std::vector<GroupLayout> all;
  for (std::size_t g = 0; g < state.kinds.size(); ++g) {
    const GroupKind& kind = state.kinds[g];
    all.push_back({state.fibers[g], kind.spheres(), kind.kernel->width,
                   static_cast<std::int64_t>(kind.kernel->history),
                   static_cast<std::int64_t>(kind.memory.bond), kind.law->form});
  }
  return all;
}

}  // namespace fiberchain::dem
