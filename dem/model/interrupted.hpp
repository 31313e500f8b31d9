#pragma once

#include <functional>
#include <stdexcept>

namespace fiberchain::dem {

/// What was asked to stop before its end; it has no result.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Asked now and then by what may take long: true to stop it, which throws Interrupted. Empty: never.
using StopRequest = std::function<bool()>;

inline void stop_if_asked(const StopRequest& asked, const char* what) {
  if (asked && asked()) throw Interrupted(what);
}

}  // namespace fiberchain::dem
