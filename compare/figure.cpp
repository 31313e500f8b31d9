#include "compare/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/errors.hpp"
#include "compare/figure_metadata.hpp"
#include "compare/gnuplot.hpp"

namespace fiberchain::compare {
namespace {

// Okabe and Ito's colors, told apart with every kind of color vision.
constexpr std::array kDistinct = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#e69f00", "#56b4e9", "#7f7f7f", "#000000"};
// Steps of viridis without its palest end, which white paper swallows.
constexpr std::array kOrdered = {"#440154", "#46327e", "#365c8d", "#277f8e",
                                 "#1fa187", "#4ac16d", "#8bc83f", "#d0bb1e"};
constexpr std::array kPointTypes = {7, 5, 9, 13, 11, 6, 4, 8};  // filled first, then open

std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? "''" : std::string(1, c == '\n' ? ' ' : c);
  return safe + "'";
}

/// Place of a series in the palette.
std::size_t place_of(const Figure& figure, std::size_t i) {
  return static_cast<std::size_t>(figure.series[i].color.value_or(static_cast<int>(i)));
}

std::string color_of(const Figure& figure, std::size_t i) {
  const std::size_t place = place_of(figure, i);
  if (!figure.ordered) return kDistinct[place % kDistinct.size()];
  std::size_t last = 1;
  for (std::size_t k = 0; k < figure.series.size(); ++k) last = std::max(last, place_of(figure, k));
  return kOrdered[place * (kOrdered.size() - 1) / last];
}

std::string_view with(Mark mark) {
  switch (mark) {
    case Mark::line:
      return "lines";
    case Mark::points:
      return "points";
    case Mark::line_and_points:
      return "linespoints";
  }
  throw FigureError("no such mark");
}

std::string_view dash_type(Dash dash) {
  switch (dash) {
    case Dash::solid:
      return "solid";
    case Dash::dashed:
      return "(12,7)";
    case Dash::dotted:
      return "(2,5)";
  }
  throw FigureError("no such dash");
}

std::string data_of(const Series& series) {
  if (series.x.size() != series.y.size()) throw FigureError("series '" + series.label + "': x and y differ in length");
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const bool finite = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
    text += finite ? fmt::format("{} {}\n", series.x[i], series.y[i]) : "NaN NaN\n";
  }
  return text;
}

std::string axis_commands(char name, const Axis& axis) {
  std::string text = fmt::format("set {}label {}\n", name, quoted(axis.label));
  if (axis.logarithmic) text += fmt::format("set logscale {0}\nset m{0}tics 10\nset format {0} '10^{{%T}}'\n", name);
  if (axis.range) text += fmt::format("set {}range [{}:{}]\n", name, axis.range->first, axis.range->second);
  return text;
}

std::string plot_command(const Figure& figure) {
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    const std::string title = series.label.empty() ? "notitle" : "title " + quoted(series.label);
    curves.push_back(fmt::format("$d{} with {} lc rgb '{}' lw 1.8 dt {} pt {} ps 0.75 {}", i, with(series.mark),
                                 color_of(figure, i), dash_type(series.dash),
                                 kPointTypes[place_of(figure, i) % kPointTypes.size()], title));
  }
  return fmt::format("plot {}\n", fmt::join(curves, ", \\\n     "));
}

/// Everything but the terminal: quiet grid, thin gray frame, legend outside the axes.
std::string commands(const Figure& figure) {
  std::string text = "set encoding utf8\n";
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    text += fmt::format("$d{} << EOD\n{}EOD\n", i, data_of(figure.series[i]));
  }
  text +=
      "set border 3 lc rgb '#444444' lw 1\nset tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
      "set grid lc rgb '#d8d8d8' lw 1 dt solid\nset bmargin 3.6\nset key outside right top Left reverse samplen 2.2 spacing 1.25\n";
  text += fmt::format("set title {} font ',15' offset 0,-0.2\n", quoted(figure.title));
  if (!figure.legend_title.empty()) text += fmt::format("set key title {} left\n", quoted(figure.legend_title));
  text += axis_commands('x', figure.x) + axis_commands('y', figure.y);
  for (const Annotation& note : figure.annotations) {
    text += fmt::format("set label {} at {},{} textcolor rgb '#444444' front\n", quoted(note.text), note.x, note.y);
  }
  return text + plot_command(figure);
}

}  // namespace

std::string to_svg(const Figure& figure, const Provenance& provenance) {
  const std::string terminal =
      "set terminal svg size 800,500 dynamic enhanced font 'DejaVu Sans,Helvetica,sans-serif,13' background 'white'\n";
  return with_svg_metadata(run_gnuplot(terminal + commands(figure)), provenance);
}

std::string to_png(const Figure& figure, const Provenance& provenance) {
  const std::string terminal =
      "set terminal pngcairo size 1600,1000 enhanced font 'DejaVu Sans,13' fontscale 2 linewidth 2 pointscale 2 "
      "background rgb 'white'\n";
  return with_png_metadata(run_gnuplot(terminal + commands(figure)), provenance);
}

std::vector<OutputFile> figure_files(const std::string& name, const Figure& figure, const Provenance& provenance) {
  return {{name + ".svg", to_svg(figure, provenance)}, {name + ".png", to_png(figure, provenance)}};
}

}  // namespace fiberchain::compare
