#pragma once

namespace fiberchain::dem {

/// Time that threads were without work, summed over threads [s], by what they waited for.
struct IdleTimes {
  double start = 0;         ///< a loop has begun and the thread is not there yet
  double dependencies = 0;  ///< what another thread has taken and not finished
  double end = 0;           ///< nothing left to take: the last pieces of others
  double serial = 0;        ///< between loops, what one thread does alone

  double sum() const { return start + dependencies + end + serial; }
  friend IdleTimes operator-(IdleTimes a, const IdleTimes& b) {
    a.start -= b.start, a.dependencies -= b.dependencies, a.end -= b.end, a.serial -= b.serial;
    return a;
  }
};

}  // namespace fiberchain::dem
