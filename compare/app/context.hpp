#pragma once

#include <spdlog/logger.h>

#include <memory>
#include <ostream>

#include "compare/app/stop_signals.hpp"
#include "dem/record/progress.hpp"
#include "dem/record/provenance.hpp"

namespace fiberchain::app {

/// What a command works in.
struct Context {
  dem::Provenance provenance;
  std::ostream& out;                    ///< standard output: results and nothing else
  std::ostream& bar;                    ///< standard error, for progress bars
  std::shared_ptr<spdlog::logger> log;  ///< messages, to standard error
  bool watched;                         ///< whether someone watches standard error: progress bars make sense
  mutable int stopped = 0;              ///< the signal that ended measuring before its end; 0 if none did
  mutable std::shared_ptr<LeaveNothing> leaving = nullptr;  ///< until results are delivered

  /// A bar of `total` units if someone watches.
  std::unique_ptr<dem::Progress> progress(std::size_t total) const {
    return watched ? std::make_unique<dem::Progress>(bar, total) : std::make_unique<dem::Progress>();
  }
};

/// Exit statuses of the program.
inline constexpr int kSuccess = 0;
inline constexpr int kCheckFailed = 1;  ///< a row that must hold does not
inline constexpr int kBadInput = 2;     ///< usage, scene or data
inline constexpr int kRunFailed = 3;    ///< divergence, no convergence, files that cannot be written
inline constexpr int kSignaled =
    128;  ///< and the number of the signal that stopped a run: 130 SIGINT, 143 SIGTERM

}  // namespace fiberchain::app
