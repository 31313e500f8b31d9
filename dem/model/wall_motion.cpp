#include "dem/model/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiberchain::dem {
namespace {

/// 0 at x = 0, 1 at x = 1, without rate at both: 3 x^2 - 2 x^3.
double smooth_step(double x) { return x * x * (3 - 2 * x); }
double smooth_step_rate(double x) { return 6 * x * (1 - x); }

}  // namespace

double WallOscillation::at(double time) const {
  const double omega = 2 * std::numbers::pi * frequency,
               wave = amplitude * (std::sin(omega * time + phase) - std::sin(phase));
  if (!(ramp > 0) || time >= ramp) return ramp > 0 && time <= 0 ? 0 : wave;
  return time <= 0 ? 0 : smooth_step(time / ramp) * wave;
}

double WallOscillation::rate_at(double time) const {
  const double omega = 2 * std::numbers::pi * frequency, argument = omega * time + phase,
               rate = amplitude * omega * std::cos(argument);
  if (!(ramp > 0) || time >= ramp) return rate;
  if (time <= 0) return 0;
  const double x = time / ramp;
  return smooth_step(x) * rate +
         smooth_step_rate(x) / ramp * amplitude * (std::sin(argument) - std::sin(phase));
}

double WallOscillation::largest_rate() const {
  const double of_ramp = ramp > 0 ? 1.5 / ramp * (1 + std::abs(std::sin(phase))) : 0;
  return std::abs(amplitude) * (2 * std::numbers::pi * frequency + of_ramp);
}

}  // namespace fiberchain::dem
