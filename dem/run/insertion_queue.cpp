#include "dem/run/insertion_queue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {

InsertionQueue::InsertionQueue(const PackingScene& scene, const Assembly& assembly,
                               std::vector<std::int64_t> inserted, InsertionWatch watch)
    : scene_(scene), step_(assembly.step()), inserted_(std::move(inserted)), watch_(std::move(watch)) {
  std::size_t groups = 0;
  while (next_ < scene_.batches.number && groups < inserted_.size())
    groups += batch_counts(scene_, next_++).size();
}

std::int64_t InsertionQueue::next_step(std::int64_t now) const {
  if (next_ >= scene_.batches.number) return std::numeric_limits<std::int64_t>::max();
  const std::int64_t due = batch_step(scene_, next_, step_);
  if (due > now || scene_.batches.no_room != NoRoomChoice::wait) return std::max(due, now);
  const auto again = std::max<std::int64_t>(1, std::llround(scene_.batches.interval / step_ / 10));
  return due + ((now - due) / again + 1) * again;
}

void InsertionQueue::insert_due(Assembly& assembly) {
  while (next_ < scene_.batches.number && batch_step(scene_, next_, step_) <= assembly.steps()) {
    if (!insert_batch(assembly)) return;
    ++next_;
  }
}

bool InsertionQueue::insert_batch(Assembly& assembly) {
  const NoRoomChoice choice = scene_.batches.no_room;
  const std::vector<InsertionCount> wanted = batch_counts(scene_, next_);
  std::vector<FiberGroup> groups;
  try {
    groups = packing_batch(scene_, next_, assembly.time(), assembly.placed(), watch_,
                           choice == NoRoomChoice::fewer ? Shortfall::accept : Shortfall::refuse);
  } catch (const NoRoom& error) {
    if (choice == NoRoomChoice::wait) return false;
    throw NoRoom(fmt::format("batch {} of {} at t = {:.6g} s found no room: {}", next_ + 1,
                             scene_.batches.number, assembly.time(), error.what()));
  }
  for (FiberGroup& group : groups) {
    inserted_.push_back(static_cast<std::int64_t>(group.fibers.size()));
    if (!group.fibers.empty()) assembly.insert(std::move(group));
  }
  return true;
}

}  // namespace fiberchain::dem
