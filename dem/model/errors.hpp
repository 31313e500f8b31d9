#pragma once

#include <stdexcept>

namespace fiberchain::dem {

/// A value that makes no physical sense; the message names it, its value and what is allowed.
struct InvalidInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A time march that left the finite numbers; the message names step, time, fiber, sphere and likely cause.
struct Diverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An iteration that did not reach its tolerance within its budget.
struct NoConvergence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Fibers that do not go in where they were asked to; the message says how many did and what to change.
struct NoRoom : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fiberchain::dem
