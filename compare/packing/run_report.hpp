#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/packing/run_session.hpp"
#include "compare/results/figure.hpp"
#include "compare/results/table.hpp"

namespace fiberchain::compare {

/// One row: what was run, how it stands at the end, and what it took.
Table packing_run_table(const PackingJob& job, const PackingEndState& end);

/// "-bending" and "-energy" by the end of their names, from the log of the whole run.
std::vector<std::pair<std::string, Figure>> packing_run_figures(const PackingJob& job, const Table& log);

}  // namespace fiberchain::compare
