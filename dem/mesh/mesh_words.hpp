#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "dem/files/numbers.hpp"
#include "dem/math/vec.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {

/// The words of a text, line by line. Errors are InvalidInput "NAME:LINE: ...".
class MeshWords {
 public:
  MeshWords(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, on whichever line; "" at the end.
  std::string_view next() {
    while (!is_at_end() && is_space(text_[at_])) step();
    return word();
  }
  /// The next word of this line; "" at its end.
  std::string_view next_in_line() {
    while (!is_at_end() && text_[at_] != '\n' && is_space(text_[at_])) ++at_;
    return word();
  }
  void skip_line() {
    while (!is_at_end() && text_[at_] != '\n') ++at_;
  }
  void require(std::string_view wanted) {
    if (const std::string_view found = next(); found != wanted)
      found.empty() ? fail("is cut off: {} is missing", wanted)
                    : fail("'{}' is not allowed; allowed: {}", found, wanted);
  }
  /// Three numbers.
  Vec<double, 3> vector() {
    Vec<double, 3> x{};
    for (double& c : x.c) c = number();
    return x;
  }

  template <class... Words>
  [[noreturn]] void fail(const char* what, const Words&... words) const {
    throw InvalidInput(
        fmt::format("{}:{}: {}", name_, line_, fmt::format(fmt::runtime(what), printable_start(words)...)));
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v'; }
  bool is_at_end() const { return at_ == text_.size(); }
  void step() { line_ += text_[at_++] == '\n' ? 1 : 0; }
  std::string_view word() {
    const std::size_t begin = at_;
    while (!is_at_end() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  double number() {
    const std::string_view word = next_in_line();
    if (word.empty()) fail("a coordinate is missing");
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value)) fail("'{}' is not allowed; allowed: a finite number", word);
    return *value;
  }
  /// A word of a file that may be anything, as a message may show it.
  static std::string printable_start(std::string_view word) {
    std::string shown;
    for (const char c : word.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown;
  }
  static std::int64_t printable_start(std::int64_t number) { return number; }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::int64_t line_ = 1;
};

}  // namespace fiberchain::dem
