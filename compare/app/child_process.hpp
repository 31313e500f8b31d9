#pragma once

#include <functional>
#include <string>
#include <vector>

namespace fiberchain::app {

/// How a run of this program by itself ended.
struct ChildEnd {
  int status = 0;  ///< exit status, or 128 + the signal that ended it
  std::string out, errors;
};

/// Runs this program with these arguments, behind its name. A signal that `asked_to_stop` tells of is sent on
/// to it once. Several may run at a time, each called from a thread of its own.
/// @throws std::runtime_error if it cannot be run
ChildEnd run_child(const std::vector<std::string>& arguments, const std::function<int()>& asked_to_stop);

}  // namespace fiberchain::app
