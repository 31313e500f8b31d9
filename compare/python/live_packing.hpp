#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dem/model/interrupted.hpp"
#include "dem/run/insertion_queue.hpp"
#include "dem/run/session.hpp"

namespace fiberchain::python {

/// A packing in memory, marched a piece at a time: the steps of the program, without its files.
class LivePacking {
 public:
  /// @throws dem::SceneError, dem::NoRoom, dem::Interrupted
  LivePacking(dem::SceneText text, int threads, const dem::StopRequest& asked_to_stop);
  LivePacking(const LivePacking&) = delete;
  LivePacking& operator=(const LivePacking&) = delete;

  /// Made before the interpreter's lock is released for march(): while it lives all else is refused, by
  /// std::runtime_error.
  class Working {
   public:
    explicit Working(LivePacking& packing);
    ~Working();
    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;

   private:
    LivePacking& packing_;
  };

  /// So many steps, batches of fibers that are due among them; a new interval of wall forces begins before.
  /// `kept`: contacts have the forces of the last step to round-off.
  /// @throws dem::Diverged, dem::NoRoom, dem::Interrupted between two steps
  void march(std::int64_t steps, bool kept, const dem::StopRequest& asked_to_stop);

  dem::Assembly& assembly() { return require_idle(), begin_.assembly; }
  const dem::Assembly& assembly() const { return require_idle(), begin_.assembly; }
  const dem::PackingScene& scene() const { return begin_.scene; }
  const dem::StepChoice& choice() const { return begin_.choice; }
  std::int64_t total_steps() const { return begin_.steps; }  ///< of the whole run
  const std::vector<std::string>& messages() const { return messages_; }

  /// Now, as lines of the program's log have it.
  dem::RunMoment measure() const { return dem::measure(assembly(), begin_.scene); }
  /// Now, without fibers that are not there.
  dem::TrajectoryFrame frame(bool contacts) const;

 private:
  void require_idle() const;

  std::atomic<bool> at_work_ = false;
  dem::PackingJob job_;
  std::vector<std::string> messages_;
  dem::RunBegin begin_;
  std::unique_ptr<dem::InsertionQueue> batches_;
};

}  // namespace fiberchain::python
