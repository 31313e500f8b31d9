#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "dem/parallel/thread_pool.hpp"

namespace fiberchain::dem {

/// Calls work(i) for i in [0, count), in this order, on `threads` threads of a pool of its own. Each i writes
/// its own results, so the outcome does not depend on the number of threads. After an exception no more calls
/// are begun; the first one is thrown here.
template <class Work>
void parallel_for(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex mutex;
  const std::size_t most = std::max<std::size_t>(count, 1);
  ThreadPool pool(static_cast<int>(std::min<std::size_t>(std::max(threads, 1), most)));
  pool.for_each_thread([&](int) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  });
  if (error) std::rethrow_exception(error);
}

}  // namespace fiberchain::dem
