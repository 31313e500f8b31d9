#pragma once

#include <cstdint>

#include "dem/motion/lanes/lane_array.hpp"
#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

/// The numbers of all spheres, fiber after fiber, and behind them a few rows that pad whole vectors.
struct SphereRows {
  static constexpr int pads = 3;

  std::int64_t count = 0;
  LaneArray position, motion, load;
  LaneArray orientation;  ///< empty where it is not followed

  SphereRows() = default;
  SphereRows(std::int64_t spheres, bool oriented)
      : count(spheres),
        position((spheres + pads) * position_numbers + row_overhang),
        motion((spheres + pads) * motion_numbers + row_overhang),
        load((spheres + pads) * load_numbers + row_overhang),
        orientation(oriented ? (spheres + pads) * orientation_numbers + row_overhang : 0) {}

  bool oriented() const { return orientation.size() > 0; }

  Vec<double, 3> place(std::int64_t sphere) const {
    const double* x = position.data() + sphere * position_numbers;
    return {x[0], x[1], x[2]};
  }
};

}  // namespace fiberchain::dem
