#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/packing/history.hpp"
#include "compare/packing/scene.hpp"
#include "compare/study/jobs.hpp"
#include "dem/trajectory/frame.hpp"

namespace fiberchain::compare {

/// What is kept of a sphere for a picture.
struct SpherePlace {
  float x, y, z;         ///< [m]
  float vertical_speed;  ///< [m/s]
};

struct PackingPicture {
  std::int64_t step;
  double time;  ///< [s]
  std::vector<SpherePlace> spheres;
};

/// The frame that is drawn; no bond angles.
dem::TrajectoryFrame frame_of(const PackingPicture& picture, const PackingCase& asked);

/// How directions of bonds are spread.
struct OrientationProfile {
  std::vector<double> against_isotropic;  ///< by classes of the polar angle, of equal width from 0 to pi/2
  double order, order_along_up, mean_polar_angle;
};

/// At the end.
struct PackingEnd {
  std::vector<double> edges;            ///< of slabs above the floor [m]
  std::vector<double> solid_fractions;  ///< of the slabs
  OrientationProfile orientation;
  double contacts_per_fiber, neighbors_per_fiber, touching_spheres, wall_contacts;
  double largest_overlap, overlap_mean;  ///< of the contacts then, over the radius
  double overlap_peak;                   ///< of all since the start
};

struct PackingRun {
  PackingCase asked;
  double step = 0;  ///< [s]
  std::int64_t steps = 0, spheres = 0;
  std::string step_set_by;
  double run_time = 0;  ///< [s]
  std::string status;   ///< "finished", or why not
  PackingHistory history;
  OrientationProfile start{};
  PackingEnd end{};
  std::vector<PackingPicture> pictures;  ///< one a sample, if asked for
};

struct PackingWatch {
  int samples = 140;  ///< intervals
  int threads = 1;
};

/// A run that blows up ends early, with its reason as status.
PackingRun run_packing(const PackingCase& asked, const PackingWatch& watch,
                       const std::function<void()>& advance = {});

/// All of them, the longest first; given back in the order asked for. `advance` is called after every sample,
/// maybe from several threads at once.
std::vector<PackingRun> run_packings(const std::vector<PackingCase>& cases, const PackingWatch& watch,
                                     const Jobs& jobs, const std::function<void()>& advance = {});

}  // namespace fiberchain::compare
