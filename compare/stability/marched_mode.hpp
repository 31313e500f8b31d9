#pragma once

#include <complex>

#include "compare/stability/run.hpp"

// One mode of a chain as its run has it: period error and numerical damping of a scheme.
namespace fiberchain::compare {

/// A planar chain's bending modes are real where all its dashpots have one retardation time.
struct ModeRun {
  StabilityRun chain;     ///< clamped_free, in the plane; DashpotLaw::retardation_time
  int mode = 0;           ///< 0 is the lowest
  double part_of_period;  ///< time step over the mode's undamped period
  int steps = 400;
};

struct MarchedMode {
  std::complex<double>
      z;           ///< of the run: its free end's u_{n+1} = 2 Re(z) u_n - |z|^2 u_{n-1}, least squares
  double angle;    ///< w dt, w the undamped frequency by the reference's modes
  double damping;  ///< of the mode, tau w/2

  double damping_error() const;    ///< -ln|z|/|ln z| over `damping`, less 1
  double frequency_error() const;  ///< |ln z| over `angle`, less 1
};

/// Marches a tiny motion that starts as that mode's velocities. Throws dem::InvalidInput,
/// reference::InvalidArgument.
MarchedMode marched_mode(const ModeRun& run);

}  // namespace fiberchain::compare
