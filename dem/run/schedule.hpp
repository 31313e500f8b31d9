#pragma once

#include <algorithm>
#include <cstdint>

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Steps that divide a run into so many intervals, equal but for one step: 0, ..., steps. Of no intervals:
/// none.
class EvenSteps {
 public:
  EvenSteps(std::int64_t steps, int intervals)
      : steps_(steps), intervals_(std::min<std::int64_t>(intervals, steps)) {}

  bool any() const { return intervals_ > 0; }
  /// The last at or before this one, where there are any.
  std::int64_t at_or_before(std::int64_t step) const { return at(index_of(step)); }
  bool holds(std::int64_t step) const { return any() && at(index_of(step)) == step; }
  /// The last before this one; -1 without.
  std::int64_t before(std::int64_t step) const { return !any() || step <= 0 ? -1 : at(index_of(step - 1)); }
  /// The first after this one, or the run's end.
  std::int64_t after(std::int64_t step) const {
    return !any() || step >= steps_ ? steps_ : at(index_of(step) + 1);
  }

 private:
  std::int64_t at(std::int64_t n) const { return n * steps_ / intervals_; }
  /// Of the last at or before this step.
  std::int64_t index_of(std::int64_t step) const {
    const std::int64_t n = step * intervals_ / steps_;
    return n < intervals_ && at(n + 1) <= step ? n + 1 : n;
  }

  std::int64_t steps_, intervals_;
};

/// When a run does what.
struct RunSchedule {
  RunSchedule(const PackingOutput& output, std::int64_t steps)
      : samples(steps, output.samples),
        frames(steps, output.frames),
        checkpoints(steps, output.checkpoints) {}

  std::int64_t after(std::int64_t step) const {
    return std::min({samples.after(step), frames.after(step), checkpoints.after(step)});
  }

  EvenSteps samples, frames, checkpoints;
};

}  // namespace fiberchain::dem
