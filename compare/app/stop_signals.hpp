#pragma once

#include <array>
#include <csignal>

namespace fiberchain::app {

/// While it lives, SIGINT, SIGTERM and SIGHUP ask a run to stop instead of ending the program; a second one
/// ends it at once. Only one at a time.
class StopSignals {
 public:
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  /// The signal that came, 0 if none did.
  int received() const;

 private:
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace fiberchain::app
