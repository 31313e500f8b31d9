#pragma once

#include <malloc.h>
#include <unistd.h>

#include <ctime>
#include <fstream>

// What a rank takes of its machine.
namespace fiberchain::dem::mpi {

/// Of this process [s].
inline double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Of this process, without what it has given back [bytes]; 0 where the system does not say.
inline double resident_memory() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  return file >> all >> resident ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace fiberchain::dem::mpi
