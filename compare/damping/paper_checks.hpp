#pragma once

#include "compare/study/validation.hpp"

namespace fiberchain::compare {

/// The paper's statements on bond damping and fiber damping, Figs 7 to 9 and Eq 20.
Checks paper_damping_checks();

}  // namespace fiberchain::compare
