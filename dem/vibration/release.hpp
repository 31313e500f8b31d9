#pragma once

#include <optional>
#include <vector>

#include "dem/boundary.hpp"
#include "dem/chain.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/lanes/kernel.hpp"

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
  BondForm form = BondForm::incremental;  ///< as the paper
  Integrator integrator = Integrator::leapfrog;
  /// Largest dt / t_b. Left out: explicit schemes 0.25, at most 0.8 of the stable step; implicit the sample interval.
  /// CVODE chooses its own steps.
  std::optional<double> step_ratio = std::nullopt;
  bool allow_unstable = false;  ///< march even beyond the stable step
  double tolerance = 1e-6;      ///< CVODE: relative, and absolute in parts of L
  double error = 1e-3;          ///< automatic: wanted error of xi_f, relative
  int samples_per_period = 200;
  bool energy = false;  ///< record the energy with each sample
  InstructionSet instruction_set = best_instruction_set();
};

/// The free end at one moment.
template <int Dim>
struct TipSample {
  double time;                 ///< since the release [s]
  Vec<double, Dim> position;   ///< [m]
  Vec<double, Dim> velocity;   ///< at the same moment [m/s]
  double energy;               ///< elastic and kinetic, of the whole chain [J]; 0 unless asked for
};

template <int Dim>
struct ReleaseRecord {
  double time_step;  ///< [s]; a whole number of them make a sample (CVODE: the mean)
  double steps;
  Integrator integrator;  ///< that was used
  Work work;
  std::vector<TipSample<Dim>> samples;  ///< the first is the moment of release
};

/// Step [s] of a release: the largest allowed that divides the sample interval. Throws InvalidInput when the step asked
/// for is unstable, with the limit.
template <int Dim>
double release_step(const Release<Dim>& release, const ReleaseOptions& options);

/// Lets every chain go. A record does not depend on what marches beside it. Throws InvalidInput for cases that make no
/// sense, Diverged when numbers stop being finite.
template <int Dim>
std::vector<ReleaseRecord<Dim>> ring_down(const std::vector<Release<Dim>>& releases, const ReleaseOptions& options = {});

}  // namespace fiberchain::dem
