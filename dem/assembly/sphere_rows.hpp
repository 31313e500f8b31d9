#pragma once

#include <cstdint>

#include "dem/math/vec.hpp"
#include "dem/motion/lanes/lane_array.hpp"
#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

/// The numbers of all spheres, fiber after fiber, and behind them a few rows that pad whole vectors.
struct SphereRows {
  static constexpr int pads = 3;

  std::int64_t count = 0;
  LaneArray numbers;
  LaneArray orientation;  ///< empty where it is not followed

  SphereRows() = default;
  SphereRows(std::int64_t spheres, bool oriented)
      : count(spheres),
        numbers((spheres + pads) * row_numbers),
        orientation(oriented ? (spheres + pads) * orientation_numbers : 0) {}

  bool oriented() const { return orientation.size() > 0; }
  double* row(std::int64_t sphere) { return numbers.data() + sphere * row_numbers; }
  const double* row(std::int64_t sphere) const { return numbers.data() + sphere * row_numbers; }

  Vec<double, 3> place(std::int64_t sphere) const { return three(sphere, row_position); }
  Vec<double, 3> velocity(std::int64_t sphere) const { return three(sphere, row_velocity); }
  Vec<double, 3> spin(std::int64_t sphere) const { return three(sphere, row_spin); }

 private:
  Vec<double, 3> three(std::int64_t sphere, int at) const {
    const double* x = row(sphere) + at;
    return {x[0], x[1], x[2]};
  }
};

}  // namespace fiberchain::dem
