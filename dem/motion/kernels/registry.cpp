#include <fmt/format.h>

#include <algorithm>

#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"

namespace fiberchain::dem {
namespace {

/// Index of a physics among those that are built.
std::ptrdiff_t index_of(const Physics& physics, bool for_packings) {
  const auto found = std::find(built_physics.begin(), built_physics.end(), physics);
  if (found == built_physics.end() || (for_packings && !built_for_packings(physics))) {
    throw InvalidInput(fmt::format(
        "dimension = {}, form = {}, damped = {}, drag = {}, curved = {}, solved = {}, rolling = {}, fluid = {} is not among the "
        "combinations that are built{}",
        physics.dimension, name(physics.form), physics.damped, physics.settling_damping, physics.curved, physics.solved,
        name(physics.rolling), physics.fluid, for_packings ? " for fibers among others" : ""));
  }
  return found - built_physics.begin();
}

}  // namespace

const ChainKernel& chain_kernel(const Physics& physics, InstructionSet set) {
  return kernel_of<ChainKernels>(set, index_of(physics, false));
}

const PackingKernel& packing_kernel(const Physics& physics, InstructionSet set) {
  return kernel_of<PackingKernels>(set, index_of(physics, true));
}

}  // namespace fiberchain::dem
