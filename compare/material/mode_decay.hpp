#pragma once

#include <vector>

#include "compare/measure/peaks.hpp"
#include "dem/vibration/release.hpp"
#include "reference/complex_modes.hpp"

// Chains with branches let go in their own complex modes, and how they ring down.
namespace fiberchain::compare {

/// A mode and the deflection of the free end over L that it begins with.
struct StruckMode {
  reference::ComplexChainMode mode;
  double amount;
};

/// The straight clamped chain struck so that it begins to swing in these modes, at the phase where they pass
/// through rest: branches, which begin relaxed, have little to catch up with then. Periods are those of the
/// first of the modes.
dem::Release<2> struck_release(const dem::Fiber& fiber, const std::vector<StruckMode>& modes, double periods);

/// Damping of one mode in time.
struct MarchedDecay {
  double damping;    ///< zeta by a damped sine fitted to the mode's part of the motion
  double by_peaks;   ///< zeta by the peaks of the same
  double frequency;  ///< [Hz]
  double time_step;  ///< [s]
  double steps;
};

/// The n-th bending mode (from 1), tip deflection 1e-6 L, over `intervals` of its periods. Throws InputError
/// where it cannot be measured.
MarchedDecay marched_decay(const dem::Fiber& fiber, const reference::ComplexChainMode& mode,
                           const dem::ReleaseOptions& options = {}, int intervals = 8);

/// Of a history with several modes: damping of the one with this frequency [rad/s]. All others must be half
/// as fast again or slower by as much.
Damping decay_in_company(const TipHistory& history, double frequency, int intervals);

/// The free end, deflection over L.
TipHistory struck_history(const dem::Fiber& fiber, const std::vector<StruckMode>& modes, double periods,
                          const dem::ReleaseOptions& options = {});

}  // namespace fiberchain::compare
