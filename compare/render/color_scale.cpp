#include "compare/render/color_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace fiberchain::compare {
namespace {

/// viridis, from low to high
constexpr std::array<Color, 8> kRising = {{{0.267f, 0.004f, 0.329f},
                                           {0.275f, 0.196f, 0.494f},
                                           {0.212f, 0.361f, 0.553f},
                                           {0.153f, 0.498f, 0.557f},
                                           {0.122f, 0.631f, 0.529f},
                                           {0.290f, 0.757f, 0.427f},
                                           {0.627f, 0.855f, 0.224f},
                                           {0.992f, 0.906f, 0.145f}}};

/// Moreland's cool to warm
constexpr std::array<Color, 9> kSigned = {{{0.231f, 0.298f, 0.753f},
                                           {0.384f, 0.510f, 0.918f},
                                           {0.553f, 0.690f, 0.996f},
                                           {0.722f, 0.816f, 0.976f},
                                           {0.867f, 0.867f, 0.867f},
                                           {0.961f, 0.769f, 0.678f},
                                           {0.957f, 0.604f, 0.482f},
                                           {0.871f, 0.376f, 0.302f},
                                           {0.706f, 0.016f, 0.149f}}};

Color color_at(std::span<const Color> scale, double place) {
  const double x = std::clamp(place, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(x), scale.size() - 2);
  const auto part = static_cast<float>(x - static_cast<double>(below));
  const Color &a = scale[below], &b = scale[below + 1];
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
          a.blue + part * (b.blue - a.blue)};
}

/// 1, 2 or 5 times a power of ten: the least that leaves at most so many steps in a width.
double round_step(double width, int most) {
  const double decade = std::pow(10.0, std::floor(std::log10(width / most)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (width / (factor * decade) <= most) return factor * decade;
  }
  return 10 * decade;
}

}  // namespace

int palette_place(double value, const std::pair<double, double>& range) {
  const double low = range.first / 2;  // halves: the difference of two doubles can be more than one holds
  const double place = (value / 2 - low) / (range.second / 2 - low);
  if (!(place > 0)) return 0;
  return place < 1 ? static_cast<int>(place * kColors) : kColors - 1;
}

std::vector<Color> palette(const std::pair<double, double>& range, bool is_signed) {
  std::vector<Color> all;
  const double most = std::max(std::abs(range.first), std::abs(range.second));
  for (int i = 0; i < kColors; ++i) {
    const double part = (i + 0.5) / kColors;
    const double over = (range.first / most) * (1 - part) + (range.second / most) * part;
    all.push_back(is_signed ? color_at(kSigned, 0.5 + 0.5 * over) : color_at(kRising, part));
  }
  return all;
}

ScaleTicks ticks_of(const std::pair<double, double>& range) {
  const double most = std::max(std::abs(range.first), std::abs(range.second)),
               width = range.second - range.first;
  ScaleTicks all;
  if (!std::isfinite(width) || !(width > 1e-13 * most) || !std::isnormal(width)) {
    for (const double end : {range.first, range.second})
      all.ticks.push_back({end, fmt::format("{:.3g}", end)});
    return all;
  }
  const int decade = static_cast<int>(std::floor(std::log10(most)));
  if (decade < -3 || decade > 4) all.exponent = 3 * static_cast<int>(std::floor(decade / 3.0));
  const double unit = std::pow(10.0, all.exponent), step = round_step(width, 6);
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)));
  const auto first = static_cast<std::int64_t>(std::ceil(range.first / step - 1e-9)),
             last = static_cast<std::int64_t>(std::floor(range.second / step + 1e-9));
  for (std::int64_t n = first; n <= last; ++n) {
    const double value = static_cast<double>(n) * step;
    all.ticks.push_back({value, fmt::format("{:.{}f}", n == 0 ? 0 : value / unit, digits)});
  }
  return all;
}

}  // namespace fiberchain::compare
