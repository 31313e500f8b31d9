#pragma once

#include <string>
#include <vector>

#include "compare/app/commands.hpp"

namespace fiberchain::app {

/// The manual page fiberchain(1) in roff, from what commands say of themselves.
std::string manual_page(const std::vector<Command>& commands);

}  // namespace fiberchain::app
