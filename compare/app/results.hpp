#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/app/context.hpp"
#include "compare/app/options.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/output.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::app {

/// What a command found.
struct Results {
  std::string name;     ///< of the files: NAME.csv, NAME.md
  std::string heading;  ///< of the Markdown
  dem::Table table{{}};
  std::string notes = {};  ///< paragraphs of Markdown that go with the table
  std::vector<std::pair<std::string, dem::Table>> more_tables =
      {};  ///< as NAME.csv and key of the JSON, by name
  std::vector<std::pair<std::string, compare::Figure>> figures = {};  ///< by name: NAME.svg, NAME.png
  std::vector<dem::OutputFile> more_files = {};                       ///< pictures, as they are
};

/// The directory the results will go to, made now so that a run does not end in vain; nothing if the
/// options want no files: --json without --out.
/// @throws dem::OutputError if it cannot be written to
std::optional<dem::OutputDirectory> open_output(const OutputOptions& options);

/// Writes the files (CSV, Markdown, SVG, PNG), all or none, and prints the rows: as JSON if asked for,
/// else `shown` as Markdown.
/// @throws dem::OutputError, compare::FigureError
void deliver(const Results& results, const dem::Table& shown, const OutputOptions& options,
             const std::optional<dem::OutputDirectory>& directory, Context& context);

}  // namespace fiberchain::app
