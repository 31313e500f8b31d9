#include "compare/app/stop_signals.hpp"

#include <unistd.h>

#include <cstring>

namespace fiberchain::app {
namespace {

// A handler has no other way to tell anybody.
volatile std::sig_atomic_t last_signal = 0;

void remember(int signal) { last_signal = signal; }

// Where a handler finds the directory: it may not touch what is not as simple as this.
char made_directory[4096] = "";

void leave(int signal) {
  if (made_directory[0] != 0) ::rmdir(made_directory);  // fails, as it should, if anything is in it
  constexpr char words[] = "fiberchain: stopped: no table is written yet, nothing is kept\n";
  if (::write(STDERR_FILENO, words, sizeof words - 1) < 0) {
  }
  ::raise(signal);  // which is the system's again, once this returns
}

using Actions = std::array<struct sigaction, StopSignals::count>;

void take_signals(void (*handler)(int), int flags, Actions& before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < before.size(); ++i) {
    ::sigaction(StopSignals::signals[i], nullptr, &before[i]);
    // what the shell had us ignore, as in the background or under nohup, stays ignored
    if (before[i].sa_handler != SIG_IGN) ::sigaction(StopSignals::signals[i], &action, nullptr);
  }
}

void give_back(const Actions& before) {
  for (std::size_t i = 0; i < before.size(); ++i) ::sigaction(StopSignals::signals[i], &before[i], nullptr);
}

}  // namespace

// Writes go on; the second signal is the system's.
StopSignals::StopSignals() {
  last_signal = 0;
  take_signals(&remember, static_cast<int>(SA_RESTART | SA_RESETHAND), before_);
}

StopSignals::~StopSignals() { give_back(before_); }

int StopSignals::received() const { return last_signal; }

LeaveNothing::LeaveNothing(const std::string& directory) {
  const bool fits = directory.size() < sizeof made_directory;
  std::strncpy(made_directory, fits ? directory.c_str() : "", sizeof made_directory - 1);
  take_signals(&leave, static_cast<int>(SA_RESETHAND), before_);
}

LeaveNothing::~LeaveNothing() { give_back(before_); }

}  // namespace fiberchain::app
