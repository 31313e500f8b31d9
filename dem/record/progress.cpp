#include "dem/record/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace fiberchain::dem {

Progress::Progress(std::ostream& stream, std::size_t total)
    : stream_(&stream), bar_(std::make_unique<boost::timer::progress_display>(total, stream)) {}

Progress::~Progress() {
  if (bar_ && bar_->count() < bar_->expected_count()) *stream_ << std::endl;
}

void Progress::advance() {
  if (!bar_) return;
  const std::scoped_lock lock(mutex_);
  ++*bar_;
}

std::size_t terminal_width() {
  winsize size{};
  constexpr std::size_t usual = 80;
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

bool someone_watches() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace fiberchain::dem
