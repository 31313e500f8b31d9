#include "dem/simd/instruction_set.hpp"

#include <fmt/format.h>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

bool is_supported(InstructionSet set) {
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
    case InstructionSet::sse2:
      return "sse2";
    default:
      return "scalar";
  }
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2}) {
    if (is_supported(set)) return set;
  }
  return InstructionSet::sse2;
}

void require_supported(InstructionSet set) {
  if (!is_supported(set))
    throw InvalidInput(fmt::format("instruction set {} is not allowed: this processor lacks it", name(set)));
}

}  // namespace fiberchain::dem
