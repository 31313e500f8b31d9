#include "compare/study/ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/study/errors.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::compare {
namespace {

using dem::parse_number;

constexpr double kMostValues = 100000;  // of one range: beyond it the option is surely mistyped

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end; (end = text.find(separator)) != text.npos;
       text.remove_prefix(end + separator.size())) {
    parts.push_back(text.substr(0, end));
  }
  parts.push_back(text);
  return parts;
}

/// What every message about one option needs.
struct Option {
  std::string_view name;
  ValueRange allowed;

  [[noreturn]] void fail(std::string_view value, const std::string& reason) const {
    throw InputError(fmt::format("{}: '{}' {}", name, value, reason));
  }

  double number(std::string_view text) const {
    const auto value = parse_number(text);
    if (!value) fail(text, "is no number, list or range such as 0.5,6 or 5..60:5 or 0.05..10:log:12");
    if (!allowed.holds(*value)) fail(text, "is out of range; allowed: a number " + describe(allowed));
    return *value;
  }
};

/// The double nearest the decimal the user would have typed: 0..1:0.1 holds 0.3, not 0.30000000000000004.
double as_typed(double value) { return *parse_number(fmt::format("{:.14g}", value)); }

std::vector<double> stepped(double first, double last, double step) {
  std::vector<double> values;
  const double count = std::floor((last - first) / step * (1 + 4 * std::numeric_limits<double>::epsilon()));
  for (double i = 0; i <= count; ++i) values.push_back(as_typed(first + i * step));
  values.front() = first;
  return values;
}

std::vector<double> spaced(double first, double last, double count, bool logarithmic) {
  std::vector<double> values;
  for (double i = 0; i < count; ++i) {
    const double t = i / (count - 1);
    values.push_back(logarithmic ? first * std::pow(last / first, t) : as_typed(first + t * (last - first)));
  }
  values.front() = first;
  values.back() = last;
  return values;
}

std::vector<double> counted_range(const Option& option, std::string_view item, double first, double last,
                                  std::string_view spacing, std::string_view count_text) {
  const auto count = dem::parse_integer(count_text);
  if (spacing != "log" && spacing != "lin") option.fail(item, "has no such spacing; allowed: log, lin");
  if (!count || *count < 2 || static_cast<double>(*count) > kMostValues) {
    option.fail(item, "wants a number of values from 2 to 100000");
  }
  if (spacing == "log" && !(first > 0)) option.fail(item, "is logarithmic and must begin above 0");
  return spaced(first, last, static_cast<double>(*count), spacing == "log");
}

std::vector<double> range(const Option& option, std::string_view item) {
  const auto parts = split(item, ":");
  const auto ends = split(parts[0], "..");
  if (ends.size() != 2 || parts.size() > 3) option.fail(item, "is no range such as 5..60:5");
  const double first = option.number(ends[0]);
  const double last = option.number(ends[1]);
  if (first > last) option.fail(item, "runs backward; write the smaller value first");
  if (parts.size() == 3) return counted_range(option, item, first, last, parts[1], parts[2]);
  const auto step = parts.size() == 2 ? parse_number(parts[1]) : 1.0;
  if (!step || !(*step > 0) || !std::isfinite(*step)) option.fail(item, "wants a step above 0");
  if ((last - first) / *step >= kMostValues) option.fail(item, "has more than 100000 values");
  return stepped(first, last, *step);
}

}  // namespace

std::vector<double> parse_numbers(std::string_view name, std::string_view text, const ValueRange& allowed) {
  const Option option{name, allowed};
  std::vector<double> values;
  for (const std::string_view item : split(text, ",")) {
    const bool is_range = item.find("..") != item.npos;
    const auto more = is_range ? range(option, item) : std::vector<double>{option.number(item)};
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

std::vector<int> parse_integers(std::string_view name, std::string_view text, const ValueRange& allowed) {
  const Option option{name, allowed};
  std::vector<int> values;
  for (const double value : parse_numbers(name, text, allowed)) {
    if (value != std::floor(value)) option.fail(text, "wants whole numbers");
    values.push_back(static_cast<int>(value));
  }
  return values;
}

std::vector<std::string> parse_words(std::string_view name, std::string_view text,
                                     const std::vector<std::string>& allowed) {
  std::vector<std::string> words;
  for (const std::string_view item : split(text, ",")) {
    if (std::ranges::find(allowed, item) == allowed.end()) {
      const Option option{name, {}};
      option.fail(item, fmt::format("is not among {}", fmt::join(allowed, ", ")));
    }
    words.emplace_back(item);
  }
  return words;
}

}  // namespace fiberchain::compare
