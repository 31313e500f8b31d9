#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flow/regimes.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

constexpr int regime_spheres[] = {21, 41, 101};
constexpr int drawn_spheres = 101;
constexpr double regime_numbers[] = {100, 300, 600, 800, 1000, 1200, 1500, 2000, 2500, 3000, 5000,
                                     1e4, 2e4, 5e4, 1e5, 3e5,  1e6,  2e6,  3e6,  5e6,  1e7};
/// Largest number: tension over E A grows as number/(256 N^2), and the chain is none beyond.
constexpr double kStretch = 4;
constexpr int kFrames = 9;

dem::Table table_of(const std::vector<RegimePoint>& points) {
  return tabulate(points, [&](const RegimePoint& p) -> dem::NamedRow {
    return {{"aspect_ratio", std::int64_t{p.asked.spheres - 1}},
            {"spheres", std::int64_t{p.asked.spheres}},
            {"elasto_viscous", p.asked.elasto_viscous},
            {"regime", std::string(name(p.regime))},
            {"end_to_end_least", p.end_to_end_least},
            {"gradient_extent", p.gradient_extent},
            {"direction_span", p.direction_span},
            {"stretch", p.stretch},
            {"inflections", std::int64_t{p.inflections}},
            {"half_turns", std::int64_t{p.half_turns}},
            {"axis_half_turns", std::int64_t{p.axis_half_turns}},
            {"period", dem::known(p.period)},
            {"run_time", p.run_time},
            {"status", p.status}};
  });
}

Figure extent_figure(const std::vector<RegimePoint>& points) {
  Figure figure{"Fibers that turn over in shear, free draining: how far they bend",
                {"3πμ rate {/:Italic L}^4/{/:Italic EI}", true},
                {"least end-to-end distance/{/:Italic L}"},
                {}};
  for (const int N : regime_spheres) {
    Series s{fmt::format("N = {}", N), {}, {}};
    for (const RegimePoint& p : points) {
      if (p.asked.spheres == N) s.add(p.asked.elasto_viscous, p.end_to_end_least);
    }
    figure.series.push_back(std::move(s));
  }
  return figure;
}

/// A row of shapes in time for each regime, the stiffest above.
Figure shapes_figure(const std::vector<RegimePoint>& points) {
  Figure figure{fmt::format("How a fiber of {} spheres turns over in shear; time runs from left to right",
                            drawn_spheres),
                {""},
                {""},
                {}};
  figure.equal_axes = true;
  figure.legend_title = "3πμ rate {/:Italic L}^4/{/:Italic EI}";
  double y = 0;
  int color = 0;
  for (const Regime regime :
       {Regime::rigid, Regime::springy, Regime::c_shaped, Regime::snake_turn, Regime::coil}) {
    // one of the stiffer cases of the regime
    std::vector<const RegimePoint*> those;
    for (const RegimePoint& p : points) {
      if (p.asked.spheres == drawn_spheres && p.regime == regime && !p.turning.empty()) those.push_back(&p);
    }
    if (those.empty()) continue;
    const RegimePoint& p = *those[those.size() / 3];
    for (int k = 0; k < kFrames; ++k) {
      const FlowShape& shape =
          p.turning[static_cast<std::size_t>(k) * (p.turning.size() - 1) / (kFrames - 1)];
      double mean_x = 0, mean_y = 0;
      for (const Triple& at : shape.spheres) {
        mean_x += at[0] / static_cast<double>(shape.spheres.size());
        mean_y += at[1] / static_cast<double>(shape.spheres.size());
      }
      Series s{
          k == 0 ? fmt::format("{:g}", p.asked.elasto_viscous) : "", {}, {}, Mark::line, Dash::solid, color};
      for (const Triple& at : shape.spheres) s.add(at[0] - mean_x + 1.05 * k, at[1] - mean_y - y);
      figure.series.push_back(std::move(s));
    }
    figure.annotations.push_back(
        {fmt::format("{}, strain {:.1f}", name(regime), p.turning.back().time - p.turning.front().time), -0.5,
         -y + 0.55});
    y += 1.15;
    ++color;
  }
  figure.y.range = std::pair{-y + 0.5, 0.8};
  figure.x.range = std::pair{-0.7, 1.05 * (kFrames - 1) + 0.7};
  return figure;
}

}  // namespace

FlowStudy regime_study(const OrbitOptions& options) {
  std::vector<RegimeCase> cases;
  for (const int N : regime_spheres) {
    for (const double number : regime_numbers) {
      if (number / (256.0 * N * N) < kStretch) cases.push_back({.spheres = N, .elasto_viscous = number});
    }
  }
  const std::vector<RegimePoint> points = regime_points(cases, options);
  const auto failed =
      std::ranges::count_if(points, [](const RegimePoint& p) { return p.status != "finished"; });
  return {.table = table_of(points),
          .figures = {{"shear-regimes", extent_figure(points)}, {"shear-shapes", shapes_figure(points)}},
          .failed = static_cast<int>(failed)};
}

}  // namespace fiberchain::compare
