#include "compare/python/live_packing.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "compare/python/scene_of.hpp"
#include "dem/run/filling_watch.hpp"

namespace fiberchain::python {
namespace {

/// Steps between two looks at whether to stop: those of the program.
constexpr std::int64_t kStride = 64;

constexpr const char* kAtWork = "this packing is stepped by another thread";

dem::PackingJob job_of(dem::SceneText text, int threads) {
  dem::PackingJob job{
      .text = std::move(text), .scene = {}, .files = {}, .threads = threads, .provenance = {}};
  job.scene = scene_of<dem::PackingScene>(job.text);
  return job;
}

/// Throws dem::Interrupted where the filling is to stop.
dem::InsertionWatch watch_of(const dem::StopRequest& asked, std::vector<std::string>& messages) {
  static std::ostringstream nowhere;
  return dem::filling_watch(
      asked, [&](const std::string& words) { messages.push_back(words); }, nowhere, false);
}

}  // namespace

LivePacking::LivePacking(dem::SceneText text, int threads, const dem::StopRequest& asked)
    : job_(job_of(std::move(text), threads)), begin_(dem::located(job_.text, [&] {
        return dem::begin_run(
            job_, [&](const std::string& words) { messages_.push_back(words); }, watch_of(asked, messages_));
      })) {
  begin_.scene.output.contacts = true;
  batches_ = std::make_unique<dem::InsertionQueue>(begin_.scene, begin_.assembly, begin_.inserted);
}

void LivePacking::march(std::int64_t steps, bool kept, const dem::StopRequest& asked) {
  dem::Assembly& assembly = begin_.assembly;
  if (steps < 0) throw dem::InvalidInput("steps below 0 are not allowed");
  assembly.begin_wall_interval();
  assembly.begin_held_interval();
  const std::int64_t end = assembly.steps() + steps;
  while (assembly.steps() < end) {
    dem::stop_if_asked(asked, "stopped");
    const std::int64_t now = assembly.steps(),
                       next = std::min({end, batches_->next_step(now), now + kStride});
    const auto forces = kept && next == end ? dem::ContactForces::kept : dem::ContactForces::not_kept;
    if (next > now) assembly.march(next - now, forces);
    batches_->insert_due(assembly);
  }
}

LivePacking::Working::Working(LivePacking& packing) : packing_(packing) {
  packing_.require_idle();
  packing_.at_work_ = true;
}

LivePacking::Working::~Working() { packing_.at_work_ = false; }

void LivePacking::require_idle() const {
  if (at_work_) throw std::runtime_error(kAtWork);
}

dem::TrajectoryFrame LivePacking::frame(bool contacts) const {
  require_idle();
  dem::PackingScene scene = begin_.scene;
  scene.output.contacts = contacts;
  return dem::present_part(dem::frame_of(begin_.assembly, scene, batches_->inserted()));
}

}  // namespace fiberchain::python
