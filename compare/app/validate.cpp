#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/study/merge.hpp"
#include "compare/study/published.hpp"
#include "compare/study/validation.hpp"
#include "compare/study/validation_report.hpp"

namespace fiberchain::app {
namespace {

using Subjects = std::vector<compare::ValidationSubject>;

std::string parts_in_words() {
  std::vector<std::string> names;
  for (const compare::ValidationSubject& subject : compare::validation_subjects())
    names.emplace_back(subject.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The subjects asked for, in the order of the matrix; all if none is.
Subjects subjects_of(const Arguments& arguments) {
  Subjects chosen = compare::validation_subjects();
  std::vector<std::pair<std::string, compare::ValidationSubject>> words;
  for (const compare::ValidationSubject& subject : chosen) words.emplace_back(subject.name, subject);
  read_choices<compare::ValidationSubject>(arguments, "--part", chosen, words);
  return chosen;
}

/// Their rows. Claims and measures are held against each other before the first run.
std::vector<compare::ValidationRow> rows_of(const Subjects& subjects, const compare::ValidationInput& input,
                                            const Context& context) {
  const auto progress = context.progress(compare::measurements(subjects, input.shard));
  std::vector<compare::ValidationRow> rows;
  {
    const StopSignals signals;
    rows = compare::validation_rows(
        input, subjects,
        {.advance = [&] { progress->advance(); }, .stopped = [&] { return signals.received() != 0; }});
    context.stopped = signals.received();
  }
  if (context.stopped == 0) return rows;
  if (rows.empty()) std::raise(context.stopped);  // nothing to keep
  context.log->info("stopped: rows of parts that were measured whole are kept");
  return rows;
}

/// The matrix as a table; of a shard with the numbers that its rows have in the whole.
dem::Table matrix_table(const std::vector<compare::ValidationRow>& rows, const Subjects& subjects,
                        const compare::ValidationInput& input, Context& context) {
  const dem::Table table = compare::to_table(rows);
  if (!input.shard) return table;
  std::vector<std::string_view> ids;
  for (const compare::ValidationSubject& subject : subjects) {
    for (const compare::Claim& claim : input.claims) {
      if (claim.subject == subject.name) ids.push_back(claim.id);
    }
  }
  std::vector<std::size_t> numbers;
  for (const compare::ValidationRow& row : rows)
    numbers.push_back(static_cast<std::size_t>(std::ranges::find(ids, row.id) - ids.begin()));
  context.provenance.shard = compare::shard_words(*input.shard, ids.size());
  return with_cases(table, numbers);
}

void log_summary(const std::vector<compare::ValidationRow>& rows, const Context& context) {
  using enum compare::Verdict;
  const auto count = [&](compare::Verdict verdict) {
    return std::ranges::count(rows, verdict, &compare::ValidationRow::verdict);
  };
  const auto fail =
      std::ranges::count_if(rows, [](const compare::ValidationRow& row) { return row.as_expected == false; });
  context.log->info("{} rows: {} hold, {} hold only if, {} disputed, {} fail", rows.size(), count(holds),
                    count(holds_only_if), count(disputed), fail);
}

int run_validate(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  std::optional<std::filesystem::path> data;
  if (arguments.has("--data")) data = arguments.text("--data");
  compare::Workers workers(output.jobs);
  const compare::ValidationInput input{compare::read_all_published(compare::find_data_directory(data)),
                                       workers, output.shard};
  const Subjects subjects = subjects_of(arguments);
  if (compare::measurements(subjects, output.shard) == 0)
    throw compare::InputError("--shard: no measurement is left for it");
  const auto directory = open_output(output, context, Draws::no);
  const std::vector<compare::ValidationRow> rows = rows_of(subjects, input, context);
  const Results results{.name = "validation",
                        .heading = "Validation matrix",
                        .table = matrix_table(rows, subjects, input, context)};
  const dem::Table shown =
      results.table.select({"id", "feature", "reference_kind", "claim", "expected", "measured", "difference",
                            "tolerance", "as_expected", "verdict", "condition"});
  deliver(results, shown, output, directory, context);
  log_summary(rows, context);
  if (context.stopped != 0) return kSignaled + context.stopped;
  return compare::all_as_expected(rows) ? kSuccess : kCheckFailed;
}

}  // namespace

Command validate_command() {
  return {
      .name = "validate",
      .description = "hold the program against exact and published values",
      .footer =
          "Example:\n  fiberchain validate --part beams,static\n"
          "Verdicts on published claims follow from the measured values: holds, holds only if (the row's\n"
          "condition), disputed. Exit status 1 if a measured value is not as expected.",
      .options = with_shards(
          {{"--part", "LIST", parts_in_words() + " [all]"},
           {"--data", "DIR", "data directory, in place of FIBERCHAIN_DATA or the program's own"}}),
      .run = &run_validate};
}

}  // namespace fiberchain::app
