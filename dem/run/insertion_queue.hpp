#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/random_insertion.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Batches of fibers still to be inserted.
class InsertionQueue {
 public:
  /// Batches behind those that are in: `inserted` has the number of fibers of each of their groups, in order.
  InsertionQueue(const PackingScene& scene, const Assembly& assembly, std::vector<std::int64_t> inserted,
                 InsertionWatch watch = {});

  /// Step of the next insertion; the largest integer if none is left. Where a batch waits for room it is
  /// tried ten times an interval.
  std::int64_t next_step(std::int64_t now) const;

  /// Inserts the batches due after the steps done.
  /// @throws NoRoom naming batch, time and how many went in, where the scene says that this is the end
  void insert_due(Assembly& assembly);

  const std::vector<std::int64_t>& inserted() const { return inserted_; }
  int next() const { return next_; }  ///< number of the first batch that is not in, 0 for the first of all

 private:
  bool insert_batch(Assembly& assembly);

  const PackingScene& scene_;
  double step_;
  std::vector<std::int64_t> inserted_;
  InsertionWatch watch_;
  int next_ = 1;
};

}  // namespace fiberchain::dem
