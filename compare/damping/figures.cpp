#include <fmt/format.h>
#include <cmath>
#include <functional>
#include <map>

#include "compare/damping/table.hpp"
#include "compare/measure/ring_down_release.hpp"

namespace fiberchain::compare {
namespace {

using DampingValue = std::function<double(const DampingPoint&)>;

Series series(std::string label, const DampingPoints& points, const DampingValue& x, const DampingValue& y,
              Mark mark = Mark::line_and_points, Dash dash = Dash::solid) {
  Series s{std::move(label), {}, {}, mark, dash};
  for (const DampingPoint& p : points) s.add(x(p), y(p));
  return s;
}

double measured_damping(const DampingPoint& p) { return p.damping; }
double as_paper(const DampingPoint& p) { return p.damping_paper; }

Figure ring_down_figure(const dem::Table& table) {
  Series chain{"sphere chain", {}, {}, Mark::points}, elastica{"damped Elastica", {}, {}, Mark::line};
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    elastica.add(table.number(row, "time"), table.number(row, "elastica_y"));
    if (row % 3 != 0) continue;
    chain.add(table.number(row, "time"), table.number(row, "chain_y"));
  }
  return {"Fig 6: free end after the release, r_f = 10, ξ_b = 1, {/:Italic P L}^2/{/:Italic EI} = 1",
          {"time over the first mode's period"},
          {"{/:Italic y}({/:Italic t})/{/:Italic y}_{max}"},
          {elastica, chain}};
}

Figure bond_damping_figure(const DampingPoints& points) {
  std::map<std::pair<int, double>, DampingPoints> groups;
  for (const DampingPoint& p : points) groups[{p.asked.aspect_ratio, p.asked.load}].push_back(p);
  Figure figure{"Fig 7: damping of the fiber against damping of the bonds", {"ξ_b", true}, {"ξ_f", true}, {}};
  const DampingValue x = [](const DampingPoint& p) { return p.asked.bond_damping; };
  for (const auto& [kind, group] : groups) {
    const bool small = kind.second <= largest_mode_release_load;
    figure.series.push_back(
        series(fmt::format("r_f = {}, {}", kind.first, small ? "small load" : "P = 0.02 N"), group, x,
               measured_damping, small ? Mark::line_and_points : Mark::points));
  }
  DampingPoints eight;
  for (const DampingPoint& p : points)
    if (p.asked.load <= largest_mode_release_load) eight.push_back(p);
  for (const int aspect_ratio : {8, 10}) {
    Series slope{fmt::format("paper's slope, r_f = {}", aspect_ratio), {}, {}, Mark::line, Dash::dashed};
    for (const DampingPoint& p : eight) {
      if (p.asked.aspect_ratio != aspect_ratio) continue;
      slope.add(p.asked.bond_damping, (aspect_ratio == 8 ? 0.01045 : 0.00698) * p.asked.bond_damping);
    }
    figure.series.push_back(slope);
  }
  return figure;
}

Figure load_figure(const DampingPoints& points) {
  const DampingValue x = [](const DampingPoint& p) {
    return dem::load_force(damped_fiber(p.asked), p.asked.load);
  };
  return {"Fig 8: damping of the fiber against load, r_f = 10, ξ_b = 1",
          {"{/:Italic P} (N)"},
          {"ξ_f"},
          {series("chain, mode 2 gone", points, x, measured_damping),
           series(fmt::format("chain, peaks {}..{}", points[0].asked.peaks.first, points[0].asked.peaks.last),
                  points, x, as_paper),
           series(
               "damped Elastica", points, x, [](const DampingPoint& p) { return p.damping_elastica; },
               Mark::line, Dash::dashed),
           series(
               "linear chain", points, x, [](const DampingPoint& p) { return p.damping_modes; }, Mark::line,
               Dash::dotted)}};
}

Figure modulus_figure(const DampingPoints& points) {
  const DampingValue x = [](const DampingPoint& p) {
    return damped_fiber(p.asked).material.shear_modulus / 1e6;
  };
  return {"Fig 8: damping of the fiber against shear modulus, P = 0.002 N, r_f = 10, ξ_b = 1",
          {"{/:Italic G} (MPa)"},
          {"ξ_f"},
          {series("chain, mode 2 gone", points, x, measured_damping),
           series(fmt::format("chain, peaks {}..{}", points[0].asked.peaks.first, points[0].asked.peaks.last),
                  points, x, as_paper)}};
}

Figure aspect_ratio_figure(const DampingPoints& points) {
  const DampingValue x = [](const DampingPoint& p) { return static_cast<double>(p.asked.aspect_ratio); };
  return {"Fig 9: damping of the fiber against aspect ratio, ξ_b = 1",
          {"{/:Italic r_f}", true},
          {"ξ_f", true},
          {series("sphere chain", points, x, measured_damping, Mark::points),
           series(
               "(β_1^2/√20) ξ_b/(r_f + 1/2)^2", points, x,
               [](const DampingPoint& p) { return p.damping_closed_form; }, Mark::line),
           series(
               "paper's Eq 20, an exponential", points, x,
               [](const DampingPoint& p) { return p.damping_eq20; }, Mark::line, Dash::dashed)}};
}

}  // namespace

std::vector<std::pair<std::string, Figure>> damping_figures(const DampingFigurePoints& points,
                                                            const dem::Table& ring_down) {
  return {{"fig-6", ring_down_figure(ring_down)},
          {"fig-7", bond_damping_figure(points.bond_damping)},
          {"fig-8-load", load_figure(points.load)},
          {"fig-8-modulus", modulus_figure(points.modulus)},
          {"fig-9", aspect_ratio_figure(points.aspect_ratio)}};
}

}  // namespace fiberchain::compare
