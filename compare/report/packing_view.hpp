#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/h5md.hpp"

/// A packing as data that a page can turn: positions to 1/65535 of the largest extent.
namespace fiberchain::compare {

struct PackingView {
  std::string json;      ///< for the page's script; has no letter that HTML knows
  std::int64_t spheres;  ///< of the last frame, all of them
  std::int64_t shown;    ///< of the last frame, that are in `json`
  std::int64_t frames;   ///< that are in `json`
  double first, last;    ///< times of the first and the last of these [s]
};

struct PackingViewLimits {
  std::int64_t spheres = 60'000;   ///< of one frame; beyond, only every n-th fiber is shown
  std::int64_t bytes = 3'000'000;  ///< of all positions; beyond, frames are left out, never the last
};

/// Frames as
///   {"size": LARGEST, "frames": [{"time": T, "low": [x,y,z], "high": ..., "runs": [fiber, spheres, radius,
///   ...],
///    "points": BASE64}, ...]}
/// with lengths over LARGEST [m] and from the common low corner; points are x, y, z of every sphere as 16-bit
/// numbers, lowest byte first, 65535 for 1.
/// @throws InputError without a sphere in the last frame
PackingView packing_view(const std::vector<dem::TrajectoryFrame>& frames,
                         const PackingViewLimits& limits = {});

/// The same of a file: frames evenly chosen.
/// @throws InputError, also if it cannot be read
PackingView packing_view(const dem::TrajectoryReader& trajectory, const PackingViewLimits& limits = {});

/// Numbers of the frames that are shown, the last among them: as many as `most`, evenly, at least one.
std::vector<std::int64_t> chosen_frames(std::int64_t frames, std::int64_t most);

}  // namespace fiberchain::compare
