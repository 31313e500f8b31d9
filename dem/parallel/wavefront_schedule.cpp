#include "dem/parallel/wavefront_schedule.hpp"

#include "dem/parallel/spin_wait.hpp"

namespace fiberchain::dem {

void WavefrontSchedule::wait_until_done(const std::atomic<int>& piece) {
  for (int n = 0; piece.load(std::memory_order_acquire) != done; ++n) {
    if (n < spin_count) {
      spin_wait();
    } else {
      std::this_thread::yield();
    }
  }
}

}  // namespace fiberchain::dem
