#pragma once

#include <cstdint>

#include "dem/assembly/assembly.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Batches of fibers still to be inserted.
class InsertionQueue {
 public:
  /// Batches after the steps that the assembly has done.
  InsertionQueue(const PackingScene& scene, const Assembly& assembly);

  /// Step of the next insertion; the largest integer if none is left.
  std::int64_t next_step() const;

  /// Inserts the batches due after the steps done.
  /// @throws NoRoom
  void insert_due(Assembly& assembly);

 private:
  const PackingScene& scene_;
  double step_;
  int next_ = 1;
};

}  // namespace fiberchain::dem
