#include "dem/run/processor_time.hpp"

#include <time.h>

namespace fiberchain::dem {

double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace fiberchain::dem
