#pragma once

#include <cstddef>

#include "dem/motion/moving_sphere.hpp"
#include "dem/motion/physics.hpp"
#include "dem/simd/instruction_set.hpp"

// The inner loops behind one interface of plain doubles: one compiled copy for every instruction set, chosen
// when the program runs. Results differ between instruction sets by the rounding of sin, cos and atan at
// most.
namespace fiberchain::dem {

/// A block of `width` chains side by side: number n of lane k stands at [n * width + k] of each array. Or one
/// chain along the lanes: number n of sphere (bond) i stands at [n * stride + i].
struct ChainBatchView {
  int bonds;
  Clamps clamps;
  double* spheres;           ///< MovingSphere, bonds + 1
  double* history;           ///< of the bond law, bonds; null size where it has none
  const double* natural;     ///< NaturalEnds, bonds (curved chains)
  const double* parameters;  ///< MarchParameters, one
  int stride = 0;            ///< along only
  const double* mobile =
      nullptr;  ///< along only: mass of an inner sphere over a sphere's, 0 where it is clamped
  double* workspace = nullptr;   ///< `workspace` of the kernel
  double* loads = nullptr;       ///< along only: BondLoads, bonds + 2, the first and last zero
  const double* dead = nullptr;  ///< fluid: EndLoad, bonds + 1, dead loads; null if there are none
  const double* gradients =
      nullptr;              ///< fluid: A of the steps to come, number n of lane k at [n * width + k]
  int gradient_stride = 0;  ///< doubles from one step's A to the next; 0 for a steady flow
};

struct ChainKernel {
  int width;                             ///< lanes: doubles in a vector
  std::size_t history;                   ///< doubles of a bond's history in a lane
  std::size_t (*workspace)(int bonds);   ///< doubles a lane that solving along the chain needs
  void (*start)(const ChainBatchView&);  ///< forces before the first step
  void (*march)(const ChainBatchView&, double steps_before, int steps);
  /// Velocities half a step on, or with `back` from those of the poses' moment half a step back, under the
  /// forces at hand; forces are not kept. Null where each sphere's follow from its own forces
  /// (half_step.hpp).
  void (*half_kick)(const ChainBatchView&, double steps_before, bool back);
  void (*start_single_chain)(
      const ChainBatchView&);  ///< one chain of at least `width` bonds along the lanes;
  void (*march_single_chain)(const ChainBatchView&, double steps_before,
                             int steps);  ///< null where it is not built
};

/// Kernels of one instruction set, in the order of built_physics.
template <InstructionSet set>
struct ChainKernels {
  static const ChainKernel* table();
};

/// Throws InvalidInput when this processor lacks the instruction set or the physics is not among
/// built_physics.
const ChainKernel& chain_kernel(const Physics& physics, InstructionSet set);

}  // namespace fiberchain::dem
