#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/bench/row.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"

// The precision problems as tables, Markdown and figures.
namespace fiberchain::compare {

/// A row per method and setting of every problem.
dem::Table precision_table(const std::vector<PrecisionProblem>& problems);

/// An error that one may want.
struct WantedError {
  double value;
  const char* text;  ///< in Markdown
};
inline constexpr WantedError wanted_errors[] = {
    {1e-2, "10⁻²"}, {1e-3, "10⁻³"}, {1e-4, "10⁻⁴"}, {1e-6, "10⁻⁶"}};

/// For every problem and wanted error the cheapest method of all and, where it is another, the cheapest that
/// follows the motion in time; beside it the paper's way at the cheapest of its settings that keeps the
/// error, if any.
dem::Table wanted_table(const std::vector<PrecisionProblem>& problems);

/// The same for reading: a line per problem, a column per wanted error, "method, setting: run time" in the
/// cells.
std::string wanted_markdown(const std::vector<PrecisionProblem>& problems);

/// What was not measured and why, and against what the errors are, as Markdown.
std::string precision_notes(const std::vector<PrecisionProblem>& problems);

/// Run time against error and, as "ID-work", bond evaluations against error, of every problem.
std::vector<std::pair<std::string, Figure>> precision_figures(const std::vector<PrecisionProblem>& problems);

}  // namespace fiberchain::compare
