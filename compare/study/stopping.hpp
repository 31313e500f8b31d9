#pragma once

#include <string_view>

namespace fiberchain::compare {

/// Status of a case that was not begun because its study was stopped.
inline constexpr std::string_view not_begun = "not begun";

}  // namespace fiberchain::compare
