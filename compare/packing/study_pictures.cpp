#include "compare/packing/study_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compare/render/picture.hpp"

namespace fiberchain::compare {
namespace {

/// The room up to the highest fiber that any picture shows.
void lower_the_top(std::vector<std::pair<char, dem::io::Frame>>& frames) {
  double top = 0;
  for (const auto& [letter, frame] : frames) {
    for (std::size_t i = 0; i < frame.position.size(); ++i)
      top = std::max(top, frame.position[i][2] + frame.radius[i]);
  }
  for (auto& [letter, frame] : frames) frame.high[2] = top;
}

std::vector<std::pair<char, dem::io::Frame>> stage_frames(const PackingRun& run) {
  std::vector<std::pair<char, dem::io::Frame>> frames;
  char letter = 'a';
  for (const PackingStage stage : kPackingStages) {
    const auto sample = find_stage(run.history, stage);
    if (sample && *sample < run.pictures.size())
      frames.emplace_back(letter, frame_of(run.pictures[*sample], run.asked));
    ++letter;
  }
  lower_the_top(frames);
  return frames;
}

}  // namespace

std::vector<OutputFile> stage_pictures(const PackingRun& run, int threads, const Provenance& provenance) {
  const auto frames = stage_frames(run);
  std::vector<double> speeds;
  for (const auto& [letter, frame] : frames) {
    const std::vector<double> shades = shade_of(frame, Shade::vertical_speed);
    speeds.insert(speeds.end(), shades.begin(), shades.end());
  }
  const PictureOptions options{.range = range_of(speeds), .width = 1600, .height = 1000, .threads = threads};
  std::vector<OutputFile> files;
  for (const auto& [letter, frame] : frames) {
    files.push_back({fmt::format("fig-11-{}.png", letter), draw(frame, options, provenance).png});
  }
  if (frames.size() == std::size(kPackingStages)) {
    std::vector<dem::io::Frame> all;
    for (const auto& [letter, frame] : frames) all.push_back(frame);
    PictureOptions sheet = options;
    sheet.width = 1600, sheet.height = 1400;
    files.push_back({"fig-11.png", draw_sheet(all, sheet, provenance).png});
  }
  return files;
}

}  // namespace fiberchain::compare
