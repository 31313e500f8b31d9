#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "dem/assembly/stripes.hpp"
#include "dem/motion/lanes/lane_array.hpp"

namespace fiberchain::dem {

/// Rows of loads, from the sphere `first` on.
struct LoadRange {
  double* rows;
  std::int64_t first;
};

/// Force and moment from outside the fiber on the spheres of a stripe, from the contacts' work to the motion after it: rows
/// of `load_numbers`. Stripes hand arrays on to each other, a thread its own ones, the one given back last first, so that
/// its loads stay in its inner cache, however many spheres there are.
class StripeLoads {
 public:
  StripeLoads() = default;
  StripeLoads(const Stripes& stripes, int threads);

  /// Those of a stripe; zeros if it had none.
  LoadRange take(int stripe, int thread);
  /// Of a stripe that has taken them.
  LoadRange of(int stripe) const { return {rows_[stripe], stripes_.begin(stripe)}; }
  /// They are zero again.
  void give_back(int stripe, int thread);

  /// `load_numbers` a sphere, of all stripes, which have taken them.
  std::vector<double> all() const;
  /// The first `count` of these numbers; what stands behind them stays. All stripes have taken theirs then.
  void set(const double* numbers, std::size_t count);

 private:
  Stripes stripes_;
  std::vector<double*> rows_;  ///< of each stripe; null if it has none
  std::vector<std::vector<double*>> free_;  ///< of each thread
  std::vector<LaneArray> arrays_;
  std::size_t size_ = 0;       ///< of each array
  std::unique_ptr<std::mutex> mutex_;
};

}  // namespace fiberchain::dem
