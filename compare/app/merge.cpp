#include "compare/study/merge.hpp"

#include <fstream>
#include <sstream>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw compare::InputError(path.string() + ": cannot read this file");
  return text.str();
}

/// Rows of a validation matrix that are not as expected.
std::ptrdiff_t unexpected(const compare::TextTable& table) {
  const auto column = std::ranges::find(table.columns, "as_expected");
  if (column == table.columns.end()) return 0;
  const auto n = static_cast<std::size_t>(column - table.columns.begin());
  return std::ranges::count_if(table.rows, [&](const auto& row) { return row[n] == "no"; });
}

int run_merge(const Arguments& arguments, Context& context) {
  std::vector<std::filesystem::path> parts;
  for (const std::string& text : arguments.texts("PART")) parts.emplace_back(text);
  compare::Merged merged = compare::merge_shards(parts);
  const dem::OutputDirectory directory(arguments.has("--out") ? arguments.text("--out") : "results");
  std::vector<dem::OutputFile> files;
  std::ptrdiff_t failed = 0;
  for (compare::MergedTable& one : merged.tables) {
    one.table.provenance.emplace_back("merged_by", context.provenance.command);
    files.push_back({one.file, to_csv(one.table)});
    failed += unexpected(one.table);
  }
  for (const auto& picture : merged.pictures)
    files.push_back({picture.filename().string(), content_of(picture)});
  directory.write(files);
  for (const auto& file : files) context.log->info("wrote {}", (directory.path() / file.name).string());
  context.log->info("{} cases of {} parts", merged.cases, parts.size());
  if (failed == 0) return kSuccess;
  context.log->error("error: {} rows are not as expected", failed);
  return kCheckFailed;
}

}  // namespace

Command merge_command() {
  return {.name = "merge",
          .description =
              "tables of shards (--shard I/N of tables, sweeps, stability, validate) become those of "
              "the whole",
          .footer =
              "Example:\n  fiberchain tables damping --shard 1/2 && fiberchain tables damping --shard 2/2\n"
              "  fiberchain merge results/shard-* --out results\n"
              "Refused: parts of other commits or commands, a shard that is missing or comes twice.",
          .options = {{"PART", "DIR", "directories of all shards", OptionKind::places},
                      {"--out", "DIR", "directory for the tables [results]"}},
          .run = &run_merge};
}

}  // namespace fiberchain::app
