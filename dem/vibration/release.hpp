#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/chain/chain_state.hpp"
#include "dem/model/interrupted.hpp"
#include "dem/model/loads.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/physics.hpp"
#include "dem/simd/instruction_set.hpp"

// Damped vibration: chains let go from a given state, marched side by side in lanes, their free end recorded.
namespace fiberchain::dem {

/// A chain clamped at sphere 0, the state it is let go from, and how long it is watched.
template <int Dim>
struct Release {
  Chain<Dim> chain;
  Poses<Dim> start;                             ///< e.g. a loaded equilibrium
  std::vector<Vec<double, Dim>> velocity = {};  ///< of the spheres [m/s]; empty: at rest
  std::vector<Spin<double, Dim>> spin = {};     ///< [1/s]; empty: at rest
  double period;                                ///< of the first mode, what samples are counted by [s]
  double periods;                               ///< how long to watch
};

struct ReleaseOptions {
  BondForm form = BondForm::incremental;  ///< as the paper; implicit and CVODE have the total form only
  Integrator integrator = Integrator::leapfrog;
  /// Largest dt / t_b. Left out: explicit schemes 0.8 of the chain's stable step, implicit the sample
  /// interval. CVODE chooses its own steps.
  std::optional<double> step_ratio = std::nullopt;
  bool allow_unstable = false;  ///< march even beyond the stable step
  double tolerance = 1e-6;      ///< CVODE: local error in parts of the first deflection
  double error = 1e-3;          ///< automatic: wanted relative error of damping and frequency
  Rolling rolling =
      Rolling::set_valued;  ///< how, where a fiber has rolling friction; incremental leapfrog only
  int samples_per_period = 200;
  bool energy = false;  ///< record the energy with each sample
  InstructionSet instruction_set = best_instruction_set();
  StopRequest asked_to_stop = {};
};

/// The free end at one moment.
template <int Dim>
struct TipSample {
  double time;                ///< since the release [s]
  Vec<double, Dim> position;  ///< [m]
  Vec<double, Dim> velocity;  ///< at the same moment [m/s]
  double energy;              ///< elastic and kinetic, of the whole chain [J]; 0 unless asked for
};

template <int Dim>
struct ReleaseRecord {
  double time_step;  ///< [s]; a whole number of them make a sample (CVODE: the mean)
  double steps;
  Integrator integrator;  ///< that was used
  std::string reason;     ///< why, if it was chosen here
  Work work;
  std::vector<TipSample<Dim>> samples;  ///< the first is the moment of release
  std::string
      failure;  ///< empty; else step, time, fiber, sphere and likely cause, and the samples end before it
  ChainState<Dim> last;  ///< the last good state; of a leapfrog with the velocities half a step before
};

/// Step [s] of a release: the largest allowed that divides the sample interval. Throws InvalidInput when the
/// step asked for is unstable, with the limit. CVODE, which has no step of its own, gets the sample interval.
template <int Dim>
double release_step(const Release<Dim>& release, const ReleaseOptions& options);

/// Largest stable step [s] of an explicit integrator for this fiber; infinite for the others, though what is
/// solved within the step has limits of its own (stiff_release_step).
double stable_release_step(const Fiber& fiber, Integrator integrator);

/// Tip deflection over L that the motion swings to, in its first mode from start and velocities.
template <int Dim>
double swing(const Release<Dim>& release);

/// Longest step [s] of the leapfrog with springs solved for: bonds turn by at most `turn` [rad] as the fiber
/// swings in its first mode, and the tension is at most that of the start (stiff_limits.hpp).
template <int Dim>
double stiff_release_step(const Release<Dim>& release, double turn);

/// Lets every chain go. A record does not depend on what marches beside it but by round-off where a chain
/// marches alone. One that blows up stops, the others go on. Throws InvalidInput for cases that make no
/// sense, Interrupted when asked to stop.
template <int Dim>
std::vector<ReleaseRecord<Dim>> ring_down(const std::vector<Release<Dim>>& releases,
                                          const ReleaseOptions& options = {});

}  // namespace fiberchain::dem
