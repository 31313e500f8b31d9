#include <fmt/format.h>

#include <algorithm>

#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"

namespace fiberchain::dem {
namespace {

std::ptrdiff_t index_of(const Physics& physics, std::span<const Physics> list, bool for_packings) {
  const auto found = std::ranges::find(list, physics);
  if (found == list.end() || (for_packings && !built_for_packings(physics))) {
    throw InvalidInput(fmt::format(
        "dimension = {}, form = {}, damped = {}, settling_damping = {}, curved = {}, solved = {}, rolling = "
        "{}, fluid = {}, Maxwell branches = {}, breaking or yielding = {} is not among the combinations that "
        "are built{}",
        physics.dimension, name(physics.form), physics.damped, physics.settling_damping, physics.curved,
        name(physics.solved), name(physics.rolling), physics.fluid, physics.branches, physics.fails,
        for_packings ? " for fibers among others" : ""));
  }
  return found - list.begin();
}

}  // namespace

std::ptrdiff_t packing_index(const Physics& physics, std::span<const Physics> list) {
  return index_of(physics, list, true);
}

const ChainKernel& chain_kernel(const Physics& physics, InstructionSet set) {
  return kernel_of<ChainKernels>(set, index_of(physics, built_physics, false));
}

const PackingKernel& packing_kernel(const Physics& physics, InstructionSet set) {
  if (physics.fails) return kernel_of<FailingKernels>(set, packing_index(physics, failing_physics));
  return kernel_of<PackingKernels>(set, packing_index(physics, built_physics));
}

}  // namespace fiberchain::dem
