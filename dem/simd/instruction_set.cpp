#include "dem/simd/instruction_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

bool is_supported(InstructionSet set) {
#ifdef FIBERCHAIN_SANITIZED
  return set == InstructionSet::scalar;
#endif
  switch (set) {
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f");
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    default:
      return true;
  }
}

}  // namespace

std::string_view name(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    default:
      return "scalar";
  }
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> all;
  std::ranges::copy_if(instruction_sets, std::back_inserter(all), is_supported);
  return all;
}

InstructionSet best_instruction_set() { return available_instruction_sets().back(); }

void require_supported(InstructionSet set) {
  if (!is_supported(set))
    throw InvalidInput(fmt::format("instruction set {} is not allowed: this processor lacks it", name(set)));
}

}  // namespace fiberchain::dem
