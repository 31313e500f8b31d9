#include "dem/run/insertion_queue.hpp"

#include <limits>
#include <utility>

#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {

InsertionQueue::InsertionQueue(const PackingScene& scene, const Assembly& assembly)
    : scene_(scene), step_(assembly.step()) {
  while (next_step() <= assembly.steps()) ++next_;
}

std::int64_t InsertionQueue::next_step() const {
  if (next_ >= scene_.batches.number) return std::numeric_limits<std::int64_t>::max();
  return batch_step(scene_, next_, step_);
}

void InsertionQueue::insert_due(Assembly& assembly) {
  for (; next_step() <= assembly.steps(); ++next_) {
    for (FiberGroup& group : packing_batch(scene_, next_, assembly.time(), assembly.placed())) {
      assembly.insert(std::move(group));
    }
  }
}

}  // namespace fiberchain::dem
