#pragma once

#include <cstddef>

#include "dem/motion/physics.hpp"
#include "dem/motion/state.hpp"

// The inner loops behind one interface of plain doubles: one compiled copy for every instruction set, chosen when the
// program runs. Results differ between instruction sets by the rounding of sin, cos and atan at most.
namespace fiberchain::dem {

/// A block of `width` chains side by side: number n of lane k stands at [n * width + k] of each array. Or one chain along
/// the lanes: number n of sphere (bond) i stands at [n * stride + i].
struct LaneBlock {
  int bonds;
  Clamps clamps;
  double* spheres;           ///< MovingSphere, bonds + 1
  double* history;           ///< BondHistory, bonds (incremental form)
  const double* natural;     ///< NaturalEnds, bonds (curved chains)
  const double* parameters;  ///< MarchParameters, one
  int stride = 0;            ///< along only
  const double* mobile = nullptr;  ///< along only: 1 a sphere, 0 where it is clamped
  double* workspace = nullptr;  ///< `workspace` of the kernel
  double* loads = nullptr;   ///< along only: BondLoads, bonds + 2, the first and last zero
  const double* dead = nullptr;       ///< fluid: EndLoad, bonds + 1, dead loads; null if there are none
  const double* gradients = nullptr;  ///< fluid: A of the steps to come, number n of lane k at [n * width + k]
  int gradient_stride = 0;            ///< doubles from one step's A to the next; 0 for a steady flow
};

struct LaneKernel {
  int width;                                                  ///< lanes: doubles in a vector
  std::size_t (*workspace)(int bonds);                        ///< doubles a lane that solving along the chain needs
  void (*start)(const LaneBlock&);                            ///< forces before the first step
  void (*march)(const LaneBlock&, double steps_before, int steps);
  void (*start_along)(const LaneBlock&);                      ///< one chain of at least `width` bonds along the lanes;
  void (*march_along)(const LaneBlock&, double steps_before, int steps);  ///< null where it is not built
};

enum class InstructionSet { scalar, sse2, avx2, avx512 };

std::string_view name(InstructionSet set);

/// The widest that this processor has.
InstructionSet best_instruction_set();

/// Throws InvalidInput when this processor lacks the instruction set or the physics is not among built_physics.
const LaneKernel& lane_kernel(const Physics& physics, InstructionSet set);

/// Alignment of the arrays that suits every instruction set [bytes].
inline constexpr int lane_alignment = 64;

}  // namespace fiberchain::dem
