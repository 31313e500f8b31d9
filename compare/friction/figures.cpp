#include <fmt/format.h>
#include <functional>

#include "compare/friction/table.hpp"

namespace fiberchain::compare {
namespace {

using RollingValue = std::function<double(const RollingPoint&)>;

constexpr double figure_load = 3;

RollingPoints where(const RollingPoints& points, const std::function<bool(const RollingCase&)>& wanted) {
  RollingPoints chosen;
  for (const RollingPoint& p : points) {
    if (wanted(p.asked)) chosen.push_back(p);
  }
  return chosen;
}

Series series(std::string label, const RollingPoints& points, const RollingValue& x, const RollingValue& y,
              int color, Mark mark = Mark::line_and_points, Dash dash = Dash::solid) {
  Series s{std::move(label), {}, {}, mark, dash, color};
  for (const RollingPoint& p : points) s.add(x(p), y(p));
  return s;
}

double rolling_friction(const RollingPoint& p) { return p.asked.rolling_friction; }
double measured_damping(const RollingPoint& p) { return p.damping; }
double as_bond(const RollingPoint& p) { return p.as_bond; }

Axis friction_axis() { return {"ξ_r"}; }
Axis damping_axis(bool logarithmic) { return {"ξ_f", logarithmic}; }

Figure aspect_ratio_figure(const RollingPoints& points) {
  Figure figure{
      "Fig 10: damping of the fiber against rolling friction, ξ_b = 1, {/:Italic P L}^2/{/:Italic "
      "EI} = 3",
      friction_axis(),
      damping_axis(true),
      {}};
  int color = 0;
  for (const int aspect_ratio : {10, 20, 30}) {
    const RollingPoints group = where(points, [&](const RollingCase& c) {
      return c.aspect_ratio == aspect_ratio && c.load == figure_load;
    });
    figure.series.push_back(
        series(fmt::format("r_f = {}", aspect_ratio), group, rolling_friction, measured_damping, color));
    figure.series.push_back(series(fmt::format("r_f = {}, if ξ_r acted as ξ_b", aspect_ratio), group,
                                   rolling_friction, as_bond, color, Mark::line, Dash::dashed));
    ++color;
  }
  return figure;
}

Figure step_figure(const RollingPoints& points) {
  Figure figure{"Fig 10: law and time step, r_f = 30, ξ_b = 1, {/:Italic P L}^2/{/:Italic EI} = 3",
                friction_axis(),
                damping_axis(false),
                {}};
  int color = 0;
  for (const double step : {0.1, 0.03, 0.01}) {
    const auto by = [&](dem::Rolling law) {
      return where(points, [&](const RollingCase& c) {
        return c.aspect_ratio == 30 && c.load == figure_load && c.law == law && c.step_ratio == step;
      });
    };
    if (step == 0.1) {
      figure.series.push_back(series("set-valued, 0.1 {/:Italic t_b}", by(dem::Rolling::set_valued),
                                     rolling_friction, measured_damping, color++, Mark::line));
      figure.series.push_back(series("if ξ_r acted as ξ_b", by(dem::Rolling::set_valued), rolling_friction,
                                     as_bond, color++, Mark::line, Dash::dashed));
    }
    figure.series.push_back(series(fmt::format("explicit sign, {} {{/:Italic t_b}}", step),
                                   by(dem::Rolling::explicit_sign), rolling_friction, measured_damping,
                                   color++));
  }
  figure.series.push_back(series("set-valued, 0.03 {/:Italic t_b}",
                                 where(points,
                                       [](const RollingCase& c) {
                                         return c.aspect_ratio == 30 && c.load == figure_load &&
                                                c.law == dem::Rolling::set_valued && c.step_ratio == 0.03;
                                       }),
                                 rolling_friction, measured_damping, color, Mark::points));
  return figure;
}

Figure load_figure(const RollingPoints& points) {
  Figure figure{
      "Rolling friction at several loads, r_f = 30, ξ_b = 1", friction_axis(), damping_axis(false), {}};
  int color = 0;
  for (const double load : {3.0, 1.0, 0.3}) {
    const RollingPoints group =
        where(points, [&](const RollingCase& c) { return c.aspect_ratio == 30 && c.load == load; });
    figure.series.push_back(series(fmt::format("{{/:Italic P L}}^2/{{/:Italic EI}} = {}", load), group,
                                   rolling_friction, measured_damping, color++));
    if (load == 0.3) {
      figure.series.push_back(
          series("if ξ_r acted as ξ_b", group, rolling_friction, as_bond, color, Mark::line, Dash::dashed));
    }
  }
  return figure;
}

Figure amplitude_figure(const RollingPoints& points) {
  Figure figure{"Damping against amplitude, ξ_b = 1: chain (points), linear mode (lines)",
                {"deflection {/:Italic a}/{/:Italic L} of the first mode let go from", true},
                damping_axis(true),
                {}};
  const RollingValue x = [](const RollingPoint& p) { return *p.asked.amplitude; };
  int color = 0;
  for (const int aspect_ratio : {10, 30}) {
    for (const double xi_r : {0.0, 1.0, 4.0}) {
      const RollingPoints group = where(points, [&](const RollingCase& c) {
        return c.aspect_ratio == aspect_ratio && c.rolling_friction == xi_r;
      });
      figure.series.push_back(series(fmt::format("r_f = {}, ξ_r = {}", aspect_ratio, xi_r), group, x,
                                     measured_damping, color, Mark::points));
      figure.series.push_back(series(
          "", group, x, [](const RollingPoint& p) { return p.weak; }, color, Mark::line));
      ++color;
    }
  }
  return figure;
}

Figure decay_figure(const RollingPoints& points) {
  Figure figure{"Decay of the peaks, r_f = 30, ξ_b = 1, {/:Italic P L}^2/{/:Italic EI} = 3",
                {"peak"},
                {"height over that of the release", true},
                {}};
  for (const RollingPoint& p : points) {
    Series s{fmt::format("ξ_r = {}", p.asked.rolling_friction), {}, {}};
    for (std::size_t j = 0; j < p.peaks.size(); ++j)
      s.add(static_cast<double>(j), p.peaks[j].value / p.peaks[0].value);
    figure.series.push_back(s);
  }
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> rolling_figures(const RollingFigurePoints& points) {
  return {{"fig-10", aspect_ratio_figure(points.friction)},
          {"fig-10-step", step_figure(points.step)},
          {"fig-10-load", load_figure(points.friction)},
          {"friction-amplitude", amplitude_figure(points.amplitude)},
          {"friction-decay", decay_figure(points.decay)}};
}

}  // namespace fiberchain::compare
