#pragma once

#include <vector>

namespace fiberchain::dem {

/// A course through given values with a continuous rate, at rest before the first and after the last. It
/// rises where the values do and goes beyond none of them.
struct MonotoneCubic {
  std::vector<double> time;   ///< rising
  std::vector<double> value;  ///< one a time
  std::vector<double> rate;   ///< likewise

  double at(double t) const;
  double rate_at(double t) const;
  double largest_rate() const;  ///< in size
};

/// Piecewise cubic: 0 at both ends and where the values turn, else a harmonic mean of the slopes beside
/// (Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300).
MonotoneCubic monotone_cubic(std::vector<double> time, std::vector<double> value);

}  // namespace fiberchain::dem
