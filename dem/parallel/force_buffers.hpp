#pragma once

#include <cstddef>
#include <vector>

#include "dem/parallel/index_stacks.hpp"
#include "dem/parallel/partition.hpp"
#include "dem/simd/lane_array.hpp"

namespace fiberchain::dem {

/// Rows of loads, from the sphere `first` on.
struct LoadRange {
  double* rows;
  std::int64_t first;
};

/// Force and moment from outside the fiber on the spheres of a part, from the contacts' work to the motion
/// after it: rows of `load_size`. A LIFO pool of buffers for each thread: the next one taken is still in the
/// thread's L2 cache, however many spheres there are. Nothing is locked.
class ForceBuffers {
 public:
  ForceBuffers() = default;
  ForceBuffers(const Partition& parts, int threads);

  /// The buffer of a part; zeros if it had none. Different parts may take and give back at the same time.
  LoadRange take(int part, int thread);
  /// Of a part that has taken its buffer.
  LoadRange of(int part) const { return {rows_[part], parts_.begin(part)}; }
  /// The buffer of a part, zero again.
  void give_back(int part, int thread);

  /// `load_size` a sphere, of all parts, which have taken their buffers.
  std::vector<double> all() const;
  /// The first `count` of these numbers; those behind them stay. All parts have taken their buffers then.
  void set(const double* numbers, std::size_t count);

 private:
  int free_buffer(int thread);

  Partition parts_;
  std::vector<double*> rows_;  ///< of each part; null if it has no buffer
  std::vector<int> buffer_;    ///< of each part that has one
  IndexStacks free_;           ///< buffers of each thread; on the last stack those not allocated yet
  int threads_ = 0;
  std::vector<LaneArray> arrays_;  ///< as many as parts, allocated when first taken
  std::size_t size_ = 0;           ///< of each array
};

}  // namespace fiberchain::dem
