#include "compare/material/points.hpp"

#include <cmath>
#include <numbers>

#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/first_mode_filter.hpp"
#include "dem/model/prony_series.hpp"

namespace fiberchain::compare {
namespace {

/// Largest size of the samples from one time to another.
double largest(const TipHistory& history, double from, double to) {
  double size = 0;
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    if (history.time[i] >= from && history.time[i] < to) size = std::max(size, std::abs(history.y[i]));
  }
  return size;
}

TwoModes two_modes_of(const dem::Fiber& fiber, Damper damper, double periods) {
  constexpr double amount = 1e-6;
  const auto modes = bending_modes_of(fiber, 2);
  TwoModes found{damper, {}, 2 * std::numbers::pi / modes[0].decay.eigenvalue.imag(), modes[1].decay.damping,
                 0,      0};
  // samples count by mode 1, of which mode 2 has more than six in a period
  dem::ReleaseOptions options;
  options.samples_per_period = 1200;
  found.history = struck_history(fiber, {{modes[0], amount}, {modes[1], amount}}, periods, options);
  for (double& y : found.history.y) y /= amount;
  for (double& v : found.history.velocity) v /= amount;
  const double omega = modes[1].decay.eigenvalue.imag(), T = 2 * std::numbers::pi / omega;
  found.in_company = decay_in_company(found.history, omega, 6).ratio;
  const TipHistory alone = first_mode_part(found.history, omega);
  const double from = alone.time.front(), to = from + 2 * found.period;
  found.left = std::pow(largest(alone, to, to + T) / largest(alone, from, from + T), 1.5);
  return found;
}

WirePoint wire_point(const MetalValues& metal, double diameter, int aspect_ratio, bool marched) {
  const dem::Fiber elastic = metal_wire(metal, diameter, aspect_ratio);
  const double f = first_frequency(elastic);
  const dem::Fiber wire = with_thermoelasticity(elastic, metal, 100 * f);
  const auto mode = bending_modes_of(wire, 1).front();
  WirePoint point{metal,
                  diameter,
                  f,
                  dem::thermal_peak(dem::thermal_diffusivity(metal.thermal, metal.density), diameter / 2),
                  static_cast<int>(wire.branches.bend.size()),
                  mode.decay.damping,
                  exact_thermoelastic_modes(elastic, metal, 1).front().decay.damping,
                  std::nullopt};
  if (marched) point.marched = marched_decay(wire, mode).damping;
  return point;
}

}  // namespace

std::vector<ModePoint> mode_points(const ThreeFibers& fibers, int modes, const Jobs& jobs) {
  std::vector<ModePoint> points;
  std::vector<reference::ComplexChainMode> shapes;
  const auto exact = exact_thermoelastic_modes(fibers.elastic, fibers.metal, modes);
  for (const Damper damper : kDampers) {
    const auto own = bending_modes_of(fibers.of(damper), modes);
    for (int n = 0; n < modes; ++n) {
      points.push_back({damper, n + 1, own[n].decay, {}, std::nullopt});
      if (damper == Damper::thermoelastic) points.back().series = exact[n].decay.damping;
      shapes.push_back(own[n]);
    }
  }
  jobs.run(points.size(),
           [&](std::size_t i) { points[i].marched = marched_decay(fibers.of(points[i].damper), shapes[i]); });
  return points;
}

std::vector<TwoModes> two_modes(const ThreeFibers& fibers, double periods) {
  return {two_modes_of(fibers.viscous, Damper::viscous, periods),
          two_modes_of(fibers.flat, Damper::flat, periods)};
}

std::vector<CyclePoint> cycle_points(const ThreeFibers& fibers, const std::vector<double>& frequencies) {
  std::vector<CyclePoint> points;
  for (const Damper damper : kDampers) {
    for (const double f : frequencies) {
      const dem::Fiber& fiber = fibers.of(damper);
      points.push_back({damper, bending_loop(fiber, f), bending_loss_factor(fiber, f)});
    }
  }
  return points;
}

std::vector<WirePoint> wire_points(const WireSweep& sweep, const Jobs& jobs) {
  struct Asked {
    MetalValues metal;
    double diameter;
    bool marched;
  };
  std::vector<Asked> asked;
  for (const std::string& name : sweep.metals) {
    const MetalValues metal = metal_values(name);
    for (std::size_t i = 0; i < sweep.diameters.size(); ++i) {
      const bool marched = sweep.marched_every > 0 && i % sweep.marched_every == 1 % sweep.marched_every;
      asked.push_back({metal, sweep.diameters[i], marched});
    }
  }
  std::vector<WirePoint> points(asked.size());
  jobs.run(asked.size(), [&](std::size_t i) {
    points[i] = wire_point(asked[i].metal, asked[i].diameter, sweep.aspect_ratio, asked[i].marched);
  });
  return points;
}

std::vector<double> logarithmic_values(double first, double last, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(first * std::pow(last / first, count > 1 ? i / (count - 1.0) : 0));
  return values;
}

}  // namespace fiberchain::compare
