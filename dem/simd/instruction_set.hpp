#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

// Inner loops are compiled once for each instruction set (cmake/kernels.cmake) and chosen when the program
// runs.
namespace fiberchain::dem {

enum class InstructionSet { scalar, avx2, avx512 };

/// From narrow to wide.
inline constexpr InstructionSet instruction_sets[] = {InstructionSet::scalar, InstructionSet::avx2,
                                                      InstructionSet::avx512};

std::string_view name(InstructionSet set);

/// Those of this build that this processor has, from narrow to wide. Under the sanitizers the scalar one
/// alone is built: it is the same source.
std::vector<InstructionSet> available_instruction_sets();

/// The widest of these.
InstructionSet best_instruction_set();

/// Throws InvalidInput when this processor lacks the instruction set.
void require_supported(InstructionSet set);

/// Kernel `index` of a family, whose tables are `Family<set>::table()`, each defined by one compiled copy.
/// Throws InvalidInput when this processor lacks the instruction set.
template <template <InstructionSet> class Family>
const auto& kernel_of(InstructionSet set, std::ptrdiff_t index) {
  require_supported(set);
#ifndef FIBERCHAIN_SANITIZED
  switch (set) {
    case InstructionSet::avx512:
      return Family<InstructionSet::avx512>::table()[index];
    case InstructionSet::avx2:
      return Family<InstructionSet::avx2>::table()[index];
    default:
      break;
  }
#endif
  return Family<InstructionSet::scalar>::table()[index];
}

}  // namespace fiberchain::dem
