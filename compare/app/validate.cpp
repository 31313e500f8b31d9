#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/matrix.hpp"
#include "compare/published.hpp"
#include "compare/validation.hpp"

namespace fiberchain::app {
namespace {

/// The rows of every part of the program, in the order of the matrix.
std::vector<compare::MatrixRow> all_rows(const std::vector<compare::PublishedValue>& published,
                                         const ValidateOptions& options, const Context& context) {
  const compare::ValidationInput input{published, options.output.jobs};
  const auto& steps = compare::validation_steps();
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

}  // namespace

int run_validate(const ValidateOptions& options, Context& context) {
  const auto published = compare::read_all_published(compare::find_data_directory(options.output.data));
  const auto directory = open_output(options.output);
  const std::vector<compare::MatrixRow> rows = all_rows(published, options, context);
  const Results results{
      .name = "validation", .heading = "Validation matrix", .table = compare::to_table(rows)};
  const compare::Table shown = results.table.select(
      {"id", "feature", "reference_kind", "expected", "measured", "difference", "tolerance", "verdict"});
  deliver(results, shown, options.output, directory, context);
  log_summary(rows, context);
  return compare::all_hold(rows) ? kSuccess : kCheckFailed;
}

}  // namespace fiberchain::app
