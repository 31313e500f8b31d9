#include "compare/measure/touching_fibers.hpp"

namespace fiberchain::compare {

std::vector<std::set<std::int64_t>> touching_fibers(const dem::Assembly& assembly) {
  const std::int64_t nodes = assembly.chain(0).fiber.aspect_ratio + 1;
  std::vector<std::set<std::int64_t>> touching(assembly.states(0).size());
  for (const dem::ContactState& contact : assembly.contacts()) {
    if (!is_of_fiber(contact.key.first) || !is_of_fiber(contact.key.second)) continue;
    const std::int64_t a = contact.key.first.number / nodes, b = contact.key.second.number / nodes;
    if (a == b) continue;
    touching[static_cast<std::size_t>(a)].insert(b);
    touching[static_cast<std::size_t>(b)].insert(a);
  }
  return touching;
}

double fibers_touched(const std::vector<std::set<std::int64_t>>& touching) {
  std::size_t sum = 0;
  for (const auto& others : touching) sum += others.size();
  return static_cast<double>(sum) / static_cast<double>(touching.size());
}

}  // namespace fiberchain::compare
