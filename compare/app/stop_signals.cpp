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
  ::sigaction(SIGINT, nullptr, &interrupt_);
  ::sigaction(SIGTERM, nullptr, &terminate_);
  // what the shell had us ignore, as in the background, stays ignored
  if (interrupt_.sa_handler != SIG_IGN) ::sigaction(SIGINT, &action, nullptr);
  if (terminate_.sa_handler != SIG_IGN) ::sigaction(SIGTERM, &action, nullptr);
}

StopSignals::~StopSignals() {
  ::sigaction(SIGINT, &interrupt_, nullptr);
  ::sigaction(SIGTERM, &terminate_, nullptr);
}

int StopSignals::received() const { return last_signal; }

}  // namespace fiberchain::app
