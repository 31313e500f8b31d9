#include <algorithm>
#include <fmt/format.h>

#include "dem/errors.hpp"
#include "dem/motion/lanes/kernel.hpp"
#include "dem/motion/lanes/row_tables.hpp"
#include "dem/motion/lanes/tables.hpp"

namespace fiberchain::dem {
namespace {

bool has(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512: return __builtin_cpu_supports("avx512f");
    case InstructionSet::avx2: return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    default: return true;
  }
}

const LaneKernel* kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512: return kernels_avx512();
    case InstructionSet::avx2: return kernels_avx2();
    case InstructionSet::sse2: return kernels_sse2();
    default: return kernels_scalar();
  }
}

const RowKernel* rows(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512: return rows_avx512();
    case InstructionSet::avx2: return rows_avx2();
    case InstructionSet::sse2: return rows_sse2();
    default: return rows_scalar();
  }
}

/// Place of a physics among those that are built.
std::ptrdiff_t place_among(const Physics& physics, InstructionSet set, bool in_rows) {
  if (!has(set)) throw InvalidInput(fmt::format("instruction set {} is not allowed: this processor lacks it", name(set)));
  const auto found = std::find(built_physics.begin(), built_physics.end(), physics);
  if (found == built_physics.end() || (in_rows && !built_in_rows(physics))) {
    throw InvalidInput(fmt::format("dimension = {}, form = {}, damped = {}, drag = {}, curved = {}, solved = {}, "
                                   "rolling = {}, fluid = {} is not among the combinations that are built{}", physics.dimension,
                                   name(physics.form), physics.damped, physics.drag, physics.curved, physics.solved,
                                   name(physics.rolling), physics.fluid, in_rows ? " for fibers among others" : ""));
  }
  return found - built_physics.begin();
}

}  // namespace

std::string_view name(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512: return "avx512";
    case InstructionSet::avx2: return "avx2";
    case InstructionSet::sse2: return "sse2";
    default: return "scalar";
  }
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2}) {
    if (has(set)) return set;
  }
  return InstructionSet::sse2;
}

const LaneKernel& lane_kernel(const Physics& physics, InstructionSet set) {
  return kernels(set)[place_among(physics, set, false)];
}

const RowKernel& row_kernel(const Physics& physics, InstructionSet set) {
  return rows(set)[place_among(physics, set, true)];
}

}  // namespace fiberchain::dem
