#pragma once

#include <vector>

#include "dem/model/prony_series.hpp"

namespace fiberchain::dem {

/// A loss factor that branches are to have: that of a longer series, or the same at every frequency.
struct LossTarget {
  PronySeries series;  ///< as it; empty: `flat`
  double flat = 0;     ///< tan delta [-]
};

/// tan delta of the target at angular frequency omega [1/s].
double loss_factor(const LossTarget& target, double omega);

/// n branches and the 2n + 1 angular frequencies, ascending, ends of the band included, at which their error
/// is extreme: below the target at the even ones, above it at the odd ones.
struct RippledSeries {
  PronySeries series;
  std::vector<double> extremes;  ///< [1/s]
  double ripple = 0;             ///< largest relative error of tan delta in the band [-]
};

/// The branches whose largest relative error of tan delta between the first and the last of the extremes is
/// least: those with the same error at all 2n + 1 extremes (Chebyshev). Found by Remez's exchange, each
/// reference solved by Newton's method in the logarithms of strengths and times, which keeps them positive.
/// Throws NoConvergence where the start is too far away.
RippledSeries equal_ripple(RippledSeries start, const LossTarget& target);

}  // namespace fiberchain::dem
