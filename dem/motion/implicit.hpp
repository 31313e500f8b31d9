#pragma once

#include <optional>

#include "dem/chain/chain_state.hpp"
#include "dem/motion/integrator.hpp"

// Implicit midpoint with the bonds' forces corrected along the motion so that their work is exactly the
// change of their energy (Gonzalez's discrete gradient, J. Nonlinear Sci. 6 (1996) 449, bond by bond on the
// strains). Momentum and angular momentum are kept as the corrected forces are those of some strain; energy
// changes by the work of the loads and the dissipation of the dashpots only, whatever the step.
namespace fiberchain::dem {

struct ImplicitOptions {
  double tolerance = 1e-9;  ///< last Newton change over the motion of the step
  int max_iterations = 40;
};

/// Follows one chain (total form, dead loads, clamped spheres).
template <int Dim>
class ImplicitMotion {
 public:
  ImplicitMotion(Chain<Dim> chain, Boundary<Dim> boundary, ChainState<Dim> state,
                 ImplicitOptions options = {});

  /// One step of dt [s]; taken in halves where Newton's method does not converge. Throws Diverged when that
  /// does not help, the state staying the last that was reached.
  void step(double dt);

  const ChainState<Dim>& state() const { return state_; }
  const Work& work() const { return work_; }
  double dissipated() const { return dissipated_; }  ///< by the dashpots so far [J]

 private:
  /// What a guess of the mean velocities over the step stands for.
  struct Trial {
    Poses<Dim> middle;
    ChainVector<Dim> out_of_balance;  ///< what the mean velocities would have to change by, as forces
  };
  Trial trial(const ChainVector<Dim>& mean_velocity, double dt) const;
  ChainTangent<Dim> matrix(const Poses<Dim>& middle, double dt) const;
  bool solve_step(double dt);
  void accept(const Poses<Dim>& middle, const ChainVector<Dim>& mean_velocity, double dt);

  Chain<Dim> chain_;
  Boundary<Dim> boundary_;
  ChainState<Dim> state_;
  ImplicitOptions options_;
  ChainVector<Dim> acceleration_, before_;  ///< of the last two steps, for the first guess of the next
  std::vector<double> energy_;              ///< of the bonds now
  std::optional<ChainFactors<sphere_motions<Dim>>> factors_;  ///< kept from step to step while they serve
  double factors_step_ = 0;
  Work work_;
  double dissipated_ = 0;
};

}  // namespace fiberchain::dem
