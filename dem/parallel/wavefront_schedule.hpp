#pragma once

#include <atomic>
#include <vector>

#include "dem/parallel/partition.hpp"
#include "dem/parallel/thread_pool.hpp"

namespace fiberchain::dem {

/// visit(part) as a thread looks at all parts: its own from the first on, then what others have left, from
/// their ends on.
template <class Visit>
void each_turn(int parts, int thread, int threads, const Visit& visit) {
  for (int k = parts * thread / threads; k < parts * (thread + 1) / threads; ++k) visit(k);
  for (int other = 1; other < threads; ++other) {
    const int whose = (thread + other) % threads;
    for (int k = parts * (whose + 1) / threads - 1; k >= parts * whose / threads; --k) visit(k);
  }
}

/// Two pieces of work a part: the first may read what the second changes of its own and of the later parts
/// that it reaches, and leaves something for them. So second(k) waits for first(k) and for first(j) of all j
/// < k that reach k, and for nothing else: a part's numbers are still in the inner cache when its second
/// piece comes.
class WavefrontSchedule {
 public:
  explicit WavefrontSchedule(int parts) : first_(parts), second_(parts) {}

  /// first(part, thread) and second(part, thread) of all parts. Neither may throw.
  template <class First, class Second>
  void run(ThreadPool& pool, const PartDependencies& reach, const First& first, const Second& second) {
    const int count = static_cast<int>(first_.size()), n = pool.threads();
    for (int k = 0; k < count; ++k) {
      first_[k].store(open, std::memory_order_relaxed);
      second_[k].store(open, std::memory_order_relaxed);
    }
    const auto try_first = [&](int k, int thread) {
      if (!take(first_[k])) return;
      first(k, thread);
      first_[k].store(done, std::memory_order_release);
    };
    const auto both = [&](int k, int thread) {
      if (!take(second_[k])) return;
      try_first(k, thread);
      const std::vector<int>& before = reach.dependencies(k);
      for (auto j = before.rbegin(); j != before.rend(); ++j) try_first(*j, thread);
      for (auto j = before.rbegin(); j != before.rend(); ++j) wait_until_done(first_[*j], pool, thread);
      wait_until_done(first_[k], pool, thread);
      second(k, thread);
    };
    pool.for_each_thread([&](int thread) { each_turn(count, thread, n, [&](int k) { both(k, thread); }); });
  }

 private:
  enum Progress : int { open, taken, done };
  static bool take(std::atomic<int>& piece) {
    int expected = open;
    return piece.load(std::memory_order_relaxed) == open &&
           piece.compare_exchange_strong(expected, taken, std::memory_order_relaxed);
  }
  static void wait_until_done(const std::atomic<int>& piece, ThreadPool& pool, int thread);

  std::vector<std::atomic<int>> first_, second_;
};

}  // namespace fiberchain::dem
