#include "dem/parallel/wavefront_schedule.hpp"

#include "dem/parallel/spin_wait.hpp"

namespace fiberchain::dem {

void WavefrontSchedule::wait_until_done(const std::atomic<int>& piece, ThreadPool& pool, int thread) {
  if (piece.load(std::memory_order_acquire) == done) return;
  const bool measured = pool.idle_times_measured();
  const ThreadPool::Clock::time_point begun =
      measured ? ThreadPool::Clock::now() : ThreadPool::Clock::time_point{};
  for (int n = 0; piece.load(std::memory_order_acquire) != done; ++n) {
    if (n < spin_count) {
      spin_wait();
    } else {
      std::this_thread::yield();
    }
  }
  if (measured)
    pool.add_wait(thread, std::chrono::duration<double>(ThreadPool::Clock::now() - begun).count());
}

}  // namespace fiberchain::dem
