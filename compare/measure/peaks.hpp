#pragma once

#include <optional>
#include <vector>

// Damping measured from the motion of the free end, as the paper does (Eqs 17-19) and by a second route.
namespace fiberchain::compare {

/// Displacement of the free end with its velocity, so that maxima lie between samples without loss: units of
/// the user's choice, time in seconds.
struct TipHistory {
  std::vector<double> time, y, velocity;
};

struct Peak {
  double time;  ///< [s]
  double value;
};

/// Positive maxima in order. A history that starts at rest and displaced starts with its peak 0, the point of
/// release. Between samples the cubic Hermite interpolant is used: error (h omega)^4 / 384 of the amplitude.
std::vector<Peak> positive_peaks(const TipHistory& history);

/// Peaks first..last counted from the point of release, peak 0.
struct PeakRange {
  int first, last;
};

struct Damping {
  double ratio;  ///< xi_f
  double
      half_width;    ///< 95 % of the fit; the data are deterministic, so this shows lack of fit and not noise
  double frequency;  ///< damped, from peak to peak or as fitted [rad/s]
};

/// xi_f of a log decrement delta (Eq 17) and back.
double damping_ratio(double log_decrement);
double log_decrement(double damping_ratio);

/// Least squares of ln A_j = ln A_1 - delta (j - 1) over the range (Eqs 18, 19). Throws InputError when there
/// are fewer peaks than the range names or than two, or when they do not decay.
Damping damping_from_peaks(const std::vector<Peak>& peaks, PeakRange range);

/// Second route: A exp(-xi omega t) cos(omega_d t + phi) fitted by GSL to the samples from one time to
/// another. Throws InputError for fewer than 8 samples in the window or when the fit does not converge.
Damping damping_from_sine(const TipHistory& history, double from, double to, const Damping& start);

}  // namespace fiberchain::compare
