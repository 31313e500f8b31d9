#include "dem/assembly/paired_work.hpp"

#include "dem/assembly/pause.hpp"

namespace fiberchain::dem {

void PairedWork::wait_until_done(const std::atomic<int>& piece) {
  for (int n = 0; piece.load(std::memory_order_acquire) != done; ++n) {
    if (n < patient_looks) {
      pause();
    } else {
      std::this_thread::yield();
    }
  }
}

}  // namespace fiberchain::dem
