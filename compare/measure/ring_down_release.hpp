#pragma once

#include "compare/measure/peaks.hpp"
#include "dem/vibration/release.hpp"
#include "reference/chain_modes.hpp"

// Cantilevers let go: their states at the release, and the history of the free end.
namespace fiberchain::compare {

/// Largest load at which the fiber is let go from its first mode for fiber_damping; beyond, from its
/// equilibrium.
inline constexpr double largest_mode_release_load = 0.01;

/// From the chain's own first damped mode with tip deflection `amount` L: poses along the arc, so that no
/// bond is stretched, and the velocities of the mode.
dem::Release<2> mode_release(const dem::Fiber& fiber, const reference::ChainMode& mode, double amount,
                             double periods);

/// From the solved equilibrium under the load.
dem::Release<2> static_release(const dem::Fiber& fiber, const reference::ChainMode& mode, double load,
                               double periods);

/// The free end's deflection over L. Throws dem::Diverged with the reason if the run blew up.
TipHistory tip_history(const dem::ReleaseRecord<2>& record, double length);

}  // namespace fiberchain::compare
