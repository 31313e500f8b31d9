#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dem/scene/value_range.hpp"

/// Lists and ranges as the options take them: "10,13", "5..60", "5..60:5", "0.05..10:log:12", and any of
/// these joined by commas. Ranges hold both ends; the step is 1 unless given; a step that does not meet
/// the last value stops before it; "a..b:log:n" and "a..b:lin:n" are n values, ends included.
namespace fiberchain::compare {

using dem::ValueRange;

/// The numbers of a list, in the order given. `option` is what messages call it ("--load").
/// @throws InputError naming option, value and what is allowed
std::vector<double> parse_numbers(std::string_view option, std::string_view text, const ValueRange& allowed);

/// The same for integers.
std::vector<int> parse_integers(std::string_view option, std::string_view text, const ValueRange& allowed);

/// One of the words of a choice, or several joined by commas.
/// @throws InputError naming option, value and the words allowed
std::vector<std::string> parse_words(std::string_view option, std::string_view text,
                                     const std::vector<std::string>& allowed);

}  // namespace fiberchain::compare
