#pragma once

#include <optional>
#include <vector>

#include "dem/chain/residual.hpp"
#include "dem/model/interrupted.hpp"
#include "dem/motion/physics.hpp"
#include "dem/simd/instruction_set.hpp"

// Equilibrium as the paper finds it: a slow load ramp, strong damping, and a march until the chain is at rest
// by measure. Chains of equal length march side by side in SIMD lanes.
namespace fiberchain::dem {

struct RelaxOptions {
  BondForm form = BondForm::total;
  double bond_damping = 0.25;  ///< xi_b while settling, in place of the fiber's own; 0 allowed
  double drag =
      1.0;  ///< drag on every sphere over the critical one of the first bending mode; 0: as the paper
  std::optional<double> step_ratio =
      std::nullopt;             ///< dt / t_b; left out: 0.8 of the largest stable step of each chain
  double ramp_periods = 2.0;    ///< length of each load ramp in periods of the first bending mode
  double residual = 1e-10;      ///< at rest: Imbalance::moment and speed / (omega_1 L) both below this
  double max_periods = 2000.0;  ///< of the first bending mode, after the last ramp
  InstructionSet instruction_set = best_instruction_set();
  StopRequest asked_to_stop = {};
};

/// One chain and the loads it sees one after the other; the last is the one it rests under. Clamps and loads
/// at end spheres only; the clamps of the first boundary hold throughout.
template <int Dim>
struct RelaxCase {
  Chain<Dim> chain;
  std::vector<Boundary<Dim>> loading;
};

template <int Dim>
struct RelaxResult {
  Poses<Dim> poses;
  ChainVector<Dim> net;  ///< forces and moments still out of balance on every sphere [N, N m]
  Imbalance residual;
  double speed;      ///< largest speed of a sphere over omega_1 L
  double time_step;  ///< [s]
  double steps;
};

/// Marches every case to rest, in the order given; each stops at its own residual whatever its neighbors do.
/// Throws InvalidInput for options or cases out of range (an unstable step among them), Diverged when numbers
/// stop being finite, NoConvergence when max_periods pass, Interrupted when asked to stop.
template <int Dim>
std::vector<RelaxResult<Dim>> relax_to_equilibrium(const std::vector<RelaxCase<Dim>>& cases,
                                                   const RelaxOptions& options = {});

/// Step [s] that a march of this fiber takes under these options. Throws InvalidInput when it would be
/// unstable.
double chosen_step(const Fiber& fiber, const RelaxOptions& options);

/// First bending frequency of the clamped chain's continuum, beta_1^2 sqrt(EI l / m) / L^2 [rad/s].
double first_bending_frequency(const Fiber& fiber);

}  // namespace fiberchain::dem
