#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/material/study.hpp"

namespace fiberchain::compare {
namespace {

std::string label_of(const ThreeFibers& fibers, Damper damper) {
  switch (damper) {
    case Damper::viscous:
      return fmt::format("viscous: dashpots, ξ_b = {:.2g}", fibers.viscous.bond_damping);
    case Damper::flat:
      return fmt::format("flat loss factor: {} branches over 3 decades", fibers.flat.branches.bend.size());
    default:
      return fmt::format("thermoelastic: {} wire, {:.0f} µm, {} branches", fibers.metal.name,
                         1e6 * fibers.diameter, fibers.thermoelastic.branches.bend.size());
  }
}

/// tan delta of the fiber's bending times a factor.
Series loss_curve(const ThreeFibers& fibers, Damper damper, double low, double high, double factor) {
  const double f = first_frequency(fibers.elastic);
  Series curve{"", {}, {}, Mark::line, Dash::solid, static_cast<int>(damper)};
  for (const double x : logarithmic_values(low, high, 201))
    curve.add(x, factor * bending_loss_factor(fibers.of(damper), x * f));
  return curve;
}

}  // namespace

Figure mode_figure(const ThreeFibers& fibers, const std::vector<ModePoint>& points) {
  const double f = first_frequency(fibers.elastic);
  Figure figure{fmt::format("Three fibers alike in mode 1, r_f = {}: chain in time (points), tan δ/2 (lines)",
                            fibers.elastic.aspect_ratio),
                {"frequency over that of mode 1", true, std::pair{0.5, 100.0}},
                {"damping ratio ζ", true, std::pair{2e-5, 0.2}},
                {}};
  for (const Damper damper : kDampers) {
    Series curve = loss_curve(fibers, damper, 0.5, 100, 0.5);
    figure.series.push_back(std::move(curve));
    Series marks{label_of(fibers, damper), {}, {}, Mark::points, Dash::solid, static_cast<int>(damper)};
    for (const ModePoint& p : points) {
      if (p.damper == damper) marks.add(p.root.frequency / (2 * std::numbers::pi * f), p.marched.damping);
    }
    figure.series.push_back(std::move(marks));
  }
  for (const ModePoint& p : points) {
    if (p.damper != Damper::flat) continue;
    figure.annotations.push_back({p.mode == 1 ? std::string("mode 1") : fmt::format("{}", p.mode),
                                  p.root.frequency / (2 * std::numbers::pi * f), 1.7 * p.marched.damping});
  }
  return figure;
}

Figure two_mode_figure(const std::vector<TwoModes>& runs) {
  Figure figure{"Modes 1 and 2 ring down together (viscous drawn 4.5 up), ζ_1 = 0.01 in both fibers",
                {"time over the period of mode 1"},
                {"free end over mode 1's amplitude"},
                {}};
  for (const TwoModes& run : runs) {
    const bool viscous = run.damper == Damper::viscous;
    Series curve{fmt::format("{}: ζ_2 = {:.3f}", name(run.damper), run.in_company),
                 {},
                 {},
                 Mark::line,
                 Dash::solid,
                 static_cast<int>(run.damper)};
    // one below the other
    for (std::size_t i = 0; i < run.history.time.size(); i += 10) {
      if (run.history.time[i] <= 5 * run.period)
        curve.add(run.history.time[i] / run.period, run.history.y[i] + (viscous ? 4.5 : 0));
    }
    figure.series.push_back(std::move(curve));
  }
  figure.y.range = {-2.5, 7};
  return figure;
}

Figure cycle_figure(const ThreeFibers& fibers, const std::vector<CyclePoint>& points) {
  const double f = first_frequency(fibers.elastic);
  Figure figure{
      "Energy that a bond loses in a cycle of bending: bond law (points), {/:Italic K}″/{/:Italic K}′ "
      "(lines)",
      {"frequency over that of mode 1", true},
      {"loss over 2π × energy stored", true, std::pair{1e-6, 10.0}},
      {}};
  for (const Damper damper : kDampers) {
    figure.series.push_back(loss_curve(fibers, damper, 0.1, 1e3, 1));
    Series marks{label_of(fibers, damper), {}, {}, Mark::points, Dash::solid, static_cast<int>(damper)};
    for (const CyclePoint& p : points) {
      if (p.damper == damper) marks.add(p.loop.frequency / f, p.loop.loss);
    }
    figure.series.push_back(std::move(marks));
  }
  return figure;
}

Figure loop_figure(const dem::Fiber& flat, const dem::Fiber& viscous, double frequency) {
  Figure figure{"Loops of a bond bent to and fro, loss factor 0.1 at the first frequency {/:Italic f}_1",
                {"angle over its largest"},
                {"moment over that of {/:Italic f}_1 in phase"},
                {}};
  int color = 0;
  for (const auto& [fiber, label] : {std::pair{&viscous, "viscous"}, std::pair{&flat, "flat"}}) {
    const double K = bending_loop(*fiber, frequency).storage;
    for (const double x : {1.0, 3.0, 10.0}) {
      const BendingLoop loop = bending_loop(*fiber, x * frequency);
      const double largest = *std::ranges::max_element(loop.angle);
      Series curve{fmt::format("{}, {:g} {{/:Italic f}}_1: loss {:.2f}", label, x, loop.loss),
                   {},
                   {},
                   Mark::line,
                   fiber == &flat ? Dash::solid : Dash::dashed,
                   color++ % 3};
      for (std::size_t i = 0; i < loop.angle.size(); ++i)
        curve.add(loop.angle[i] / largest, loop.moment[i] / (K * largest));
      figure.series.push_back(std::move(curve));
    }
  }
  return figure;
}

Figure wire_figure(const std::vector<WirePoint>& points) {
  Figure figure{"Metal wires by their data sheets: complex root (lines), chain in time (points)",
                {"diameter (m)", true},
                {"damping ratio ζ_1", true},
                {}};
  std::vector<std::string> metals;
  for (const WirePoint& p : points) {
    if (metals.empty() || metals.back() != p.metal.name) metals.push_back(p.metal.name);
  }
  for (int color = 0; const std::string& metal : metals) {
    Series curve{metal, {}, {}, Mark::line, Dash::solid, color},
        marks{"", {}, {}, Mark::points, Dash::solid, color};
    for (const WirePoint& p : points) {
      if (p.metal.name != metal) continue;
      curve.add(p.diameter, p.root);
      if (p.marched) marks.add(p.diameter, *p.marched);
    }
    figure.series.push_back(std::move(curve)), figure.series.push_back(std::move(marks));
    ++color;
  }
  return figure;
}

Figure damped_packing_figure(const std::vector<PackingRun>& runs) {
  Figure figure{"A packing comes to rest by what damps its fibers",
                {"time (s)"},
                {"root mean square speed (m/s)", true},
                {}};
  for (const PackingRun& run : runs) {
    if (run.asked.seed != 1) continue;
    Series curve{damper_of(run.asked), {}, {}, Mark::line};
    for (const PackingSample& sample : run.history) curve.add(sample.time, sample.speed);
    figure.series.push_back(std::move(curve));
  }
  return figure;
}

}  // namespace fiberchain::compare
