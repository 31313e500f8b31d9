#pragma once

#include <array>
#include <csignal>
#include <cstddef>
#include <string>

namespace fiberchain::app {

/// While it lives, SIGINT, SIGTERM and SIGHUP ask a run to stop instead of ending the program; a second one
/// ends it at once. Only one at a time.
class StopSignals {
 public:
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
  static constexpr std::size_t count = signals.size();

  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  /// The signal that came, 0 if none did.
  int received() const;

 private:
  std::array<struct sigaction, count> before_{};
};

/// While it lives, the same signals end the program at once, as they would by themselves, but first remove an
/// empty directory that was made for results and say that nothing is kept. Only one at a time.
class LeaveNothing {
 public:
  /// @param directory "" if there is none to remove
  explicit LeaveNothing(const std::string& directory);
  LeaveNothing(const LeaveNothing&) = delete;
  LeaveNothing& operator=(const LeaveNothing&) = delete;
  ~LeaveNothing();

 private:
  std::array<struct sigaction, StopSignals::count> before_{};
};

}  // namespace fiberchain::app
