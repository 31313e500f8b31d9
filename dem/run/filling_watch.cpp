#include "dem/run/filling_watch.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <utility>

#include "dem/record/progress.hpp"

namespace fiberchain::dem {
namespace {

using Clock = std::chrono::steady_clock;

class Display {
 public:
  Display(std::function<bool()> asked_to_stop, Say say, std::ostream& terminal, bool watched)
      : asked_to_stop_(std::move(asked_to_stop)),
        say_(std::move(say)),
        terminal_(terminal),
        watched_(watched) {}
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display() {
    if (on_terminal_) terminal_ << std::endl;
  }

  void tell(const InsertionProgress& now) {
    const std::string words = fmt::format("filling: {} of {} fibers placed, attempt {} for the next",
                                          now.placed, now.fibers, now.attempts);
    if (asked_to_stop_()) throw Interrupted("stopped while " + words);
    const auto pause = watched_ ? std::chrono::milliseconds(333) : std::chrono::milliseconds(10000);
    if (Clock::now() - last_ < pause) return;
    last_ = Clock::now();
    if (!watched_) return say_(words);
    on_terminal_ = true;
    const std::size_t width = terminal_width() - 1;
    terminal_ << fmt::format("\r{:<{}}", words.substr(0, width), width) << std::flush;
  }

 private:
  std::function<bool()> asked_to_stop_;
  Say say_;
  std::ostream& terminal_;
  bool watched_, on_terminal_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

InsertionWatch filling_watch(std::function<bool()> asked_to_stop, Say say, std::ostream& terminal,
                             bool watched) {
  const auto display = std::make_shared<Display>(std::move(asked_to_stop), std::move(say), terminal, watched);
  return [display](const InsertionProgress& now) { display->tell(now); };
}

}  // namespace fiberchain::dem
