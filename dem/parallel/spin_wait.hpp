#pragma once

#include <thread>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace fiberchain::dem {

/// Between two looks at what another thread is about to change.
inline void spin_wait() {
#if defined(__x86_64__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

/// Looks before a thread lets others have the processor: some 20 microseconds.
inline constexpr int spin_count = 400;

}  // namespace fiberchain::dem
