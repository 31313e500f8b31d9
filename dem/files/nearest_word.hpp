#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fiberchain::dem {

/// The one of these words that `word` may be a slip of: fewest letters to insert, delete or replace
/// (Levenshtein), at most a third of the word's and one; nothing if all are farther.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& words);

/// "did you mean 'x'?", or "allowed: " and all of them.
std::string suggestion(std::string_view word, const std::vector<std::string>& words);

}  // namespace fiberchain::dem
