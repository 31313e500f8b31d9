#pragma once

#include <cstdint>

#include "dem/assembly/assembly.hpp"
#include "dem/io/packing_scene.hpp"

namespace fiberchain::compare {

/// Batches of fibers that are still to come.
class BatchQueue {
 public:
  /// Those after the steps that the assembly has done.
  BatchQueue(const dem::io::PackingScene& scene, const dem::Assembly& assembly);

  /// When the next comes; after every step if none does.
  std::int64_t next_step() const;

  /// Puts in what is due after the steps done.
  /// @throws dem::NoRoom
  void insert_due(dem::Assembly& assembly);

 private:
  const dem::io::PackingScene& scene_;
  double step_;
  int next_ = 1;
};

}  // namespace fiberchain::compare
