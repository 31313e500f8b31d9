#include "compare/study/claimed_range.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

[[noreturn]] void refuse(std::string_view text) {
  throw InputError(
      fmt::format("'{}' is no claim: give LOW..HIGH, < X, <= X, > X, >= X, not LOW..HIGH, or -", text));
}

double claimed_number(std::string_view word, std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) refuse(text);
  return value;
}

bool starts(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

}  // namespace

ClaimedRange::ClaimedRange(std::string_view text) : text_(text) {
  std::string_view rest = text;
  if (starts(rest, "<= ")) {
    high_ = claimed_number(rest, text);
  } else if (starts(rest, "< ")) {
    high_ = claimed_number(rest, text), high_open_ = true;
  } else if (starts(rest, ">= ")) {
    low_ = claimed_number(rest, text);
  } else if (starts(rest, "> ")) {
    low_ = claimed_number(rest, text), low_open_ = true;
  } else {
    complement_ = starts(rest, "not ");
    const std::size_t dots = rest.find("..");
    if (dots == std::string_view::npos) refuse(text);
    low_ = claimed_number(rest.substr(0, dots), text), high_ = claimed_number(rest.substr(dots + 2), text);
    if (!(low_ < high_)) refuse(text);
  }
}

bool ClaimedRange::contains(double value) const {
  if (std::isnan(value)) return false;
  const bool inside =
      (low_open_ ? value > low_ : value >= low_) && (high_open_ ? value < high_ : value <= high_);
  return inside != complement_;
}

bool ClaimedRange::decides(double low, double high) const {
  const bool within = contains(low) && contains(high) && !(complement_ && low < low_ && high > high_);
  const bool beyond = !contains(low) && !contains(high) && (complement_ || !(low < low_ && high > high_));
  return within || beyond;
}

}  // namespace fiberchain::compare
