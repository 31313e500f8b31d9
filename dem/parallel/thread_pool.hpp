#pragma once

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "dem/parallel/idle_times.hpp"

namespace fiberchain::dem {

/// Threads that share loops. They look for work for two milliseconds, leaving their processor to whoever
/// wants it, and then sleep. Where the system gives no more threads, there are fewer.
class ThreadPool {
 public:
  using Clock = std::chrono::steady_clock;

  /// `threads` with the caller.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// From now on, between two loops: sum the times that threads are idle.
  void measure_idle_times();
  bool idle_times_measured() const { return measured_; }
  IdleTimes idle_times() const { return idle_; }
  /// What a thread has waited within a loop [s], for what others have taken.
  void add_wait(int thread, double time) { shares_[thread].waited += time; }

  /// work(i, thread) for all i below `count`, each thread consecutive ones of its own, then what others have
  /// left; back when all are done. `work` must not throw.
  template <class Work>
  void parallel_for(int count, Work&& work) {
    if (workers_.empty()) {
      for (int i = 0; i < count; ++i) work(i, 0);
      return;
    }
    call_ = [](void* what, int i, int thread) {
      (*static_cast<std::remove_reference_t<Work>*>(what))(i, thread);
    };
    what_ = &work;
    count_ = count;
    start_and_finish();
  }

  /// work(thread), as often as there are threads, by those that are free; back when all are done. `work` must
  /// not throw.
  template <class Work>
  void for_each_thread(Work&& work) {
    parallel_for(threads(), [&](int, int thread) { work(thread); });
  }

 private:
  void start_and_finish();
  void do_all(int thread);
  void take_all(int thread);
  void add_idle_times(Clock::time_point begun);
  void serve(int thread);

  void (*call_)(void*, int, int) = nullptr;
  void* what_ = nullptr;
  int count_ = 0;
  /// Of each thread: its next i and its last.
  struct alignas(64) Share {
    std::atomic<int> next{0};
    int end = 0;
    Clock::time_point begun, ended;  ///< of the last loop, where measured
    double waited = 0;               ///< in it [s]
  };
  std::vector<Share> shares_;
  bool measured_ = false;
  Clock::time_point last_end_;
  IdleTimes idle_;
  std::atomic<unsigned> round_{0}, done_{0};
  std::atomic<bool> over_{false};
  std::vector<std::thread> workers_;
};

}  // namespace fiberchain::dem
