#include "compare/app/options.hpp"

#include <fmt/format.h>

#include <thread>

#include "compare/study/errors.hpp"
#include "compare/study/merge.hpp"

namespace fiberchain::app {
namespace {

template <class Number>
Number only_one(const std::string& option, const std::string& text, const std::vector<Number>& values) {
  if (values.size() != 1)
    throw compare::InputError(fmt::format("{}: '{}' is no single number", option, text));
  return values.front();
}

}  // namespace

Option json_option() {
  return {"--json", "", "print the rows as one JSON object, and nothing else, to standard output",
          OptionKind::flag};
}

Option no_figures_option() {
  return {"--no-figures", "", "draw no pictures; with --json there are none anyway", OptionKind::flag};
}

std::vector<Option> figure_options() {
  return {{"--figure-format", "LIST", "formats of the figures: svg, png, pdf [svg,png]"},
          {"--no-title", "", "figures without a title", OptionKind::flag}};
}

compare::FigureStyle figure_style(const Arguments& arguments) {
  compare::FigureStyle style;
  style.title = !arguments.has("--no-title");
  std::vector<std::pair<std::string, compare::FigureFormat>> words;
  for (const auto format :
       {compare::FigureFormat::svg, compare::FigureFormat::png, compare::FigureFormat::pdf})
    words.emplace_back(compare::name(format), format);
  read_choices(arguments, "--figure-format", style.formats, words);
  return style;
}

std::vector<Option> with_output(std::vector<Option> options) {
  options.push_back(json_option());
  options.push_back(
      {"--out", "DIR", "directory for the results; with --json none are written unless given [results]"});
  options.push_back(no_figures_option());
  for (Option& option : figure_options()) options.push_back(std::move(option));
  options.push_back({"--jobs", "N", "threads [all cores]", OptionKind::text, "--threads"});
  return options;
}

std::vector<Option> with_shards(std::vector<Option> options) {
  options.push_back({"--shard", "I/N",
                     "run the I-th of N parts of the cases, for N machines; tables go to DIR/shard-I-of-N, "
                     "`fiberchain merge` makes one of them"});
  return with_output(std::move(options));
}

std::filesystem::path OutputOptions::directory() const {
  const std::filesystem::path whole = out.value_or("results");
  return shard ? whole / compare::shard_directory(*shard) : whole;
}

OutputOptions output_options(const Arguments& arguments) {
  OutputOptions options;
  options.json = arguments.has("--json");
  options.figures = !options.json && !arguments.has("--no-figures");
  options.style = figure_style(arguments);
  if (arguments.has("--out")) options.out = arguments.text("--out");
  options.jobs = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  read_number(arguments, "--jobs", {.low = 1, .high = 1024}, options.jobs);
  if (arguments.has("--shard")) options.shard = compare::parse_shard("--shard", arguments.text("--shard"));
  return options;
}

void read_list(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
               std::vector<double>& values) {
  if (arguments.has(option)) values = compare::parse_numbers(option, arguments.text(option), allowed);
}

void read_list(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
               std::vector<int>& values) {
  if (arguments.has(option)) values = compare::parse_integers(option, arguments.text(option), allowed);
}

void read_number(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
                 double& value) {
  if (!arguments.has(option)) return;
  const std::string text = arguments.text(option);
  value = only_one(option, text, compare::parse_numbers(option, text, allowed));
}

void read_number(const Arguments& arguments, const std::string& option, const dem::ValueRange& allowed,
                 int& value) {
  if (!arguments.has(option)) return;
  const std::string text = arguments.text(option);
  value = only_one(option, text, compare::parse_integers(option, text, allowed));
}

compare::PeakRange peak_range(const Arguments& arguments, const compare::PeakRange& usual) {
  if (!arguments.has("--peaks")) return usual;
  std::vector<int> peaks;
  read_list(arguments, "--peaks", {.low = 0, .high = 10000}, peaks);
  if (peaks.size() < 2 || peaks.back() - peaks.front() + 1 != static_cast<int>(peaks.size())) {
    throw compare::InputError(fmt::format(
        "--peaks: '{}' is not allowed: give a range a..b of at least two peaks", arguments.text("--peaks")));
  }
  return {peaks.front(), peaks.back()};
}

}  // namespace fiberchain::app
