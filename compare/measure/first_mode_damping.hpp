#pragma once

#include <limits>
#include <vector>

#include "compare/measure/peaks.hpp"
#include "reference/chain_modes.hpp"
#include "reference/linear_chain.hpp"

// How xi_f of the first mode alone is measured on a motion that begins with higher modes too.
namespace fiberchain::compare {

/// Part of a motion's peaks that is measured.
struct CleanPeaks {
  enum class Way {
    mode_release,  ///< let go from the first mode: nothing to part
    filter,        ///< lightly damped: the first mode's part (first_mode_filter.hpp)
    wait,          ///< peaks after the higher modes are gone
    none           ///< higher modes outlive the first: it cannot be seen alone
  };
  Way way;
  PeakRange range;      ///< counted from the point of release
  double settling = 0;  ///< periods to watch on until rest, where the peaks get as small as what the
                        ///< incremental form leaves of a bend; they are counted from that rest

  double periods() const;  ///< to watch
};

/// For a release from equilibrium: what higher modes do to xi_f stays below 1e-4 of it. They begin with 3 %
/// and decay as the linear chain's say; where that takes more than 15 periods, or more than there are, the
/// motion is filtered instead.
/// @param most_periods that can be watched
CleanPeaks clean_peaks(const reference::LinearChain& chain, const reference::ChainMode& mode,
                       double most_periods = std::numeric_limits<double>::infinity());

/// The first so many of the filtered motion and one more, whatever the damping.
CleanPeaks filtered_peaks(int intervals);

/// For a release from the first mode: four peaks, fewer where the last would be lost.
CleanPeaks mode_release_peaks(const reference::ChainMode& mode);

/// xi_f of the first mode by two routes, the peaks and a damped sine.
struct FirstModeDamping {
  Damping peaks;
  double sine;                 ///< NaN where the fit does not converge
  std::vector<Peak> measured;  ///< those of the range
};

/// @throws InputError where the motion does not show these peaks or they do not decay
FirstModeDamping first_mode_damping(const TipHistory& history, const CleanPeaks& clean, double frequency);

}  // namespace fiberchain::compare
