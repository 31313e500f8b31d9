#include "dem/parallel/thread_pool.hpp"

#include <system_error>

#include "dem/parallel/spin_wait.hpp"

namespace fiberchain::dem {
namespace {

/// How long a thread without work looks for it before it sleeps: a thread that is woken comes late by as much
/// as a whole loop takes, and on the waker's processor.
constexpr std::chrono::milliseconds longest_look{2};

/// Returns when `value` is no longer `old`.
unsigned wait_for_change(const std::atomic<unsigned>& value, unsigned old) {
  for (int n = 0; n < spin_count; ++n) {
    const unsigned now = value.load(std::memory_order_acquire);
    if (now != old) return now;
    spin_wait();
  }
  const ThreadPool::Clock::time_point until = ThreadPool::Clock::now() + longest_look;
  while (ThreadPool::Clock::now() < until) {
    std::this_thread::yield();  // to another program, if it wants the processor
    const unsigned now = value.load(std::memory_order_acquire);
    if (now != old) return now;
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int threads) : shares_(threads) {
  workers_.reserve(static_cast<std::size_t>(threads));
  try {
    for (int t = 1; t < threads; ++t) workers_.emplace_back([this, t] { serve(t); });
  } catch (const std::system_error&) {  // those there are do the work
  }
}

ThreadPool::~ThreadPool() {
  over_.store(true);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::measure_idle_times() {
  measured_ = true;
  last_end_ = Clock::now();
}

void ThreadPool::do_all(int thread) {
  if (measured_) shares_[thread].begun = Clock::now();
  take_all(thread);
  if (measured_) shares_[thread].ended = Clock::now();
}

void ThreadPool::take_all(int thread) {
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
  const Clock::time_point begun = measured_ ? Clock::now() : last_end_;
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
  if (measured_) add_idle_times(begun);
}

void ThreadPool::add_idle_times(Clock::time_point begun) {
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  const Clock::time_point now = Clock::now();
  idle_.serial += seconds(begun - last_end_) * static_cast<double>(workers_.size());
  for (Share& share : shares_) {
    idle_.start += seconds(share.begun - begun);
    idle_.dependencies += share.waited;
    idle_.end += seconds(now - share.ended);
    share.waited = 0;
  }
  last_end_ = now;
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
