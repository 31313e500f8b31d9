#include "compare/flow/turn_detection.hpp"
#include "compare/study/nan.hpp"

#include <cmath>
#include <numbers>

namespace fiberchain::compare {
namespace {

double phase_rate(const FlowMoment& m) {
  const Triple &p = m.direction, &q = m.direction_rate;
  return (q[0] * p[1] - q[1] * p[0]) / (p[0] * p[0] + p[1] * p[1]);
}

/// Where the cubic with these values and slopes at 0 and h passes `level`, which lies between the values.
double crossing(double h, double y0, double y1, double s0, double s1, double level) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double t = (low + high) / 2, u = 1 - t;
    const double y = y0 * u * u * (1 + 2 * t) + y1 * t * t * (3 - 2 * t) + h * t * u * (s0 * u - s1 * t);
    ((y < level) == (y0 < y1) ? low : high) = t;
  }
  return h * (low + high) / 2;
}

}  // namespace

std::vector<double> phases(const std::vector<FlowMoment>& moments) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<double> phase;
  for (const FlowMoment& m : moments) {
    const double angle = std::atan2(m.direction[0], m.direction[1]);
    phase.push_back(phase.empty() ? angle : angle + turn * std::round((phase.back() - angle) / turn));
  }
  return phase;
}

std::vector<double> half_turns(const std::vector<FlowMoment>& moments) {
  const std::vector<double> phase = phases(moments);
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < phase.size(); ++i) {
    const double level = std::numbers::pi * static_cast<double>(times.size() + 1);
    const double before = std::abs(phase[i] - phase[0]), after = std::abs(phase[i + 1] - phase[0]);
    if (before >= level || after < level) continue;
    const double sign = phase[i + 1] > phase[0] ? 1 : -1;
    const double h = moments[i + 1].time - moments[i].time;
    times.push_back(moments[i].time + crossing(h, before, after, sign * phase_rate(moments[i]),
                                               sign * phase_rate(moments[i + 1]), level));
  }
  return times;
}

double orbit_period(const std::vector<FlowMoment>& moments) {
  const std::vector<double> times = half_turns(moments);
  if (times.empty()) return nan;
  if (times.size() == 1) return 2 * (times[0] - moments.front().time);
  return 2 * (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

}  // namespace fiberchain::compare
