#pragma once

#include <xsimd/xsimd.hpp>

#include "dem/simd/instruction_set.hpp"

// The instruction set that this copy of a kernel source is compiled for, FIBERCHAIN_INSTRUCTION_SET
// (cmake/kernels.cmake). Everything compiled there is a template on CompiledReal: its symbols are its own,
// and no function of another file can be replaced by one with foreign instructions.
namespace fiberchain::dem {

template <InstructionSet set>
struct PackOf;
template <>
struct PackOf<InstructionSet::scalar> {
  using Real = double;
};
#ifdef __AVX2__
template <>
struct PackOf<InstructionSet::avx2> {
  using Real = xsimd::batch<double, xsimd::avx2>;
};
#endif
#ifdef __AVX512F__
template <>
struct PackOf<InstructionSet::avx512> {
  using Real = xsimd::batch<double, xsimd::avx512f>;
};
#endif

inline constexpr InstructionSet compiled_set = InstructionSet::FIBERCHAIN_INSTRUCTION_SET;
using CompiledReal = PackOf<compiled_set>::Real;

}  // namespace fiberchain::dem
