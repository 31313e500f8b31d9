#include "compare/measure/peaks.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// Maximum of the cubic Hermite interpolant on one interval, where the velocity turns from positive to
/// negative.
Peak hermite_peak(double t0, double t1, double y0, double y1, double v0, double v1) {
  const double h = t1 - t0, a = h * v0, b = h * v1, d = y1 - y0;
  // y = y0 + a s + (3d - 2a - b) s^2 + (a + b - 2d) s^3; its slope vanishes where the velocity changes sign
  const double c2 = 3 * d - 2 * a - b, c3 = a + b - 2 * d;
  double s = v0 / (v0 - v1);
  for (int i = 0; i < 20; ++i) {
    const double slope = a + s * (2 * c2 + 3 * c3 * s), curvature = 2 * c2 + 6 * c3 * s;
    const double step = slope / curvature;
    s = std::clamp(s - step, 0.0, 1.0);
    if (std::abs(step) < 1e-15) break;
  }
  return {t0 + s * h, y0 + s * (a + s * (c2 + s * c3))};
}

}  // namespace

std::vector<Peak> positive_peaks(const TipHistory& h) {
  std::vector<Peak> peaks;
  const double scale = h.y.empty() ? 0.0 : std::abs(h.y[0]);
  if (h.time.size() > 1 && h.y[0] > 0 && h.velocity[1] < 0 &&
      std::abs(h.velocity[0]) * (h.time[1] - h.time[0]) <= 1e-9 * scale) {
    peaks.push_back({h.time[0], h.y[0]});
  }
  for (std::size_t i = 1; i + 1 < h.time.size(); ++i) {
    if (h.velocity[i] > 0 && h.velocity[i + 1] <= 0) {
      const Peak peak =
          hermite_peak(h.time[i], h.time[i + 1], h.y[i], h.y[i + 1], h.velocity[i], h.velocity[i + 1]);
      if (peak.value > 0) peaks.push_back(peak);
    }
  }
  return peaks;
}

double damping_ratio(double delta) { return delta / std::hypot(2 * pi, delta); }

double log_decrement(double ratio) { return 2 * pi * ratio / std::sqrt(1 - ratio * ratio); }

Damping damping_from_peaks(const std::vector<Peak>& peaks, PeakRange range) {
  if (range.first < 0 || range.last <= range.first) {
    throw InputError(fmt::format("peaks {}..{} are not allowed: give at least two, the first 0 or more",
                                 range.first, range.last));
  }
  if (range.last >= static_cast<int>(peaks.size())) {
    throw InputError(
        fmt::format("peaks {}..{} are asked for but the motion has only {} (0..{}): watch it longer, or the "
                    "motion is overdamped",
                    range.first, range.last, peaks.size(), static_cast<int>(peaks.size()) - 1));
  }
  const int n = range.last - range.first + 1;
  const double mean_j = (range.first + range.last) / 2.0;
  double mean_ln = 0, jj = 0, j_ln = 0;
  for (int j = range.first; j <= range.last; ++j) mean_ln += std::log(peaks[j].value) / n;
  for (int j = range.first; j <= range.last; ++j) {
    jj += (j - mean_j) * (j - mean_j);
    j_ln += (j - mean_j) * (std::log(peaks[j].value) - mean_ln);
  }
  const double slope = j_ln / jj;
  if (!(slope < 0))
    throw InputError(fmt::format("peaks {}..{} do not decay: there is no damping", range.first, range.last));
  double residual = 0;
  for (int j = range.first; j <= range.last; ++j) {
    residual += std::pow(std::log(peaks[j].value) - mean_ln - slope * (j - mean_j), 2);
  }
  const double error = n > 2 ? std::sqrt(residual / (n - 2) / jj) * gsl_cdf_tdist_Pinv(0.975, n - 2) : 0.0;
  const double period = (peaks[range.last].time - peaks[range.first].time) / (n - 1);
  // d xi / d delta = 4 pi^2 / (4 pi^2 + delta^2)^(3/2)
  const double per_delta = 4 * pi * pi / std::pow(4 * pi * pi + slope * slope, 1.5);
  return {damping_ratio(-slope), error * per_delta, 2 * pi / period};
}

}  // namespace fiberchain::compare
