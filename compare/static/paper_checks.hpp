#pragma once

#include "compare/study/validation.hpp"

namespace fiberchain::compare {

/// The paper's statements on Figs 3 and 4, the incremental form and the aspect ratios it recommends.
Checks paper_static_checks();

}  // namespace fiberchain::compare
