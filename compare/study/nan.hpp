#pragma once

#include <limits>

namespace fiberchain::compare {

/// In a table: not measured, with the reason in the row's status.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace fiberchain::compare
