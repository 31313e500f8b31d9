#include "compare/app/stop_signals.hpp"

namespace fiberchain::app {
namespace {

// A handler has no other way to tell anybody.
volatile std::sig_atomic_t last_signal = 0;

void remember(int signal) { last_signal = signal; }

}  // namespace

StopSignals::StopSignals() {
  last_signal = 0;
  struct sigaction action {};
  action.sa_handler = &remember;
  action.sa_flags =
      static_cast<int>(SA_RESTART | SA_RESETHAND);  // writes go on; the second signal is the system's
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], nullptr, &before_[i]);
    // what the shell had us ignore, as in the background or under nohup, stays ignored
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before_[i], nullptr);
}

int StopSignals::received() const { return last_signal; }

}  // namespace fiberchain::app
