#pragma once

#include <functional>
#include <ostream>
#include <stdexcept>

#include "dem/insertion/random_insertion.hpp"
#include "dem/run/files.hpp"

namespace fiberchain::dem {

/// A filling that was asked to stop.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Shows how far a filling is, on the terminal if somebody watches, else as a message every ten seconds;
/// throws Interrupted when it is asked to stop.
InsertionWatch filling_watch(std::function<bool()> asked_to_stop, Say say, std::ostream& terminal,
                             bool watched);

}  // namespace fiberchain::dem
