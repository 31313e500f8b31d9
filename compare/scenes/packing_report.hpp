#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"
#include "dem/run/session.hpp"

namespace fiberchain::compare {

/// One row: what was run, how it stands at the end, and what it took.
dem::Table packing_run_table(const dem::PackingJob& job, const dem::PackingEndState& end);

/// "-bending" and "-energy" by the end of their names, from the log of the whole run.
std::vector<std::pair<std::string, Figure>> packing_run_figures(const dem::PackingJob& job,
                                                                const dem::Table& log);

}  // namespace fiberchain::compare
