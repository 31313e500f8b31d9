#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/render/ray_trace.hpp"

/// Colors of numbers, and the scale that explains them.
namespace fiberchain::compare {

inline constexpr int kColors = 64;

/// Color of a value, 0 for the lowest to kColors - 1: what is beyond the scale has the color of its end, NaN
/// the lowest.
int palette_place(double value, const std::pair<double, double>& range);

/// kColors from the low end to the high one: viridis; where numbers have a sign blue below zero, gray at it,
/// red above, equally strong at equal sizes.
std::vector<Color> palette(const std::pair<double, double>& range, bool is_signed);

/// A mark of the scale.
struct ScaleTick {
  double value;
  std::string words;
};

/// At round numbers within the range, at least two, with as many digits as tell them apart.
struct ScaleTicks {
  std::vector<ScaleTick> ticks;
  int exponent = 0;  ///< words are of values over 10^exponent, which the label tells
};

ScaleTicks ticks_of(const std::pair<double, double>& range);

}  // namespace fiberchain::compare
