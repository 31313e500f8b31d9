#include "compare/identify/identify.hpp"

#include <fmt/format.h>

#include "compare/app/calibrate_case.hpp"
#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/identify/record_csv.hpp"
#include "compare/identify/table.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

compare::RecordOf record_of(const Arguments& arguments) {
  using compare::RecordOf;
  return choice<RecordOf>(arguments, "--of", RecordOf::beam,
                          {{"beam", RecordOf::beam}, {"chain", RecordOf::chain}});
}

/// The fiber whose E is sought; nothing where neither size nor density is typed.
std::optional<dem::Fiber> fiber_of(const Arguments& arguments, const Quantities& typed) {
  std::vector<std::string> missing;
  const std::vector<std::string> needed = {"--diameter", "--aspect-ratio", "--density"};
  for (const std::string& option : needed) {
    if (!typed.has(option)) missing.push_back(option);
  }
  if (missing.size() == needed.size()) return std::nullopt;
  if (!missing.empty()) {
    throw compare::InputError(fmt::format("{} missing: Young's modulus needs {}", fmt::join(missing, ", "),
                                          fmt::join(needed, ", ")));
  }
  return identified_fiber(arguments, typed);
}

int run_identify(const Arguments& arguments, Context& context) {
  OutputOptions output;
  output.json = arguments.has("--json");
  std::optional<dem::OutputDirectory> directory;
  if (arguments.has("--out")) directory.emplace(arguments.text("--out"));
  const Quantities typed(arguments);
  const compare::RecordColumns columns{.time = arguments.text("--time"),
                                       .displacement = arguments.text("--displacement"),
                                       .time_unit = typed.quantity("--time-unit", "s", 1)};
  if (!(columns.time_unit > 0)) throw compare::InputError("--time-unit: must be above 0");
  compare::IdentifyCase asked{.record = compare::read_record(arguments.text("HISTORY"), columns),
                              .fiber = fiber_of(arguments, typed),
                              .of = record_of(arguments),
                              .confidence = typed.number("--confidence", 0.95)};
  const compare::Identification found = compare::identify(asked);
  const Results results{
      .name = "identify",
      .heading = "What a ring-down tells of its fiber",
      .table = compare::identification_table(found),
      .notes = compare::identification_notes(found),
      .more_tables = {{"identify-record", compare::identified_record_table(asked.record, found)}}};
  deliver(results, results.table, output, directory, context);
  for (const std::string& warning : found.warnings) context.log->warn("warning: {}", warning);
  for (const std::string& doubt : found.doubts)
    context.log->error("error: the record cannot tell the {}", doubt);
  return found.doubts.empty() ? kSuccess : kCheckFailed;
}

}  // namespace

Command identify_command() {
  return {
      .name = "identify",
      .description = "Young's modulus and damping of a fiber from a ring-down, with 95 % intervals",
      .footer =
          "HISTORY is a CSV file: a header, then times and displacements of a clamped fiber that was let go, "
          "in any\nunit, from any zero. Without size and density the answers are frequency and damping. Exit "
          "status 1 where the\nrecord cannot tell.\n"
          "Example:\n"
          "  fiberchain identify ring-down.csv --diameter '0.2 mm' --aspect-ratio 100 --density 1500",
      .options = {{"HISTORY", "", "CSV file", OptionKind::required},
                  {"--time", "COLUMN", "name of the column of times [the first]"},
                  {"--displacement", "COLUMN", "name of the column of displacements [the next]"},
                  {"--time-unit", "TIME", "what 1 of the times is, '1 ms' [1 s]"},
                  {"--diameter", "LENGTH", "d of the fiber"},
                  {"--aspect-ratio", "NUMBER", "r_f = L/d, number of bonds, 1 to 1000"},
                  {"--density", "DENSITY", "of the solid"},
                  {"--poisson-ratio", "NUMBER", "Poisson's ratio [0.3]"},
                  {"--bond", "WORD", "bond law of the chain: paper, corrected [paper]"},
                  {"--mass", "WORD",
                   "what the chain weighs: spheres (two thirds of the fiber), cylinder [spheres]"},
                  {"--of", "WORD", "what was let go: beam (a fiber), chain (of this program) [beam]"},
                  {"--confidence", "NUMBER", "of the intervals [0.95]"},
                  json_option(),
                  {"--out", "DIR", "directory for the results [none]"}},
      .run = &run_identify};
}

}  // namespace fiberchain::app
