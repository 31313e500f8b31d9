#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/model/fluid.hpp"
#include "dem/model/loads.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"

// What the inner loops are timed on: chains of 11 spheres swinging under a dead load.
namespace fiberchain::compare {

inline constexpr int kernel_bonds = 10;
/// Maxwell branches of a bond in bending, where a physics has them.
inline constexpr int kernel_branches = 5;

/// The nominal fiber with that many bonds, undamped.
dem::Fiber kernel_fiber();

/// A cantilever under a dead load that rises over so many steps; as damped, curved and so on as the physics.
template <int Dim>
struct SwingingChain {
  dem::Chain<Dim> chain;
  double step;  ///< [s]: half of the largest stable one
  double drag;  ///< [1/s]
  dem::Load<Dim> load;
  double ramp_steps;
  dem::Fluid fluid;  ///< around it, where the physics has one
};

template <int Dim>
SwingingChain<Dim> swinging_chain_of(const dem::Physics& physics);

/// "spatial incremental damped": the features that a physics has.
std::string text(const dem::Physics& physics);

/// A function that marches `chains` equal cantilevers side by side by `steps` steps each time it is called.
/// It throws dem::Diverged if numbers stop being finite, and what dem::ChainBatch throws.
std::function<void()> swinging_chains(const dem::Physics& physics, dem::InstructionSet set, int chains,
                                      int steps);

}  // namespace fiberchain::compare
