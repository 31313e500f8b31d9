#pragma once

#include <cstdint>
#include <limits>

#include "compare/packing/run_session.hpp"

// Where a run begins: at the start of its scene, or at a checkpoint; and the fibers that come later.
namespace fiberchain::compare {

struct RunBegin {
  dem::Assembly assembly;
  dem::StepChoice choice;
  std::int64_t steps;    ///< of the whole run
  bool resumed = false;  ///< from a checkpoint
};

/// @throws as run_packing_session
RunBegin begin_run(const PackingJob& job, const Say& say);

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
