#pragma once

#include "dem/chain/residual.hpp"
#include "dem/equilibrium/stability.hpp"

// Equilibrium without marching: Newton's method on the bond law, its Jacobian eliminated block by block
// along the chain, the load raised in steps that halve when Newton fails.
namespace fiberchain::dem {

struct SolveOptions {
  double tolerance =
      1e-9;  ///< Newton step (displacement / L, rotation [rad]) after which one more step is taken
  int max_iterations = 25;           ///< per load step
  int max_load_steps = 20000;        ///< in all
  double smallest_load_step = 1e-9;  ///< of the whole load
  int load_steps = 1;                ///< least number of load steps; the path, not the result, depends on it
  bool allow_unstable = false;  ///< follow the path of equilibria from zero load even where it is unstable
};

struct SolveStatistics {
  int newton_iterations;
  int load_steps;
  int halvings;
  int bucklings;  ///< load steps that left an unstable equilibrium for a stable one of less energy
};

template <int Dim>
struct Equilibrium {
  Poses<Dim> poses;
  Imbalance residual;
  SolveStatistics statistics;
  Stability stability;
};

/// Equilibrium of the chain under its loads, followed from `start` (by default the rest state) at zero load.
/// At least one sphere must be clamped. Throws InvalidInput for a sphere that the chain does not have or a
/// load that is not finite, NoConvergence when a load step falls below the smallest.
template <int Dim>
Equilibrium<Dim> solve_equilibrium(const Chain<Dim>& chain, const Boundary<Dim>& boundary,
                                   const SolveOptions& options = {});

/// The same, the loads going from `from` (whose equilibrium `start` is) to `boundary`: any loading path in
/// pieces.
template <int Dim>
Equilibrium<Dim> continue_equilibrium(const Chain<Dim>& chain, const Poses<Dim>& start,
                                      const Boundary<Dim>& from, const Boundary<Dim>& boundary,
                                      const SolveOptions& options = {});

/// Motion of every sphere per unit load factor at the given state: K^-1 times the loads.
template <int Dim>
ChainVector<Dim> linear_response(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                 const Boundary<Dim>& boundary);

/// K^-1 times the forces out of balance: how far from equilibrium a state still is.
template <int Dim>
ChainVector<Dim> remaining_motion(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                  const Boundary<Dim>& boundary);

}  // namespace fiberchain::dem
