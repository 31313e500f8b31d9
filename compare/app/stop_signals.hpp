#pragma once

#include <csignal>

namespace fiberchain::app {

/// While it lives, SIGINT and SIGTERM ask a run to stop instead of ending the program; a second one ends it
/// at once. Only one at a time.
class StopSignals {
 public:
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  /// The signal that came, 0 if none did.
  int received() const;

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
};

}  // namespace fiberchain::app
