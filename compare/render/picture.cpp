#include "compare/render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/results/figure_metadata.hpp"
#include "compare/results/gnuplot.hpp"

namespace fiberchain::compare {
namespace {

constexpr int kColors = 64;
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

int place_of(double value, const std::pair<double, double>& range) {
  const double place = (value - range.first) / (range.second - range.first);
  return std::clamp(static_cast<int>(place * kColors), 0, kColors - 1);
}

/// Spheres, joined by cylinders along the bonds. A bond through a periodic side is not drawn.
std::vector<Rod> rods_of(const dem::io::Frame& frame, const std::vector<double>& values,
                         const std::pair<double, double>& range) {
  std::vector<Rod> rods;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    rods.push_back({frame.position[i], frame.position[i], frame.radius[i], place_of(values[i], range)});
  for (const dem::io::FrameBond& bond : frame.bonds) {
    const auto a = static_cast<std::size_t>(bond.first), b = a + 1;
    if (norm(frame.position[b] - frame.position[a]) > 4 * frame.radius[a]) continue;
    rods.push_back({frame.position[a], frame.position[b], frame.radius[a],
                    place_of((values[a] + values[b]) / 2, range)});
  }
  return rods;
}

std::string label_of(Shade shade) {
  return shade == Shade::vertical_speed ? "vertical velocity (m/s)" : "bending angle of the bonds (rad)";
}

/// Gnuplot's commands that put a color scale and the time beside the image.
std::string commands(const dem::io::Frame& frame, const PictureOptions& options,
                     const std::pair<double, double>& range, const Image& image) {
  std::vector<std::string> colors;
  for (std::size_t i = 0; i < kScale.size(); ++i)
    colors.push_back(fmt::format("{} {} {} {}", i, kScale[i].red, kScale[i].green, kScale[i].blue));
  std::string text = fmt::format(
      "set terminal pngcairo size {0},{1} enhanced font 'DejaVu Sans,12' fontscale {2} background rgb "
      "'white'\n"
      "set output\nunset border\nunset tics\nset cbtics\nset lmargin at screen 0\nset bmargin at screen 0\n"
      "set tmargin at screen 1\nset rmargin at screen {3}\nset xrange [-0.5:{4}]\nset yrange [{5}:-0.5]\n",
      options.width, options.height, 1.3 * options.height / 800,
      static_cast<double>(image.width) / options.width, image.width - 0.5, image.height - 0.5);
  text +=
      fmt::format("set palette defined ({})\nset palette maxcolors {}\n", fmt::join(colors, ", "), kColors);
  text += fmt::format(
      "set cbrange [{}:{}]\nset colorbox user origin {},0.12 size 0.02,0.7\nset cblabel '{}'\nset label 1 't "
      "= {:.4g} s' at "
      "screen 0.98,0.93 right\n",
      range.first, range.second, static_cast<double>(image.width) / options.width + 0.005,
      label_of(options.shade), frame.time);
  return text + fmt::format(
                    "plot '-' binary array=({},{}) format='%uchar%uchar%uchar' using 1:2:3 with rgbimage "
                    "notitle, NaN with "
                    "lines palette notitle\n",
                    image.width, image.height);
}

}  // namespace

std::vector<double> shade_of(const dem::io::Frame& frame, Shade shade) {
  std::vector<double> values(frame.position.size(), 0);
  if (shade == Shade::vertical_speed) {
    std::ranges::transform(frame.velocity, values.begin(), [](const Point& v) { return v[2]; });
    return values;
  }
  std::vector<int> bonds(values.size(), 0);
  for (const dem::io::FrameBond& bond : frame.bonds) {
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

Picture draw(const dem::io::Frame& frame, const PictureOptions& options, const Provenance& provenance) {
  const std::vector<double> values = shade_of(frame, options.shade);
  const auto range = options.range ? *options.range : range_of(values);
  Solids solids{rods_of(frame, values, range), {}, frame.low, frame.high};
  for (int i = 0; i < kColors; ++i) solids.palette.push_back(color_at((i + 0.5) / kColors));
  const int width = options.width - std::max(options.width / 7, 1);  // the color scale stands beside
  const Image image = ray_trace(solids, options.view, width, options.height, options.threads);
  const std::string pixels(image.rgb.begin(), image.rgb.end());
  return {with_png_metadata(run_gnuplot(commands(frame, options, range, image) + pixels), provenance), range};
}

}  // namespace fiberchain::compare
