#pragma once

#include <functional>
#include <ostream>

#include "dem/insertion/random_insertion.hpp"
#include "dem/model/interrupted.hpp"
#include "dem/run/files.hpp"

namespace fiberchain::dem {

/// Shows how far a filling is, on the terminal if somebody watches, else as a message every ten seconds;
/// throws Interrupted when it is asked to stop.
InsertionWatch filling_watch(std::function<bool()> asked_to_stop, Say say, std::ostream& terminal,
                             bool watched);

}  // namespace fiberchain::dem
