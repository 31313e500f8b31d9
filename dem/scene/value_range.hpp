#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

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

/// The smallest size other than 0 and the largest that values in this SI unit may have: far beyond any
/// material, machine or lifetime, and such that no formula of a scene leaves the numbers of a computer.
struct SizeRange {
  double smallest, largest;
};

constexpr SizeRange sizes_in(std::string_view unit) {
  constexpr struct {
    std::string_view unit;
    SizeRange sizes;
  } all[] = {{"m", {1e-12, 1e9}},        {"Pa", {1e-6, 1e18}},     {"kg/m^3", {1e-9, 1e12}},
             {"s", {1e-15, 1e15}},       {"Pa s", {1e-12, 1e15}},  {"1/s", {1e-12, 1e15}},
             {"m/s", {1e-15, 1e9}},      {"m/s^2", {1e-15, 1e12}}, {"N", {1e-30, 1e18}},
             {"N m", {1e-36, 1e18}},     {"kg", {1e-18, 1e15}},    {"m^2", {1e-24, 1e18}},
             {"N s/m", {1e-18, 1e18}},   {"rad", {0, 1e6}},        {"Hz", {1e-12, 1e15}},
             {"K", {1e-9, 1e9}},         {"1/K", {0, 1}},          {"J/(kg K)", {1e-9, 1e12}},
             {"W/(m K)", {1e-12, 1e12}}, {"J/m^2", {1e-15, 1e12}}, {"N/m", {1e-30, 1e18}}};
  for (const auto& one : all) {
    if (one.unit == unit) return one.sizes;
  }
  return {0, unit == "1" ? 1e12 : std::numeric_limits<double>::infinity()};
}

/// The range with ends where it has none: those of sizes_in().
constexpr ValueRange in_unit(ValueRange range, std::string_view unit) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const SizeRange sizes = sizes_in(unit);
  if (range.high == none) range.high = sizes.largest, range.high_open = false;
  if (range.low == -none) range.low = -sizes.largest, range.low_open = false;
  if (range.low == 0 && range.low_open && sizes.smallest > 0)
    range.low = sizes.smallest, range.low_open = false;
  return range;
}

/// The same in words, to follow "a number": "above 0", "at least 1 and at most 9", "that is finite".
inline std::string describe(const ValueRange& allowed) {
  const auto text = [](double end) {  // 1e+09, but 2147483647
    const std::string brief = fmt::format("{:g}", end);
    return std::abs(end) >= 1e9 && std::stod(brief) == end ? brief : fmt::format("{}", end);
  };
  std::string words;
  if (std::isfinite(allowed.low)) {
    words = fmt::format("{} {}", allowed.low_open ? "above" : "at least", text(allowed.low));
  }
  if (std::isfinite(allowed.high)) {
    words += fmt::format("{}{} {}", words.empty() ? "" : " and ", allowed.high_open ? "below" : "at most",
                         text(allowed.high));
  }
  return words.empty() ? "that is finite" : words;
}

}  // namespace fiberchain::dem
