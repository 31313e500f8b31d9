#pragma once

#include <cstddef>

#include "dem/bond/branch_steps.hpp"
#include "dem/motion/bond_step.hpp"
#include "dem/simd/instruction_set.hpp"

// The inner loops behind one interface of plain doubles: one compiled copy for every instruction set, chosen
// when the program runs. Results differ between instruction sets by the rounding of sin, cos and atan at
// most.
namespace fiberchain::dem {

/// Bonds with Maxwell branches keep their strains behind their history.
struct MemoryView {
  const double* steps = nullptr;  ///< BranchStep in the order of BondBranches, lane by lane
  int stretch = 0, shear = 0, twist = 0, bend = 0;
  std::size_t bond = 0;  ///< numbers of a bond in a lane, its history with them

  bool operator==(const MemoryView&) const = default;
};

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
  MemoryView memory = {};   ///< of bonds with branches
};

/// What a block knows of branches: `history` the numbers of its bonds.
template <Physics P, class Real>
void set_memory(ChainBlock<P, Real>& chain, double* history, const MemoryView& memory) {
  if constexpr (P.branches) {
    chain.branches = {as_values<BranchStep<Real>>(memory.steps), memory.stretch, memory.shear, memory.twist,
                      memory.bend};
    chain.memory = as_values<Real>(history);
    chain.bond_memory = memory.bond;
  }
}

/// Bonds of Dim dimensions with these branches; `history` is what they keep besides.
template <int Dim>
MemoryView memory_view(const BranchSteps& branches, const double* steps, BondForm form, std::size_t history) {
  MemoryView view{steps, branches.stretch, branches.shear, branches.twist, branches.bend, history};
  with_bond_form(form, [&]<BondForm own>() {
    constexpr bool keeps_strain = ViscoelasticBond<BondLawType<own>>::keeps_strain;
    view.bond += branch_memory<keeps_strain, Dim>(view.stretch, view.shear, view.twist, view.bend);
  });
  return view;
}

struct ChainKernel {
  int width;                             ///< lanes: doubles in a vector
  std::size_t history;                   ///< doubles of a bond's history in a lane, without branches
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
