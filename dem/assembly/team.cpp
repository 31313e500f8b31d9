#include "dem/assembly/team.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace fiberchain::dem {
namespace {

/// Looks before a thread sleeps: some 20 microseconds.
constexpr int looks = 400;

void pause() {
#if defined(__x86_64__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

/// Returns when `value` is no longer `old`.
unsigned wait_for_change(const std::atomic<unsigned>& value, unsigned old) {
  for (int n = 0; n < looks; ++n) {
    const unsigned now = value.load(std::memory_order_acquire);
    if (now != old) return now;
    pause();
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

Team::Team(int threads) {
  for (int t = 1; t < threads; ++t) workers_.emplace_back([this, t] { serve(t); });
}

Team::~Team() {
  over_.store(true);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void Team::do_part(int thread) const {
  const long n = threads();
  const int end = static_cast<int>(count_ * (thread + 1L) / n);
  for (int i = static_cast<int>(count_ * static_cast<long>(thread) / n); i < end; ++i) call_(what_, i, thread);
}

void Team::start_and_finish() {
  const auto helpers = static_cast<unsigned>(workers_.size());
  done_.store(0, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  do_part(0);
  for (unsigned done = done_.load(std::memory_order_acquire); done != helpers;) done = wait_for_change(done_, done);
}

void Team::serve(int thread) {
  unsigned round = 0;
  while (true) {
    round = wait_for_change(round_, round);
    if (over_.load()) return;
    do_part(thread);
    done_.fetch_add(1, std::memory_order_release);
    done_.notify_one();
  }
}

}  // namespace fiberchain::dem
