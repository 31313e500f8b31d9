#include "compare/app/results.hpp"

#include "compare/study/json.hpp"
#include "compare/study/markdown.hpp"
#include "dem/record/csv.hpp"

namespace fiberchain::app {
namespace {

std::string heading_of(const Results& results) {
  return results.notes.empty() ? results.heading : results.heading + "\n\n" + results.notes;
}

/// {"provenance": ..., "rows": [...]} and the rows of every further table under its name.
nlohmann::ordered_json json_of(const Results& results, const dem::Provenance& provenance) {
  auto document = dem::to_json(results.table, provenance);
  for (const auto& [name, table] : results.more_tables) {
    const bool of_these = name.starts_with(results.name + "-");
    document[of_these ? name.substr(results.name.size() + 1) : name] =
        dem::to_json(table, provenance)["rows"];
  }
  return document;
}

}  // namespace

std::optional<dem::OutputDirectory> open_output(const OutputOptions& options) {
  if (options.json && !options.out) return std::nullopt;
  return dem::OutputDirectory(options.out.value_or("results"));
}

void deliver(const Results& results, const dem::Table& shown, const OutputOptions& options,
             const std::optional<dem::OutputDirectory>& directory, Context& context) {
  const dem::Provenance& provenance = context.provenance;
  if (directory) {
    std::vector<dem::OutputFile> files = {
        {results.name + ".csv", dem::to_csv(results.table, provenance)},
        {results.name + ".md", dem::to_markdown(heading_of(results), results.table, provenance)}};
    for (const auto& [name, table] : results.more_tables)
      files.push_back({name + ".csv", dem::to_csv(table, provenance)});
    for (const auto& [name, figure] : results.figures) {
      for (auto& file : figure_files(name, figure, provenance)) files.push_back(std::move(file));
    }
    files.insert(files.end(), results.more_files.begin(), results.more_files.end());
    directory->write(files);
    for (const auto& file : files) context.log->info("wrote {}", (directory->path() / file.name).string());
  }
  if (options.json) {
    context.out << dem::to_text(json_of(results, provenance));
  } else {
    context.out << dem::to_markdown(shown) << (results.notes.empty() ? "" : "\n" + results.notes);
  }
}

}  // namespace fiberchain::app
