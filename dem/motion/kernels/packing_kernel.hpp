#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/simd/storage_layout.hpp"

// Fibers among others: their spheres lie in rows, sphere by sphere, where contacts want them; bonds still run
// in lanes across fibers. One pass a step reads a block's rows, evaluates its bonds, moves its spheres and
// writes the rows back.
namespace fiberchain::dem {

/// Energy that the bonds of a step have dissipated, and what is needed to know it at the next one.
struct BondAccount {
  double* previous;       ///< `bond_account_size` a bond, lane by lane
  double* bond_damping;   ///< sum [J], one a lane
  double* bond_friction;  ///< sum [J], one a lane
  double*
      scheme;  ///< sum [J], one a lane: work on the springs' part of the matrix, where they are solved for
};
/// Loads of the dashpots (and of explicit rolling friction), their powers, and the relative spin; where bonds
/// are solved for, their separation and relative motion.
inline constexpr int bond_account_size = 9 + 1 + 3 + 1 + 3;

/// Over bonds and steps: what limits a step that bonds are solved for in.
struct BondExtremes {
  double relative_speed = 0;  ///< of the two spheres [m/s]
  double length = 0;          ///< [m]
};

/// A block of `width` fibers of one kind. Unused lanes repeat the last fiber.
struct PackingBlock {
  int bonds;
  const std::int64_t* first;  ///< row of the first sphere of each lane
  double* position_radius;
  double* velocity_spin;
  double* loads;  ///< of the rows from `first_loaded` on
  std::int64_t first_loaded;
  double* orientation;         ///< null where it is not followed
  double* history;             ///< of the bond law, lane by lane
  const double* natural;       ///< NaturalEnds, lane by lane (curved fibers)
  const double* parameters;    ///< MarchParameters, lane by lane
  double* workspace;           ///< `workspace` of the kernel
  double* scratch;             ///< capacity for `scratch` doubles
  double weight[3];            ///< of a sphere that is not an end [N]
  double end_share;            ///< mass of an end sphere over that of the others
  const double* gradient;      ///< fluid: A now, lane by lane
  const double* next_history;  ///< of the block that comes next, to be fetched ahead; null if none
  std::int64_t rows_ahead;     ///< spheres from those of this block to those whose position_radius and
                               ///< velocity_spin are fetched meanwhile
  double previous_step;        ///< the step that led here: dt, or 0 before the first [s]
  BondExtremes* extremes;      ///< grow, where bonds are solved for
  MemoryView memory;           ///< of bonds with branches
  bool may_break = false;      ///< bonds that can: not where it is only looked at
};

struct PackingKernel {
  int width;
  std::size_t history;  ///< doubles of a bond's history in a lane, without branches
  std::size_t (*workspace)(
      int bonds);  ///< doubles a lane that solving along the chain needs, kept from step to step
  std::size_t (*scratch)(int bonds);  ///< doubles in all
  /// One step, after which the loads are zero; the square of the largest speed after it.
  double (*step)(const PackingBlock&);
  /// Forces at the rows as they are: MovingSphere by MovingSphere to `scratch`, lane by lane. The history
  /// moves on.
  void (*snapshot)(const PackingBlock&);
  /// After a snapshot: its velocities half a step on, or with `back` from those of this moment half a step
  /// back. Null where each sphere's follow from its own forces (half_step.hpp).
  void (*half_kick)(const PackingBlock&, bool back);
  /// Before a step: accounts the energy dissipated in the one before. Null where bonds dissipate none.
  void (*account)(const PackingBlock&, const BondAccount&);
};

/// Every combination built for fibers among others: three dimensions, no dashpots solved for without the
/// springs, no settling damping.
constexpr bool built_for_packings(const Physics& p) {
  return p.dimension == 3 && !p.settling_damping && p.solved != Solved::dashpots;
}

/// Kernels of one instruction set, in the order of built_physics; empty where not built for packings.
template <InstructionSet set>
struct PackingKernels {
  static const PackingKernel* table();
};

/// The same of bonds that break or yield, in the order of failing_physics.
template <InstructionSet set>
struct FailingKernels {
  static const PackingKernel* table();
};

/// As chain_kernel().
const PackingKernel& packing_kernel(const Physics& physics, InstructionSet set);

/// Kernels of a law from outside of the library, in the order of built_physics_of<form>. Their tables are
/// defined by one source, which fiberchain_add_kernels() compiles for each instruction set:
/// law_kernels_of<form, CompiledReal>.
template <BondForm form>
struct LawKernels {
  template <InstructionSet set>
  struct Of {
    static const PackingKernel* table();
  };
};

/// Index of a physics in a list. Throws InvalidInput, with the physics in words, where it is not in it or not
/// built for packings.
std::ptrdiff_t packing_index(const Physics& physics, std::span<const Physics> list);

/// As packing_kernel(), of a law from outside of the library.
template <BondForm form>
const PackingKernel& law_kernel(const Physics& physics, InstructionSet set) {
  return kernel_of<LawKernels<form>::template Of>(set, packing_index(physics, built_physics_of<form>));
}

}  // namespace fiberchain::dem
