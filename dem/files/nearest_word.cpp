#include "dem/files/nearest_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace fiberchain::dem {
namespace {

/// Number of single letters to insert, delete or replace to make one word of the other (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = std::exchange(row[j + 1], std::min({row[j + 1] + 1, row[j] + 1, replaced}));
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& words) {
  const auto far = [&](const std::string& known) { return distance(word.substr(0, 60), known); };
  const auto found = std::ranges::min_element(words, {}, far);
  if (found == words.end() || far(*found) > 1 + found->size() / 3) return std::nullopt;
  return *found;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& words) {
  if (const auto meant = nearest_word(word, words)) return fmt::format("did you mean '{}'?", *meant);
  return fmt::format("allowed: {}", fmt::join(words, ", "));
}

}  // namespace fiberchain::dem
