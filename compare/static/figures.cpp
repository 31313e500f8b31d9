#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "compare/static/table.hpp"
#include "reference/elastica.hpp"
#include "reference/small_deflection.hpp"

namespace fiberchain::compare {
namespace {

using StaticPoints = std::vector<StaticPoint>;

/// The kind of point that the figures show: as the first one, so that a sweep over methods draws one of them.
bool same_kind(const StaticCase& a, const StaticCase& b) {
  return a.bond == b.bond && a.method == b.method && a.form == b.form && a.dimension == b.dimension &&
         a.poisson_ratio == b.poisson_ratio;
}

/// StaticPoints of the first kind by aspect ratio.
std::map<int, StaticPoints> by_aspect_ratio(const StaticPoints& points) {
  std::map<int, StaticPoints> groups;
  for (const StaticPoint& p : points) {
    if (same_kind(p.asked, points[0].asked)) groups[p.asked.aspect_ratio].push_back(p);
  }
  return groups;
}

/// 10 as in the paper's Fig 3 if it is there, else the first.
const StaticPoints& shown_aspect_ratio(const std::map<int, StaticPoints>& groups) {
  const auto ten = groups.find(10);
  return ten != groups.end() ? ten->second : groups.begin()->second;
}

std::string kind_of(const StaticCase& c) {
  return fmt::format(
      "{} bond, ν = {:g}, {}", dem::name(c.bond), c.poisson_ratio,
      c.method == StaticMethod::solve ? "solved" : fmt::format("marched ({} form)", dem::name(c.form)));
}

Series series(std::string label, const StaticPoints& points,
              const std::function<double(const StaticPoint&)>& value, Mark mark = Mark::line_and_points) {
  Series s{std::move(label), {}, {}, mark};
  for (const StaticPoint& p : points) s.add(p.asked.load, value(p));
  return s;
}

/// y / L against load, by a formula, over the range of the points.
Series theory(std::string label, const StaticPoints& points, const std::function<double(double)>& value,
              Dash dash) {
  Series s{std::move(label), {}, {}, Mark::line, dash};
  const double last = points.back().asked.load;
  constexpr int n = 80;
  for (int i = 1; i <= n; ++i) {
    const double load = last * i / n;
    s.add(load, value(load));
  }
  return s;
}

Figure deflection_figure(const StaticPoints& points) {
  const StaticCase& c = points[0].asked;
  return {fmt::format("Fig 3: deflection of the free end, r_f = {}, {}", c.aspect_ratio, kind_of(c)),
          {"{/:Italic P L}^2/{/:Italic EI}"},
          {"{/:Italic y}_{max}/{/:Italic L}", false, std::pair{0.0, 1.0}},
          {theory(
               "large deflection (Elastica)", points,
               [](double load) { return reference::elastica_shooting(load).y; }, Dash::solid),
           theory(
               "small deflection (Eq 12)", points, [](double load) { return load / 3; }, Dash::dashed),
           series(
               "sphere chain", points, [](const StaticPoint& p) { return p.tip.y; }, Mark::points)}};
}

Figure departure_figure(const std::map<int, StaticPoints>& groups) {
  const StaticCase& c = groups.begin()->second[0].asked;
  Figure figure{"Fig 4: departure of the deflection from the Elastica, " + kind_of(c),
                {"{/:Italic P L}^2/{/:Italic EI}"},
                {"departure of {/:Italic y}_{max} (%)", true},
                {}};
  for (const auto& [aspect_ratio, points] : groups) {
    figure.series.push_back(series(fmt::format("{}", aspect_ratio), points,
                                   [](const StaticPoint& p) { return 100 * std::abs(p.departure.y); }));
  }
  figure.legend_title = "r_f";
  figure.ordered = true;
  return figure;
}

Figure budget_figure(const StaticPoints& points) {
  const StaticCase& c = points[0].asked;
  const auto percent = [](auto part) { return [part](const StaticPoint& p) { return 100 * part(p); }; };
  Figure figure{fmt::format("What the departure consists of, r_f = {}, {}", c.aspect_ratio, kind_of(c)),
                {"{/:Italic P L}^2/{/:Italic EI}"},
                {"part of the departure of {/:Italic y}_{max} (%)"},
                {series("whole", points, percent([](const StaticPoint& p) { return p.departure.y; })),
                 series("shear", points, percent([](const StaticPoint& p) { return p.budget.shear.y; })),
                 series("stretch", points, percent([](const StaticPoint& p) { return p.budget.stretch.y; })),
                 series("finite bonds", points,
                        percent([](const StaticPoint& p) { return p.budget.discretization.y; }))}};
  if (c.form == dem::BondForm::incremental) {
    figure.series.push_back(
        series("incremental form", points, percent([](const StaticPoint& p) { return p.budget.history.y; })));
    figure.series.push_back(
        series("time step", points, percent([](const StaticPoint& p) { return p.budget.time_step.y; })));
  }
  return figure;
}

Figure order_figure(const dem::Table& orders) {
  Figure figure{"Distance of the free end from the Elastica against aspect ratio",
                {"{/:Italic r_f}", true},
                {"|Δ{/:Italic r}|/{/:Italic L}", true},
                {}};
  std::map<std::string, Series> curves;
  std::vector<std::string> labels;
  const auto add = [&](const std::string& label, double x, double y, Dash dash) {
    if (!curves.contains(label)) {
      labels.push_back(label);
      curves[label] = Series{label, {}, {}, Mark::line_and_points, dash};
    }
    curves[label].add(x, y);
  };
  for (std::size_t row = 0; row < orders.rows().size(); ++row) {
    const double x = orders.number(row, "aspect_ratio"), load = orders.number(row, "load");
    const std::string bond = orders.text(row, "bond");
    const std::string label = fmt::format("{} bond, {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}", bond, load);
    add(label, x, orders.number(row, "departure_distance"), Dash::solid);
    if (bond == "corrected") {
      add(label + ", stretch excluded", x, orders.number(row, "departure_distance_unstretched"),
          Dash::dashed);
    }
  }
  for (const std::string& label : labels) figure.series.push_back(curves[label]);
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> static_figures(const StaticPoints& points,
                                                           const dem::Table& orders) {
  const std::map<int, StaticPoints> groups = by_aspect_ratio(points);
  const StaticPoints& shown = shown_aspect_ratio(groups);
  return {{"fig-3", deflection_figure(shown)},
          {"fig-4", departure_figure(groups)},
          {"static-budget", budget_figure(shown)},
          {"static-order", order_figure(orders)}};
}

}  // namespace fiberchain::compare
