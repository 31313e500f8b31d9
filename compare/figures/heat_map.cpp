#include "compare/figures/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

std::string quoted_text(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, 1, '\'');
  return "'" + text + "'";
}

/// Labels at 0, 1, 2 ... as far as they are apart.
std::string ticks(char axis, const std::vector<double>& values) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < values.size(); ++i) all.push_back(fmt::format("'{:.4g}' {}", values[i], i));
  return fmt::format("set {0}tics ({1}) scale 0\nset {0}range [-0.5:{2}]\n", axis, fmt::join(all, ", "),
                     static_cast<double>(values.size()) - 0.5);
}

/// Ends of the color scale.
struct Extent {
  double low, high;
};

Extent extent(const HeatMap& map) {
  Extent e{INFINITY, 0};
  for (const auto& row : map.value) {
    if (row.size() != map.x.size()) throw FigureError("heat map: a row's length is not that of x");
    for (const double v : row) {
      if (!std::isfinite(v) || !(v > 0)) continue;
      e = {std::min(e.low, v), std::max(e.high, v)};
    }
  }
  if (map.value.size() != map.y.size()) throw FigureError("heat map: as many rows as y are wanted");
  if (e.high == 0) throw FigureError("heat map: no value above 0");
  // a decade at least, or what hardly differs would look very different
  return {std::min(e.low, e.high / 10), e.high};
}

/// "column row value number color-of-the-number" a line, of all cells or of those framed.
std::string cells(const HeatMap& map, const Extent& e, bool framed) {
  std::string text;
  for (std::size_t row = 0; row < map.y.size(); ++row) {
    for (std::size_t column = 0; column < map.x.size(); ++column) {
      const double v = map.value[row][column];
      if (!std::isfinite(v) || !(v > 0) || (framed && !(v < map.framed_below))) continue;
      // white figures on the dark lower half of the scale
      const bool dark = v < std::sqrt(e.low * e.high);
      text += fmt::format("{} {} {} {:.3g} {}\n", column, row, v, v, dark ? 0xffffff : 0x000000);
    }
  }
  return text;
}

}  // namespace

std::string heat_map_commands(const HeatMap& map, const std::string& x_label, const std::string& y_label) {
  const Extent e = extent(map);
  const std::string framed = cells(map, e, true);
  std::string text = fmt::format("$cells << EOD\n{}EOD\n", cells(map, e, false));
  if (!framed.empty()) text += fmt::format("$framed << EOD\n{}EOD\n", framed);
  text += fmt::format("set xlabel {}\nset ylabel {}\n{}{}", quoted_text(x_label), quoted_text(y_label),
                      ticks('x', map.x), ticks('y', map.y));
  // viridis
  text +=
      "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d', 3 '#277f8e', 4 '#1fa187', 5 '#4ac16d', 6 "
      "'#a0da39', 7 '#fde725')\nset logscale cb\n";
  text += fmt::format("set cbrange [{}:{}]\nset cblabel {}\nset format cb '%g'\n", e.low / 1.05,
                      e.high * 1.05, quoted_text(map.label));
  text += "set cbtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)\nunset grid\nset nokey\n";
  text +=
      "plot $cells using 1:2:(0.5):(0.5):3 with boxxyerror fillstyle solid noborder fillcolor palette, \\\n";
  if (!framed.empty())
    text +=
        "     $framed using 1:2:(0.47):(0.47) with boxxyerror fillstyle empty linecolor rgb '#d55e00' "
        "linewidth 2, "
        "\\\n";
  return text + "     $cells using 1:2:(stringcolumn(4)):5 with labels textcolor rgb variable\n";
}

}  // namespace fiberchain::compare
