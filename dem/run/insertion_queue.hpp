#pragma once

#include <cstdint>

#include "dem/assembly/assembly.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Batches of fibers that are still to come.
class InsertionQueue {
 public:
  /// Those after the steps that the assembly has done.
  InsertionQueue(const PackingScene& scene, const Assembly& assembly);

  /// When the next comes; after every step if none does.
  std::int64_t next_step() const;

  /// Puts in what is due after the steps done.
  /// @throws dem::NoRoom
  void insert_due(Assembly& assembly);

 private:
  const PackingScene& scene_;
  double step_;
  int next_ = 1;
};

}  // namespace fiberchain::dem
