#include "compare/render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/figures/figure_metadata.hpp"
#include "compare/figures/gnuplot.hpp"

namespace fiberchain::compare {
namespace {

/// viridis, from low to high; also in gnuplot's words
constexpr std::array<Color, 8> kScale = {{{0.267f, 0.004f, 0.329f},
                                          {0.275f, 0.196f, 0.494f},
                                          {0.212f, 0.361f, 0.553f},
                                          {0.153f, 0.498f, 0.557f},
                                          {0.122f, 0.631f, 0.529f},
                                          {0.290f, 0.757f, 0.427f},
                                          {0.627f, 0.855f, 0.224f},
                                          {0.992f, 0.906f, 0.145f}}};

Color color_at(double place) {
  const double x = std::clamp(place, 0.0, 1.0) * (kScale.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(x), kScale.size() - 2);
  const auto part = static_cast<float>(x - static_cast<double>(below));
  const Color &a = kScale[below], &b = kScale[below + 1];
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
          a.blue + part * (b.blue - a.blue)};
}

/// Spheres, joined by cylinders along the bonds. A bond through a periodic side is not drawn.
std::vector<Rod> rods_of(const dem::TrajectoryFrame& frame, const std::vector<double>& values,
                         const std::pair<double, double>& range) {
  std::vector<Rod> rods;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    rods.push_back({frame.position[i], frame.position[i], frame.radius[i], palette_place(values[i], range)});
  for (const dem::FrameBond& bond : frame.bonds) {
    const auto a = static_cast<std::size_t>(bond.first), b = a + 1;
    if (norm(frame.position[b] - frame.position[a]) > 4 * frame.radius[a]) continue;
    rods.push_back({frame.position[a], frame.position[b], frame.radius[a],
                    palette_place((values[a] + values[b]) / 2, range)});
  }
  return rods;
}

std::string label_of(Shade shade) {
  return shade == Shade::vertical_speed ? "vertical velocity (m/s)" : "bending angle of the bonds (rad)";
}

/// An image, the part of the picture that it takes, and words in its upper right corner.
struct Tile {
  Image image;
  double left, bottom, right, top;
  std::string words;
};

/// Share of the width that images have: the color scale stands beside them.
constexpr double kImages = 6.0 / 7;

int image_width(const PictureOptions& options) {
  return std::max(static_cast<int>(kImages * options.width), 1);
}

Image trace(const dem::TrajectoryFrame& frame, const PictureOptions& options,
            const std::pair<double, double>& range, int width, int height) {
  Solids solids{rods_of(frame, shade_of(frame, options.shade), range), {}, frame.low, frame.high};
  for (int i = 0; i < kColors; ++i) solids.palette.push_back(color_at((i + 0.5) / kColors));
  return ray_trace(solids, options.view, width, height, options.threads);
}

std::string time_words(const dem::TrajectoryFrame& frame) { return fmt::format("t = {:.4g} s", frame.time); }

/// Letters as large as goes with the height of an image and the room beside it for the numbers of the scale.
double font_scale(const PictureOptions& options, int rows) {
  return 1.3 * std::min(options.height / rows / 800.0, options.width / 1000.0);
}

/// Gnuplot's commands for the whole picture: its size and its color scale.
std::string sheet_commands(const PictureOptions& options, const std::pair<double, double>& range, int rows) {
  std::vector<std::string> colors;
  for (std::size_t i = 0; i < kScale.size(); ++i)
    colors.push_back(fmt::format("{} {} {} {}", i, kScale[i].red, kScale[i].green, kScale[i].blue));
  return fmt::format(
      "set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,12' fontscale {} background rgb 'white'\n"
      "set output\nset multiplot\nunset border\nunset tics\nset cbtics\nset format cb '%.3g'\n"
      "set palette defined ({})\nset palette maxcolors {}\nset cbrange [{}:{}]\n"
      "set label 2 '{}' at screen 0.985,0.47 center rotate by 90 front\n",
      options.width, options.height, font_scale(options, rows), fmt::join(colors, ", "), kColors, range.first,
      range.second, label_of(options.shade));
}

/// And for one image in it, with the image itself.
std::string tile_commands(const Tile& tile, bool with_scale) {
  const std::string scale =
      with_scale ? fmt::format("set colorbox user origin {},0.12 size 0.02,0.7\n", kImages + 0.005)
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

int palette_place(double value, const std::pair<double, double>& range) {
  const double low = range.first / 2;  // halves: the difference of two doubles can be more than one holds
  const double place = (value / 2 - low) / (range.second / 2 - low);
  if (!(place > 0)) return 0;
  return place < 1 ? static_cast<int>(place * kColors) : kColors - 1;
}

std::vector<double> shade_of(const dem::TrajectoryFrame& frame, Shade shade) {
  std::vector<double> values(frame.position.size(), 0);
  if (shade == Shade::vertical_speed) {
    std::ranges::transform(frame.velocity, values.begin(), [](const Point& v) { return v[2]; });
    return values;
  }
  std::vector<int> bonds(values.size(), 0);
  for (const dem::FrameBond& bond : frame.bonds) {
    for (const auto i : {static_cast<std::size_t>(bond.first), static_cast<std::size_t>(bond.first) + 1}) {
      values[i] += bond.bending_angle;
      ++bonds[i];
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] /= std::max(bonds[i], 1);
  return values;
}

std::pair<double, double> range_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const std::size_t rare = values.size() / 200;
  const double low = values[rare], high = values[values.size() - 1 - rare];
  const double least =
      1e-3 * std::max({std::abs(low), std::abs(high), 1e-9});  // what hardly differs looks alike
  return high - low > least ? std::pair{low, high} : std::pair{low - least, high + least};
}

std::pair<double, double> shade_range(std::span<const dem::TrajectoryFrame> frames, Shade shade) {
  std::vector<double> values;
  for (const dem::TrajectoryFrame& frame : frames) {
    const std::vector<double> more = shade_of(frame, shade);
    values.insert(values.end(), more.begin(), more.end());
  }
  return range_of(std::move(values));
}

Picture draw(const dem::TrajectoryFrame& frame, const PictureOptions& options,
             const dem::Provenance& provenance) {
  const auto range = options.range ? *options.range : shade_range({&frame, 1}, options.shade);
  const Tile tile{trace(frame, options, range, image_width(options), options.height),
                  0,
                  0,
                  kImages,
                  1,
                  time_words(frame)};
  return {with_png_metadata(run_gnuplot(sheet_commands(options, range, 1) + tile_commands(tile, true)),
                            provenance),
          range};
}

Picture draw_sheet(const std::vector<dem::TrajectoryFrame>& frames, const PictureOptions& options,
                   const dem::Provenance& provenance) {
  constexpr int columns = 2;
  const auto range = options.range ? *options.range : shade_range(frames, options.shade);
  const int count = static_cast<int>(frames.size()), rows = std::max((count + columns - 1) / columns, 1);
  const double width = kImages / columns, height = 1.0 / rows;
  std::string text = sheet_commands(options, range, rows);
  for (int n = 0; n < count; ++n) {
    const double left = n % columns * width, top = 1 - n / columns * height;
    text += tile_commands(
        {trace(frames[n], options, range, image_width(options) / columns, options.height / rows), left,
         top - height, left + width, top, fmt::format("({:c}) {}", 'a' + n, time_words(frames[n]))},
        n + 1 == count);
  }
  return {with_png_metadata(run_gnuplot(text), provenance), range};
}

}  // namespace fiberchain::compare
