#include "compare/figures/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/figures/figure_metadata.hpp"
#include "compare/figures/gnuplot.hpp"
#include "compare/figures/heat_map.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

// Okabe and Ito's colors, told apart with every kind of color vision; more than these are dashed, too.
constexpr std::array kDistinct = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                  "#56b4e9", "#7f7f7f", "#000000", "#7a3b10", "#6a3d9a",
                                  "#a1c520", "#e0218a", "#004d40", "#b8a0e8"};
constexpr std::size_t kOkabeIto = 8;
// Steps of viridis without its palest end, which white paper swallows.
constexpr std::array kOrdered = {"#440154", "#46327e", "#365c8d", "#277f8e",
                                 "#1fa187", "#4ac16d", "#8bc83f", "#d0bb1e"};
constexpr std::array kPointTypes = {7, 5, 9, 13, 11, 6, 4, 8};  // filled first, then open

/// @throws FigureError for letters of the Symbol font, which browsers show as Latin ones: Greek is Unicode
std::string quoted(const std::string& text) {
  if (text.find("/Symbol") != std::string::npos)
    throw FigureError("Greek as Unicode, not of a font: " + text);
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
    case Mark::band:
      return "filledcurves";
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

Dash dash_of(const Figure& figure, std::size_t i) {
  const Dash given = figure.series[i].dash;
  return given == Dash::solid && !figure.ordered && place_of(figure, i) >= kOkabeIto ? Dash::dashed : given;
}

/// Points that are not finite are left out of a band: it has no line to interrupt.
std::string band_data(const Series& series) {
  if (series.y_low.size() != series.x.size())
    throw FigureError("band '" + series.label + "': x and y_low differ in length");
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = series.x[i], low = series.y_low[i], high = series.y[i];
    if (std::isfinite(x) && std::isfinite(low) && std::isfinite(high))
      text += fmt::format("{} {} {}\n", x, low, high);
  }
  return text;
}

std::string data_of(const Series& series) {
  if (series.x.size() != series.y.size())
    throw FigureError("series '" + series.label + "': x and y differ in length");
  if (series.mark == Mark::band) return band_data(series);
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const bool finite = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
    text += finite ? fmt::format("{} {}\n", series.x[i], series.y[i]) : "NaN NaN\n";
  }
  return text;
}

/// Finite values of one coordinate, above 0 where the axis is logarithmic: lowest and highest.
std::optional<std::pair<double, double>> extent(const Figure& figure, std::vector<double> Series::*coordinate,
                                                bool logarithmic) {
  std::optional<std::pair<double, double>> found;
  const auto take = [&](double value) {
    if (!std::isfinite(value) || (logarithmic && !(value > 0))) return;
    if (!found) found = {value, value};
    found = {std::min(found->first, value), std::max(found->second, value)};
  };
  for (const Series& series : figure.series) {
    std::ranges::for_each(series.*coordinate, take);
    if (coordinate == &Series::y) std::ranges::for_each(series.y_low, take);
  }
  return found;
}

/// "'0.02' 0.02" or, on an axis where the zeros would be many, "'2·10^{-5}' 2e-05".
std::string logarithmic_tick(double digit, double power, bool plain) {
  if (plain) return fmt::format("'{0:.6g}' {0:.6g}", digit * power);
  const std::string factor = digit == 1 ? "" : fmt::format("{:g}·", digit);
  return fmt::format("'{}10^{{{:.0f}}}' {:.6g}", factor, std::log10(power), digit * power);
}

/// Ticks of a logarithmic axis: powers of ten, or 1, 2, 5, 10 ... where it spans few of them.
std::string logarithmic_ticks(char name, double low, double high) {
  std::string text = fmt::format("set logscale {0}\nset m{0}tics 10\nset format {0} '10^{{%T}}'\n", name);
  if (high / low > 3000) return text;
  std::vector<std::string> ticks;
  const bool plain = low > 5e-4 && high < 1e5;
  for (double power = std::pow(10, std::floor(std::log10(low))); power <= high; power *= 10) {
    for (const double digit : {1, 2, 5}) ticks.push_back(logarithmic_tick(digit, power, plain));
  }
  return text + fmt::format("set {0}tics ({1})\n", name, fmt::join(ticks, ", "));
}

std::string axis_commands(char name, const Axis& axis, std::optional<std::pair<double, double>> data) {
  // a little nearer to the axis than usual: the legend may stand below
  std::string text =
      fmt::format("set {}label {}{}\n", name, quoted(axis.label), name == 'x' ? " offset 0,0.35" : "");
  auto range = axis.range;
  if (axis.logarithmic && data) {
    if (!range) range = {data->first / 1.25, data->second * 1.25};
    text += logarithmic_ticks(name, range->first, range->second);
  }
  if (range) text += fmt::format("set {}range [{}:{}]\n", name, range->first, range->second);
  return text;
}

