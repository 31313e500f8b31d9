#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "dem/parallel/partition.hpp"
#include "dem/simd/lane_array.hpp"

namespace fiberchain::dem {

/// Rows of loads, from the sphere `first` on.
struct LoadRange {
  double* rows;
  std::int64_t first;
};

/// Force and moment from outside the fiber on the spheres of a part, from the contacts' work to the motion after it: rows
/// of `load_size`. Partition hand arrays on to each other, a thread its own ones, the one given back last first, so that
/// its loads stay in its inner cache, however many spheres there are.
class ForceBuffers {
 public:
  ForceBuffers() = default;
  ForceBuffers(const Partition& parts, int threads);

  /// Those of a part; zeros if it had none.
  LoadRange take(int part, int thread);
  /// Of a part that has taken them.
  LoadRange of(int part) const { return {rows_[part], parts_.begin(part)}; }
  /// They are zero again.
  void give_back(int part, int thread);

  /// `load_size` a sphere, of all parts, which have taken them.
  std::vector<double> all() const;
  /// The first `count` of these numbers; what stands behind them stays. All parts have taken theirs then.
  void set(const double* numbers, std::size_t count);

 private:
  Partition parts_;
  std::vector<double*> rows_;  ///< of each part; null if it has none
  std::vector<std::vector<double*>> free_;  ///< of each thread
  std::vector<LaneArray> arrays_;
  std::size_t size_ = 0;       ///< of each array
  std::unique_ptr<std::mutex> mutex_;
};

}  // namespace fiberchain::dem
