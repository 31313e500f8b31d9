#pragma once

#include <limits>

namespace fiberchain::compare {

/// What is not known or was not measured; in a table the row's status has the reason.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace fiberchain::compare
