#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/study/validation_report.hpp"
#include "compare/study/published.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::app {
namespace {

/// What the parts of the matrix are called on the command line, in its order.
constexpr const char* kParts[] = {"beams", "static", "damping", "friction", "stability", "flow", "packing"};

using Steps = std::vector<compare::ValidationStep>;

/// The parts asked for, in the order of the matrix; all if none is.
Steps steps_of(const Arguments& arguments) {
  const Steps& all = compare::validation_steps();
  Steps chosen = all;
  std::vector<std::pair<std::string, compare::ValidationStep>> words;
  for (std::size_t n = 0; n < all.size(); ++n) words.emplace_back(kParts[n], all[n]);
  read_choices<compare::ValidationStep>(arguments, "--part", chosen, words);
  return chosen;
}

/// Their rows.
std::vector<compare::MatrixRow> rows_of(const Steps& steps, const std::vector<compare::PublishedValue>& published, int jobs,
                                        const Context& context) {
  const compare::ValidationInput input{published, jobs};
  const auto progress = context.progress(steps.size());
  std::vector<compare::MatrixRow> all;
  for (const compare::ValidationStep& step : steps) {
    for (compare::MatrixRow& row : step.rows(input)) all.push_back(std::move(row));
    progress->advance();
  }
  return all;
}

void log_summary(const std::vector<compare::MatrixRow>& rows, const Context& context) {
  const auto count = [&](compare::Verdict verdict) {
    return std::ranges::count(rows, verdict, &compare::MatrixRow::verdict);
  };
  context.log->info("{} rows: {} hold, {} disputed, {} fail", rows.size(), count(compare::Verdict::holds),
                    count(compare::Verdict::disputed), count(compare::Verdict::fails));
}

int run(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  std::optional<std::filesystem::path> data;
  if (arguments.has("--data")) data = arguments.text("--data");
  const auto published = compare::read_all_published(compare::find_data_directory(data));
  const Steps steps = steps_of(arguments);
  const auto directory = open_output(output);
  const std::vector<compare::MatrixRow> rows = rows_of(steps, published, output.jobs, context);
  const Results results{
      .name = "validation", .heading = "Validation matrix", .table = compare::to_table(rows)};
  const dem::Table shown = results.table.select(
      {"id", "feature", "reference_kind", "expected", "measured", "difference", "tolerance", "verdict"});
  deliver(results, shown, output, directory, context);
  log_summary(rows, context);
  return compare::all_hold(rows) ? kSuccess : kCheckFailed;
}

}  // namespace

Command validate_command() {
  return {.name = "validate",
          .description = "hold the program against exact and published values",
          .footer =
              "Example:\n  fiberchain validate --part beams,static\n"
              "Exit status 1 if a row that must hold does not.",
          .options = with_output(
              {{"--part", "LIST", "beams, static, damping, friction, stability, flow, packing [all]"},
               {"--data", "DIR", "data directory, in place of FIBERCHAIN_DATA or the program's own"}}),
          .run = &run};
}

}  // namespace fiberchain::app
