#pragma once

#include <cstddef>
#include <string_view>

// Inner loops are compiled once for each instruction set (cmake/kernels.cmake) and chosen when the program
// runs.
namespace fiberchain::dem {

enum class InstructionSet { scalar, sse2, avx2, avx512 };

std::string_view name(InstructionSet set);

/// The widest that this processor has.
InstructionSet best_instruction_set();

/// Throws InvalidInput when this processor lacks the instruction set.
void require_supported(InstructionSet set);

/// Kernel `index` of a family, whose tables are `Family<set>::table()`, each defined by one compiled copy.
/// Throws InvalidInput when this processor lacks the instruction set.
template <template <InstructionSet> class Family>
const auto& kernel_of(InstructionSet set, std::ptrdiff_t index) {
  require_supported(set);
  switch (set) {
    case InstructionSet::avx512:
      return Family<InstructionSet::avx512>::table()[index];
    case InstructionSet::avx2:
      return Family<InstructionSet::avx2>::table()[index];
    case InstructionSet::sse2:
      return Family<InstructionSet::sse2>::table()[index];
    default:
      return Family<InstructionSet::scalar>::table()[index];
  }
}

}  // namespace fiberchain::dem
