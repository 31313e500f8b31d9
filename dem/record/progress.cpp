#include "dem/record/progress.hpp"

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

bool someone_watches() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace fiberchain::dem
