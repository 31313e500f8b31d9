#include "compare/report/packing_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/errors.hpp"
#include "dem/files/base64.hpp"

namespace fiberchain::compare {
namespace {

using Point = dem::Vec<double, 3>;

constexpr std::int64_t kBytesOfPoint = 6;

/// The cube that all spheres and boxes shown are in.
struct Extent {
  Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void take(const Point& low_corner, const Point& high_corner) {
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], low_corner[c]);
      high[c] = std::max(high[c], high_corner[c]);
    }
  }
  double size() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  Point scaled(const Point& at) const { return (1 / size()) * (at - low); }
};

Extent extent_of(const std::vector<dem::TrajectoryFrame>& frames) {
  Extent extent;
  for (const dem::TrajectoryFrame& frame : frames) {
    for (const Point& at : frame.position) extent.take(at, at);
  }
  return extent;
}

std::uint16_t step_of(double part) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(part, 0.0, 1.0)));
}

void append_point(std::vector<unsigned char>& bytes, const Point& at) {
  for (int c = 0; c < 3; ++c) {
    const std::uint16_t step = step_of(at[c]);
    bytes.push_back(static_cast<unsigned char>(step & 255));
    bytes.push_back(static_cast<unsigned char>(step >> 8));
  }
}

std::string point_json(const Point& at) { return fmt::format("[{:.5g},{:.5g},{:.5g}]", at[0], at[1], at[2]); }

/// The part of the box that has fibers in it at some time: open boxes are endless upward.
std::pair<Point, Point> box_of(const dem::TrajectoryFrame& frame, const Extent& extent) {
  Point low = frame.low, high = frame.high;
  for (int c = 0; c < 3; ++c) {
    low[c] = std::max(low[c], extent.low[c] - 0.1 * extent.size());
    high[c] = std::min(high[c], extent.high[c] + 0.1 * extent.size());
  }
  return {low, high};
}

std::string frame_json(const dem::TrajectoryFrame& frame, const Extent& extent, std::int64_t every) {
  std::vector<unsigned char> bytes;
  std::vector<std::string> runs;
  std::int64_t length = 0;
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    if (frame.fiber[i] % every != 0) continue;
    append_point(bytes, extent.scaled(frame.position[i]));
    ++length;
    const std::size_t next = i + 1;
    if (next < frame.position.size() && frame.fiber[next] == frame.fiber[i] &&
        frame.radius[next] == frame.radius[i])
      continue;
    runs.push_back(fmt::format("{},{},{:.5g}", frame.fiber[i], length, frame.radius[i] / extent.size()));
    length = 0;
  }
  const auto [low, high] = box_of(frame, extent);
  return fmt::format(R"({{"time":{:.6g},"low":{},"high":{},"runs":[{}],"points":"{}"}})", frame.time,
                     point_json(extent.scaled(low)), point_json(extent.scaled(high)), fmt::join(runs, ","),
                     dem::base64(bytes.data(), bytes.size()));
}

/// Every how many-th fiber is shown.
std::int64_t stride(std::int64_t spheres, std::int64_t most) {
  return std::max<std::int64_t>(1, (spheres + most - 1) / most);
}

std::int64_t shown_of(const dem::TrajectoryFrame& frame, std::int64_t every) {
  return std::ranges::count_if(frame.fiber, [&](std::int32_t fiber) { return fiber % every == 0; });
}

}  // namespace

std::vector<std::int64_t> chosen_frames(std::int64_t frames, std::int64_t most) {
  most = std::clamp<std::int64_t>(most, 1, frames);
  std::vector<std::int64_t> chosen;
  for (std::int64_t i = 0; i < most; ++i)
    chosen.push_back(most == 1 ? frames - 1 : i * (frames - 1) / (most - 1));
  return chosen;
}

PackingView packing_view(const std::vector<dem::TrajectoryFrame>& frames, const PackingViewLimits& limits) {
  if (frames.empty() || frames.back().position.empty())
    throw InputError("the trajectory's last frame has no sphere to show");
  const Extent extent = extent_of(frames);
  const auto spheres = static_cast<std::int64_t>(frames.back().position.size());
  const std::int64_t every = stride(spheres, limits.spheres);
  std::vector<std::string> texts;
  for (const dem::TrajectoryFrame& frame : frames) texts.push_back(frame_json(frame, extent, every));
  return {.json = fmt::format(R"({{"size":{:.6g},"frames":[{}]}})", extent.size(), fmt::join(texts, ",")),
          .spheres = spheres,
          .shown = shown_of(frames.back(), every),
          .frames = static_cast<std::int64_t>(frames.size()),
          .first = frames.front().time,
          .last = frames.back().time};
}

PackingView packing_view(const dem::TrajectoryReader& trajectory, const PackingViewLimits& limits) {
  if (trajectory.frames() == 0) throw InputError("the trajectory has no frame to show");
  const dem::TrajectoryFrame last = trajectory.read(trajectory.frames() - 1);
  const auto spheres = std::min(static_cast<std::int64_t>(last.position.size()), limits.spheres);
  const std::int64_t most = limits.bytes / std::max<std::int64_t>(1, kBytesOfPoint * spheres);
  std::vector<dem::TrajectoryFrame> frames;
  for (const std::int64_t n : chosen_frames(trajectory.frames(), most)) frames.push_back(trajectory.read(n));
  return packing_view(frames, limits);
}

}  // namespace fiberchain::compare
