#include "dem/parallel/thread_pool.hpp"

#include "dem/parallel/spin_wait.hpp"

namespace fiberchain::dem {
namespace {

/// Returns when `value` is no longer `old`.
unsigned wait_for_change(const std::atomic<unsigned>& value, unsigned old) {
  for (int n = 0; n < spin_count; ++n) {
    const unsigned now = value.load(std::memory_order_acquire);
    if (now != old) return now;
    spin_wait();
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int threads) : shares_(threads) {
  for (int t = 1; t < threads; ++t) workers_.emplace_back([this, t] { serve(t); });
}

ThreadPool::~ThreadPool() {
  over_.store(true);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::do_all(int thread) {
  const int n = threads();
  for (int k = 0; k < n; ++k) {
    Share& share = shares_[(thread + k) % n];
    for (int i = share.next.fetch_add(1, std::memory_order_relaxed); i < share.end;
         i = share.next.fetch_add(1, std::memory_order_relaxed)) {
      call_(what_, i, thread);
    }
  }
}

void ThreadPool::start_and_finish() {
  const auto helpers = static_cast<unsigned>(workers_.size());
  const long n = threads();
  for (long t = 0; t < n; ++t) {
    shares_[t].next.store(static_cast<int>(count_ * t / n), std::memory_order_relaxed);
    shares_[t].end = static_cast<int>(count_ * (t + 1) / n);
  }
  done_.store(0, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  do_all(0);
  for (unsigned done = done_.load(std::memory_order_acquire); done != helpers;)
    done = wait_for_change(done_, done);
}

void ThreadPool::serve(int thread) {
  unsigned round = 0;
  while (true) {
    round = wait_for_change(round_, round);
    if (over_.load()) return;
    do_all(thread);
    done_.fetch_add(1, std::memory_order_release);
    done_.notify_one();
  }
}

}  // namespace fiberchain::dem