/// Letters of a label as drawn: enhanced notation left out.
std::size_t drawn_length(const std::string& label) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] == '{' && i + 1 < label.size() && label[i + 1] == '/') {
      i = std::min(label.find(' ', i), label.size() - 1);
    } else if (std::string_view("{}^_").find(label[i]) == std::string_view::npos &&
               (static_cast<unsigned char>(label[i]) & 0xc0) != 0x80) {
      ++length;
    }
  }
  return length;
}

/// Beside the axes if its labels are short, else below them.
std::string legend_commands(const Figure& figure) {
  std::size_t longest = drawn_length(figure.legend_title);
  for (const Series& series : figure.series) longest = std::max(longest, drawn_length(series.label));
  const bool beside = longest <= 16;
  std::string text =
      beside ? "set key outside right top" : "set key outside bottom center horizontal maxcols 2";
  text += " Left reverse samplen 2.2 spacing 1.25 font ',11'\n";
  if (!figure.legend_title.empty())
    text += fmt::format("set key title {} left\n", quoted(figure.legend_title));
  return text;
}

std::string band_command(const Figure& figure, std::size_t i, const std::string& title) {
  return fmt::format("$d{} using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid 0.22 noborder {}",
                     i, color_of(figure, i), title);
}

std::string plot_command(const Figure& figure) {
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    const std::string title = series.label.empty() ? "notitle" : "title " + quoted(series.label);
    if (series.mark == Mark::band) {
      curves.push_back(band_command(figure, i, title));
      continue;
    }
    curves.push_back(fmt::format("$d{} with {} lc rgb '{}' lw 1.8 dt {} pt {} ps 0.75 {}", i,
                                 with(series.mark), color_of(figure, i), dash_type(dash_of(figure, i)),
                                 kPointTypes[place_of(figure, i) % kPointTypes.size()], title));
  }
  return fmt::format("plot {}\n", fmt::join(curves, ", \\\n     "));
}

/// Everything but the terminal: quiet grid, thin gray frame, title at the left, legend outside the axes.
std::string commands(const Figure& figure) {
  std::string text = "set encoding utf8\n";
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    text += fmt::format("$d{} << EOD\n{}EOD\n", i, data_of(figure.series[i]));
  }
  text +=
      "set border 3 lc rgb '#444444' lw 1\nset tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
      "set grid lc rgb '#d8d8d8' lw 1 dt solid\n";
  text +=
      figure.title.empty()
          ? "set tmargin 1.2\n"
          : fmt::format("set tmargin 3.2\nset label {} at screen 0.02, screen 0.955 left font ',14' front\n",
                        quoted(figure.title));
  if (figure.map) return text + heat_map_commands(*figure.map, figure.x.label, figure.y.label);
  text += legend_commands(figure);
  text += axis_commands('x', figure.x, extent(figure, &Series::x, figure.x.logarithmic));
  text += axis_commands('y', figure.y, extent(figure, &Series::y, figure.y.logarithmic));
  if (figure.equal_axes) text += "set size ratio -1\n";
  for (const Annotation& note : figure.annotations) {
    text += fmt::format("set label {} at {},{} textcolor rgb '#444444' front\n", quoted(note.text), note.x,
                        note.y);
  }
  return text + plot_command(figure);
}

}  // namespace

std::string to_svg(const Figure& figure, const dem::Provenance& provenance) {
  const std::string terminal =
      "set terminal svg size 800,500 dynamic enhanced font 'DejaVu Sans,Helvetica,sans-serif,12' background "
      "'white'\n";
  return with_svg_metadata(run_gnuplot(terminal + commands(figure)), provenance);
}

std::string to_png(const Figure& figure, const dem::Provenance& provenance) {
  const std::string terminal =
      "set terminal pngcairo size 1280,800 enhanced font 'DejaVu Sans,12' fontscale 1.6 linewidth 1.6 "
      "pointscale 1.6 "
      "background rgb 'white'\n";
  return with_png_metadata(run_gnuplot(terminal + commands(figure)), provenance);
}

Series& series_like(Figure& figure, const Series& series) {
  const auto found = std::ranges::find(figure.series, series.label, &Series::label);
  if (found != figure.series.end()) return *found;
  figure.series.push_back(series);
  return figure.series.back();
}

std::string to_pdf(const Figure& figure, const dem::Provenance& provenance) {
  const std::string terminal =
      "set terminal pdfcairo size 8in,5in enhanced font 'DejaVu Sans,12' background rgb 'white'\n";
  return with_pdf_metadata(run_gnuplot(terminal + commands(figure)), provenance);
}

std::vector<dem::OutputFile> figure_files(const std::string& name, const Figure& figure,
                                          const dem::Provenance& provenance, const FigureStyle& style) {
  Figure drawn = figure;
  if (!style.title) drawn.title.clear();
  std::vector<dem::OutputFile> files;
  for (const FigureFormat format : style.formats) {
    const auto write = format == FigureFormat::svg   ? &to_svg
                       : format == FigureFormat::png ? &to_png
                                                     : &to_pdf;
    files.push_back({fmt::format("{}.{}", name, compare::name(format)), write(drawn, provenance)});
  }
  return files;
}

}  // namespace fiberchain::compare
