#include "compare/packing/batch_queue.hpp"

#include <limits>
#include <utility>

#include "dem/io/packing_setup.hpp"

namespace fiberchain::compare {

BatchQueue::BatchQueue(const dem::io::PackingScene& scene, const dem::Assembly& assembly)
    : scene_(scene), step_(assembly.step()) {
  while (next_step() <= assembly.steps()) ++next_;
}

std::int64_t BatchQueue::next_step() const {
  if (next_ >= scene_.batches.number) return std::numeric_limits<std::int64_t>::max();
  return dem::io::batch_step(scene_, next_, step_);
}

void BatchQueue::insert_due(dem::Assembly& assembly) {
  for (; next_step() <= assembly.steps(); ++next_) {
    for (dem::FiberGroup& group : dem::io::packing_batch(scene_, next_, assembly.time(), assembly.placed())) {
      assembly.insert(std::move(group));
    }
  }
}

}  // namespace fiberchain::compare
