#pragma once

#include <boost/timer/progress_display.hpp>
#include <cstddef>
#include <memory>
#include <mutex>
#include <ostream>

namespace fiberchain::dem {

/// A progress bar for people. Threads may share it.
class Progress {
 public:
  /// No bar at all: for a pipe, a log file, a test.
  Progress() = default;

  /// A bar of `total` units of work on that stream, begun now.
  Progress(std::ostream& stream, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Ends the bar's line if the work was left unfinished.
  ~Progress();

  void advance();

 private:
  std::mutex mutex_;
  std::ostream* stream_ = nullptr;
  std::unique_ptr<boost::timer::progress_display> bar_;
};

/// Columns of the terminal at standard error; 80 where it does not say.
std::size_t terminal_width();

/// Whether standard error is a terminal, so that someone watches.
bool someone_watches();

}  // namespace fiberchain::dem
