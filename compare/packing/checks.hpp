#pragma once

#include <vector>

#include "compare/packing/case.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {

/// What the paper says of Figs 11 and 12, judged by runs of several seeds: least and most xi_b without
/// friction, the least with friction, stiff fibers, half the step. What the runs do not have is left out.
std::vector<ValidationRow> packing_statements(const ValidationInput& input,
                                              const std::vector<PackingRun>& runs);

/// Small packings of three seeds for that, none at half the step: seconds, not minutes. `tables packing` has
/// them all.
std::vector<PackingCase> row_cases();

}  // namespace fiberchain::compare
