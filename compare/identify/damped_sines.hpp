#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

// A record as a sum of damped sines beside an offset, by least squares.
namespace fiberchain::compare {

/// A displacement at rising times.
struct RingDownRecord {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< in any unit, from any zero
};

/// exp(-s t) (a cos(w t) + b sin(w t)), t from the record's first moment.
struct DampedSine {
  double a, b;  ///< in the record's unit
  double s;     ///< decay [1/s]
  double w;     ///< damped frequency [rad/s]
};

/// Parameters of a mode in a fit's covariance, behind the offset: a, b, s, w of each.
inline constexpr int sine_parameters = 4;

struct SineFit {
  double offset = 0;
  std::vector<DampedSine> modes = {};
  double squares = 0;  ///< sum of those of the residuals
  std::vector<double> residuals = {};
  Eigen::MatrixXd covariance = {};  ///< of offset, a, b, s, w, a, ... at residuals of unit variance
  bool converged = false;

  int parameters() const { return 1 + sine_parameters * static_cast<int>(modes.size()); }
  /// Schwarz's criterion: n ln(squares/n) + p ln n. The lower, the better.
  double criterion() const;
};

/// The record's mean alone.
SineFit mean_of(const RingDownRecord& record);

/// Least squares by Gauss-Newton steps, damped as Levenberg and Marquardt have it, from this start.
SineFit fit_sines(const RingDownRecord& record, double offset, const std::vector<DampedSine>& start);

/// The damped sine that takes most of what this record holds: frequencies about the highest peak of its
/// spectrum, decays of a grid, the best amplitude of each. Frequencies are below `highest` [rad/s].
DampedSine strongest_sine(const RingDownRecord& record, double highest);

/// Half of the mean sampling frequency [rad/s].
double nyquist_frequency(const RingDownRecord& record);

}  // namespace fiberchain::compare
