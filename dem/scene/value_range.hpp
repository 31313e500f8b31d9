#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace fiberchain::dem {

/// The finite values something may take, from `low` to `high`.
struct ValueRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   ///< `low` itself is not allowed
  bool high_open = false;  ///< `high` itself is not allowed

  bool holds(double value) const {
    return std::isfinite(value) && (low_open ? value > low : value >= low) &&
           (high_open ? value < high : value <= high);
  }
};

inline constexpr ValueRange kFinite{};
inline constexpr ValueRange kPositive{.low = 0, .low_open = true};
inline constexpr ValueRange kNonNegative{.low = 0};

/// The same in words, to follow "a number": "above 0", "at least 1 and at most 9", "that is finite".
inline std::string describe(const ValueRange& allowed) {
  std::string words;
  if (std::isfinite(allowed.low)) {
    words = fmt::format("{} {}", allowed.low_open ? "above" : "at least", allowed.low);
  }
  if (std::isfinite(allowed.high)) {
    words += fmt::format("{}{} {}", words.empty() ? "" : " and ", allowed.high_open ? "below" : "at most",
                         allowed.high);
  }
  return words.empty() ? "that is finite" : words;
}

}  // namespace fiberchain::dem
