#include "compare/render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/figures/figure_metadata.hpp"
#include "compare/figures/gnuplot.hpp"

namespace fiberchain::compare {
namespace {

double length_of(const dem::TrajectoryFrame& frame, const dem::FrameBond& bond) {
  return norm(frame.position[bond.first + 1] - frame.position[bond.first]);
}

/// Of each fiber's bonds.
std::vector<double> shortest_bonds(const dem::TrajectoryFrame& frame) {
  const std::int32_t fibers = frame.fiber.empty() ? 0 : *std::ranges::max_element(frame.fiber) + 1;
  std::vector<double> shortest(fibers, std::numeric_limits<double>::infinity());
  for (const dem::FrameBond& bond : frame.bonds) {
    double& of_fiber = shortest[frame.fiber[bond.first]];
    of_fiber = std::min(of_fiber, length_of(frame, bond));
  }
  return shortest;
}

bool goes_through_a_side(const dem::TrajectoryFrame& frame, const dem::FrameBond& bond) {
  const Point way = frame.position[bond.first + 1] - frame.position[bond.first];
  for (int c = 0; c < 3; ++c) {
    if (frame.periodic[c] && std::abs(way[c]) > 0.5 * (frame.high[c] - frame.low[c])) return true;
  }
  return false;
}

/// Spheres, joined by cylinders along the bonds. A bond through a periodic side is not drawn, nor one twice
/// as long as another of its fiber: it has broken.
std::vector<Rod> rods_of(const dem::TrajectoryFrame& frame, const std::vector<double>& values,
                         const std::pair<double, double>& range) {
  std::vector<Rod> rods;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    rods.push_back({frame.position[i], frame.position[i], frame.radius[i], palette_place(values[i], range)});
  const std::vector<double> shortest = shortest_bonds(frame);
  for (const dem::FrameBond& bond : frame.bonds) {
    const auto a = static_cast<std::size_t>(bond.first), b = a + 1;
    const bool has_broken = length_of(frame, bond) > 2 * shortest[frame.fiber[a]];
    if (has_broken || goes_through_a_side(frame, bond)) continue;
    rods.push_back({frame.position[a], frame.position[b], frame.radius[a],
                    palette_place((values[a] + values[b]) / 2, range)});
  }
  return rods;
}

/// An image, the part of the picture that it takes, and words in its upper right corner.
struct Tile {
  Image image;
  double left, bottom, right, top;
  std::string words;
};

/// What all tiles of a picture share: the color scale and its place beside the images [pixels].
struct Sheet {
  const PictureOptions& options;
  const Shade& shade;
  std::pair<double, double> range;
  std::size_t below = 0, above = 0;
  ScaleTicks ticks;
  std::string label;
  double letter;  ///< height of a letter
  double scale;   ///< width of the color scale with its words
};

/// Letters as large as goes with the height of an image.
double letter_height(const PictureOptions& options, int rows) {
  return 16 * 1.3 * std::min(options.height / rows / 800.0, options.width / 1000.0);
}

std::string label_of(const Shade& shade, int exponent) {
  std::string unit = shade.unit;
  if (exponent != 0) unit = fmt::format("10^{{{}}}{}{}", exponent, unit.empty() ? "" : " ", unit);
  return unit.empty() ? shade.label : fmt::format("{} ({})", shade.label, unit);
}

/// Wide enough for the bar, the longest number and the label that stands upright.
double scale_width(const ScaleTicks& ticks, double letter) {
  std::size_t longest = 0;
  for (const ScaleTick& tick : ticks.ticks) longest = std::max(longest, tick.words.size());
  return letter * (1.6 + 1.2 + 0.68 * static_cast<double>(longest) + 2.6);
}

Sheet sheet_of(std::span<const dem::TrajectoryFrame> frames, const PictureOptions& options, int rows) {
  const Shade& shade = shade_named(options.shade);
  Sheet sheet{.options = options,
              .shade = shade,
              .range = options.range ? *options.range : shade_range(frames, shade),
              .ticks = {},
              .label = {},
              .letter = letter_height(options, rows),
              .scale = 0};
  for (const dem::TrajectoryFrame& frame : frames) {
    for (const double value : shade.values(frame))
      sheet.below += value<sheet.range.first, sheet.above += value> sheet.range.second;
  }
  sheet.ticks = ticks_of(sheet.range);
  sheet.label = label_of(shade, sheet.ticks.exponent);
  sheet.scale = std::min(scale_width(sheet.ticks, sheet.letter), options.width / 2.0);
  return sheet;
}

/// Width of all images beside each other [pixels].
int image_width(const Sheet& sheet) {
  return std::max(static_cast<int>(sheet.options.width - sheet.scale), 1);
}

Image trace(const dem::TrajectoryFrame& frame, const Sheet& sheet, const Bounds& shown, int width,
            int height) {
  Scenery scenery = scenery_of(frame, sheet.options.walls, shown);
  Solids solids{.rods = rods_of(frame, sheet.shade.values(frame), sheet.range),
                .palette = palette(sheet.range, sheet.shade.is_signed),
                .low = shown.low,
                .high = shown.high,
                .box = scenery.edges.empty(),
                .facets = std::move(scenery.facets),
                .floor = std::move(scenery.floor),
                .edges = std::move(scenery.edges)};
  return ray_trace(solids, sheet.options.view, width, height, sheet.options.threads);
}

std::string time_words(const dem::TrajectoryFrame& frame) { return fmt::format("t = {:.4g} s", frame.time); }

/// Of the color bar, in parts of the picture.
constexpr double kBarLow = 0.12, kBarHigh = 0.82;

/// Its left side and width, likewise.
std::pair<double, double> bar_place(const Sheet& sheet) {
  return {1 - (sheet.scale - 0.6 * sheet.letter) / sheet.options.width,
          1.2 * sheet.letter / sheet.options.width};
}

/// A triangle behind an end of the bar, in its color: there are values beyond it.
std::string end_mark(const Sheet& sheet, int number, double left, double right, bool at_top) {
  const std::vector<Color> colors = palette(sheet.range, sheet.shade.is_signed);
  const Color& color = at_top ? colors.back() : colors.front();
  const auto byte = [](float part) { return static_cast<int>(std::lround(255 * part)); };
  const double base = at_top ? kBarHigh : kBarLow,
               height = 1.1 * (right - left) * sheet.options.width / sheet.options.height;
  return fmt::format(
      "set object {} polygon from screen {},{} to screen {},{} to screen {},{} to screen {},{} front "
      "fillcolor rgb "
      "'#{:02x}{:02x}{:02x}' fillstyle solid 1 border lc rgb 'black'\n",
      number, left, base, right, base, (left + right) / 2, at_top ? base + height : base - height, left, base,
      byte(color.red), byte(color.green), byte(color.blue));
}

/// Gnuplot's commands for the whole picture: its size and its color scale.
std::string sheet_commands(const Sheet& sheet) {
  const PictureOptions& options = sheet.options;
  std::vector<std::string> colors, ticks;
  for (const Color& color : palette(sheet.range, sheet.shade.is_signed))
    colors.push_back(fmt::format("{} {} {} {}", colors.size(), color.red, color.green, color.blue));
  for (const ScaleTick& tick : sheet.ticks.ticks)
    ticks.push_back(fmt::format("'{}' {}", tick.words, tick.value));
  const auto [bar_left, bar_width] = bar_place(sheet);
  std::string text = fmt::format(
      "set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,12' fontscale {} background rgb 'white'\n"
      "set output\nset multiplot\nunset border\nunset tics\nset cbtics ({}) offset -0.5,0\n"
      "set palette defined ({})\nset palette maxcolors {}\nset cbrange [{}:{}]\n"
      "set label 2 '{}' at screen {},{} center rotate by 90 front\n",
      options.width, options.height, sheet.letter / 16, fmt::join(ticks, ", "), fmt::join(colors, ", "),
      kColors, sheet.range.first, sheet.range.second, sheet.label, 1 - 0.9 * sheet.letter / options.width,
      (kBarLow + kBarHigh) / 2);
  if (sheet.below > 0) text += end_mark(sheet, 1, bar_left, bar_left + bar_width, false);
  if (sheet.above > 0) text += end_mark(sheet, 2, bar_left, bar_left + bar_width, true);
  return text;
}

/// And for one image in it, with the image itself.
std::string tile_commands(const Tile& tile, const Sheet& sheet, bool with_scale) {
  const auto [left, width] = bar_place(sheet);
  const std::string scale = with_scale ? fmt::format("set colorbox user origin {},{} size {},{}\n", left,
                                                     kBarLow, width, kBarHigh - kBarLow)
                                       : "unset colorbox\n";
  return scale +
         fmt::format(
             "set lmargin at screen {}\nset bmargin at screen {}\nset rmargin at screen {}\nset tmargin at "
             "screen {}\n"
             "set xrange [-0.5:{}]\nset yrange [{}:-0.5]\nset label 1 '{}' at screen {},{} right front\n"
             "plot '-' binary array=({},{}) format='%uchar%uchar%uchar' using 1:2:3 with rgbimage "
             "notitle{}\n",
             tile.left, tile.bottom, tile.right, tile.top, tile.image.width - 0.5, tile.image.height - 0.5,
             tile.words, tile.right - 0.01, tile.top - 0.04, tile.image.width, tile.image.height,
             with_scale ? ", NaN with lines palette notitle" : "") +
         std::string(tile.image.rgb.begin(), tile.image.rgb.end());
}

}  // namespace

Picture draw(const dem::TrajectoryFrame& frame, const PictureOptions& options,
             const dem::Provenance& provenance) {
  const Sheet sheet = sheet_of({&frame, 1}, options, 1);
  const Bounds shown = options.shown ? *options.shown : shown_bounds({&frame, 1}, options.walls);
  const int width = image_width(sheet);
  const Tile tile{trace(frame, sheet, shown, width, options.height), 0, 0,
                  static_cast<double>(width) / options.width,        1, time_words(frame)};
  return {
      with_png_metadata(run_gnuplot(sheet_commands(sheet) + tile_commands(tile, sheet, true)), provenance),
      sheet.range, sheet.below, sheet.above};
}

Picture draw_sheet(const std::vector<dem::TrajectoryFrame>& frames, const PictureOptions& options,
                   const dem::Provenance& provenance) {
  constexpr int columns = 2;
  const int count = static_cast<int>(frames.size()), rows = std::max((count + columns - 1) / columns, 1);
  const Sheet sheet = sheet_of(frames, options, rows);
  const Bounds shown = options.shown ? *options.shown : shown_bounds(frames, options.walls);
  const int all_width = image_width(sheet);
  const double width = static_cast<double>(all_width) / options.width / columns, height = 1.0 / rows;
  std::string text = sheet_commands(sheet);
  for (int n = 0; n < count; ++n) {
    const double left = n % columns * width, top = 1 - n / columns * height;
    text += tile_commands(
        {trace(frames[n], sheet, shown, all_width / columns, options.height / rows), left, top - height,
         left + width, top, fmt::format("({:c}) {}", 'a' + n, time_words(frames[n]))},
        sheet, n + 1 == count);
  }
  return {with_png_metadata(run_gnuplot(text), provenance), sheet.range, sheet.below, sheet.above};
}

}  // namespace fiberchain::compare
