#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/spacing/study.hpp"

namespace fiberchain::compare {
namespace {

/// The series of a fiber and a bond; colors are of the aspect ratio, the paper's bond is dashed.
Series& spacing_series(Figure& figure, const SpacingCase& asked) {
  const bool paper = asked.bond == dem::BondModel::paper;
  const std::string label = fmt::format("{}, {}", asked.aspect_ratio, dem::name(asked.bond));
  const std::string size = fmt::format("{}, ", asked.aspect_ratio);
  int color = 0;
  for (const Series& one : figure.series) {
    color = one.label.starts_with(size) ? one.color.value_or(0) : std::max(color, one.color.value_or(0) + 1);
    if (one.label.starts_with(size)) break;
  }
  return series_like(figure,
                     {label, {}, {}, Mark::line_and_points, paper ? Dash::dashed : Dash::solid, color});
}

Figure spacing_figure(std::string title, std::string quantity) {
  Figure figure{.title = std::move(title),
                .x = {.label = "number of bonds", .logarithmic = true},
                .y = {.label = std::move(quantity), .logarithmic = true},
                .series = {}};
  figure.legend_title = "{/:Italic r_f}, bond";
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> spacing_figures(const std::vector<SpacingPoint>& points) {
  if (points.empty()) return {};
  const double load = points.front().asked.load, poisson_ratio = points.front().asked.poisson_ratio;
  Figure statics = spacing_figure(
      fmt::format("Fibers cut into longer bonds, P{{/:Italic L}}^2/({{/:Italic EI}}) = {:g}", load),
      "free end's distance from the Elastica over {/:Italic L}");
  Figure mode = spacing_figure("Fibers cut into longer bonds: first mode",
                               "relative error of the first natural frequency");
  for (const SpacingPoint& point : points) {
    if (point.status != "converged" || point.asked.load != load || point.asked.poisson_ratio != poisson_ratio)
      continue;
    spacing_series(statics, point.asked).add(point.bonds, point.distance);
    spacing_series(mode, point.asked).add(point.bonds, std::abs(point.frequency_error));
  }
  return {{"spacing-statics", std::move(statics)}, {"spacing-mode", std::move(mode)}};
}

}  // namespace fiberchain::compare
