#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace fiberchain::compare {

/// Calls work(i) for i in [0, count) on `jobs` threads. Each i writes its own results, so the outcome does
/// not depend on the number of threads. The first exception ends the loop and is thrown here.
template <class Work>
void parallel_for(std::size_t count, int jobs, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t threads = std::min<std::size_t>(std::max(jobs, 1), std::max<std::size_t>(count, 1));
  std::vector<std::jthread> pool;
  for (std::size_t i = 1; i < threads; ++i) pool.emplace_back(run);
  run();
  pool.clear();
  if (error) std::rethrow_exception(error);
}

}  // namespace fiberchain::compare
