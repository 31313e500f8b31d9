#include "compare/packing/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compare/render/picture.hpp"

namespace fiberchain::compare {
namespace {

/// The pictures that there are, under their letters.
struct StageFrames {
  std::string letters;
  std::vector<dem::TrajectoryFrame> frames;
};

StageFrames stage_frames(const PackingRun& run) {
  StageFrames stages;
  char letter = 'a';
  for (const PackingStage stage : kPackingStages) {
    const auto sample = find_stage(run.history, stage);
    if (sample && *sample < run.pictures.size()) {
      stages.letters += letter;
      stages.frames.push_back(frame_of(run.pictures[*sample], run.asked));
    }
    ++letter;
  }
  return stages;
}

}  // namespace

std::vector<dem::OutputFile> stage_pictures(const PackingRun& run, int threads,
                                            const dem::Provenance& provenance) {
  const auto [letters, frames] = stage_frames(run);
  PictureOptions options{.width = 1600, .height = 1000, .threads = threads};
  if (!frames.empty()) {
    options.range = shade_range(frames, shade_named(options.shade));
    options.shown = shown_bounds(frames, options.walls);
  }
  std::vector<dem::OutputFile> files;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    files.push_back({fmt::format("fig-11-{}.png", letters[n]), draw(frames[n], options, provenance).png});
  }
  if (frames.size() == std::size(kPackingStages)) {
    options.height = 1400;
    files.push_back({"fig-11.png", draw_sheet(frames, options, provenance).png});
  }
  return files;
}

}  // namespace fiberchain::compare
