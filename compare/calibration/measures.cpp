#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "compare/calibration/calibration.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"
#include "reference/elastica.hpp"

// What a material's damping and a fiber's amplitude are, and what amplitude and time step do to a measured
// damping.
namespace fiberchain::compare {

std::string_view name(DampingMeasure measure) {
  switch (measure) {
    case DampingMeasure::log_decrement:
      return "log decrement";
    case DampingMeasure::quality_factor:
      return "quality factor";
    case DampingMeasure::loss_factor:
      return "loss factor";
    default:
      return "damping ratio";
  }
}

double to_damping_ratio(DampingMeasure measure, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw InputError(
        fmt::format("{} = {} is not allowed: it must be finite and above 0", name(measure), value));
  }
  double ratio = value;
  if (measure == DampingMeasure::log_decrement) ratio = damping_ratio(value);
  if (measure == DampingMeasure::quality_factor) ratio = 1 / (2 * value);
  if (measure == DampingMeasure::loss_factor) ratio = value / 2;
  if (!(ratio < 1)) {
    throw InputError(
        fmt::format("{} = {} means xi_f = {:g}, which cannot be reached: from 1 on there is no vibration",
                    name(measure), value, ratio));
  }
  return ratio;
}

double to_amplitude(AmplitudeMeasure measure, double value) {
  const bool is_load = measure == AmplitudeMeasure::load;
  if (!(value >= 0) || !std::isfinite(value)) {
    throw InputError(
        fmt::format("{} = {} is not allowed: 0 or more", is_load ? "load" : "tip deflection", value));
  }
  if (value == 0) return 0;
  // beyond a load of 100 the free end is past any amplitude allowed
  const double amplitude = is_load ? reference::elastica_shooting(std::min(value, 100.0)).y : value;
  if (amplitude > largest_amplitude) {
    throw InputError(
        fmt::format("{} = {} is not allowed: what the amplitude does to xi_f is known up to a tip deflection "
                    "of {} L (a load of 2.4)",
                    is_load ? "load" : "tip deflection", value, largest_amplitude));
  }
  return amplitude;
}

double amplitude_effect(double a) { return -a * a * (0.460 + 0.27 * a * a * (1 + a * a)); }

double time_step_effect(double xi, double frequency, double time_step) {
  const double w = frequency * time_step;
  // with z = 1 + e: e^2 + (w^2 + 2 xi w) e + w^2 = 0, so that no digits are lost where w is small
  const double half = (w * w + 2 * xi * w) / 2;
  const std::complex<double> e = -half + std::sqrt(std::complex<double>(half * half - w * w));
  const double log_size = 0.5 * std::log1p(-2 * xi * w);  // |z|^2 is the product of the roots
  const double angle = std::atan2(e.imag(), 1 + e.real());
  return -log_size / std::hypot(log_size, angle) / xi - 1;
}

}  // namespace fiberchain::compare
