#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/app/command.hpp"
#include "compare/figures/figure.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/ranges.hpp"
#include "compare/study/shard.hpp"

/// Options that several commands have, and how options become values.
namespace fiberchain::app {

struct OutputOptions {
  bool json = false;                         ///< rows as one JSON object on standard output
  std::optional<std::filesystem::path> out;  ///< results directory; without it "results", or none with --json
  int jobs = 1;                              ///< threads
  bool figures = true;                       ///< pictures are drawn: none with --json
  compare::FigureStyle style = {};
  std::optional<compare::Shard> shard = {};  ///< the part of the cases that this run has; without it all

  /// Whether this run makes the tables that do not depend on the cases.
  bool makes_fixed_tables() const { return !shard || shard->first(); }
  /// Where tables go: a directory for each shard below the one asked for.
  std::filesystem::path directory() const;
};

/// --json
Option json_option();

/// --no-figures
Option no_figures_option();

/// --figure-format and --no-title.
std::vector<Option> figure_options();

/// What those say.
/// @throws compare::InputError for other formats
compare::FigureStyle figure_style(const Arguments& arguments);

/// These options with --json, --out, --no-figures, those of figures and --jobs behind them.
std::vector<Option> with_output(std::vector<Option> options);

/// The same and --shard, for commands of many cases.
std::vector<Option> with_shards(std::vector<Option> options);

/// @throws compare::InputError if --jobs is no number of threads, or --shard no part
OutputOptions output_options(const Arguments& arguments);

/// What a footer says of lists and ranges.
inline constexpr const char* kListHelp =
    "\nLists and ranges: 10,13   5..60   5..60:5 (step)   0.05..10:log:12 (number of values)";

/// Poisson's ratios that an isotropic material can have.
inline constexpr dem::ValueRange kPoissonRatios{.low = -1, .high = 0.5, .low_open = true};

/// A list of numbers or integers in place of the usual one, if the option was typed.
/// @throws compare::InputError naming option, value and what is allowed
void read_list(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
               std::vector<double>& values);
void read_list(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
               std::vector<int>& values);

/// A single number, likewise.
void read_number(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
                 double& value);
void read_number(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
                 int& value);

/// --peaks: a range of at least two peaks, in place of the usual one, if the option was typed.
/// @throws compare::InputError naming the value and what is allowed
compare::PeakRange peak_range(const Arguments& arguments, const compare::PeakRange& usual);

/// A list of words, each standing for a value, likewise.
template <class Value>
void read_choices(const Arguments& arguments, const std::string& option, std::vector<Value>& chosen,
                  const std::vector<std::pair<std::string, Value>>& choices) {
  if (!arguments.has(option)) return;
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  chosen.clear();
  for (const std::string& word : compare::parse_words(option, arguments.text(option), words)) {
    chosen.push_back(
        choices[static_cast<std::size_t>(std::ranges::find(words, word) - words.begin())].second);
  }
}

/// One of these words, likewise; the usual one if the option was not typed.
template <class Value>
Value choice(const Arguments& arguments, const std::string& option, Value usual,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<Value> chosen{usual};
  read_choices<Value>(arguments, option, chosen, choices);
  if (chosen.size() != 1)
    throw compare::InputError(option + ": '" + arguments.text(option) + "' is more than one choice");
  return chosen.front();
}

}  // namespace fiberchain::app
