#include "compare/app/results.hpp"

#include "compare/csv.hpp"
#include "compare/json.hpp"
#include "compare/markdown.hpp"

namespace fiberchain::app {

std::optional<compare::OutputDirectory> open_output(const OutputOptions& options) {
  if (options.json && !options.out) return std::nullopt;
  return compare::OutputDirectory(options.out.value_or("results"));
}

void deliver(const Results& results, const compare::Table& shown, const OutputOptions& options,
             const std::optional<compare::OutputDirectory>& directory, Context& context) {
  const compare::Provenance& provenance = context.provenance;
  if (directory) {
    std::vector<compare::OutputFile> files = {
        {results.name + ".csv", to_csv(results.table, provenance)},
        {results.name + ".md", to_markdown(results.heading, results.table, provenance)}};
    for (const auto& [name, table] : results.more_tables)
      files.push_back({name + ".csv", to_csv(table, provenance)});
    for (const auto& [name, figure] : results.figures) {
      for (auto& file : figure_files(name, figure, provenance)) files.push_back(std::move(file));
    }
    directory->write(files);
    for (const auto& file : files) context.log->info("wrote {}", (directory->path() / file.name).string());
  }
  context.out << (options.json ? compare::to_text(to_json(results.table, provenance)) : to_markdown(shown));
}

}  // namespace fiberchain::app
