#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/app/context.hpp"
#include "compare/app/options.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/output.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_text.hpp"

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
  /// Further pictures, by what draws them once the tables are safe.
  std::vector<std::function<std::vector<dem::OutputFile>()>> pictures = {};
};

/// Whether a command's results have pictures.
enum class Draws { no, yes };

/// The directory the results will go to, made now so that a run does not end in vain; nothing if the
/// options want no files: --json without --out. Pictures that cannot be drawn later are warned of now.
/// @throws dem::OutputError if it cannot be written to
std::optional<dem::OutputDirectory> open_output(const OutputOptions& options, const Context& context,
                                                Draws draws = Draws::yes);

/// A warning for every value of a scene that no material or fiber has.
void warn_of_values(const dem::SceneText& text, const Context& context);

/// A line for all that is odd about the meshes of a scene: open, inside-out, crossing themselves.
void tell_of_meshes(const dem::Scene& scene, const Context& context);

/// A warning if gnuplot is not installed.
void warn_without_gnuplot(const Context& context);

/// The exit status of a table of runs; an error in words if some of these `things` have not finished. `where`
/// names their table, or is empty where it is the command's own.
int status_of_failed(std::int64_t failed, std::string_view things, std::string_view where,
                     const Context& context);

/// How many of these have not finished.
template <class Runs>
std::int64_t unfinished(const Runs& runs) {
  return std::ranges::count_if(runs, [](const auto& run) { return run.status != "finished"; });
}

/// Writes the tables (CSV, Markdown), all or none, prints the rows (as JSON if asked for, else `shown` as
/// Markdown), then draws where the options want it: a picture that fails is a warning and costs nothing but
/// itself.
/// @throws dem::OutputError for tables
void deliver(const Results& results, const dem::Table& shown, const OutputOptions& options,
             const std::optional<dem::OutputDirectory>& directory, Context& context);

}  // namespace fiberchain::app
