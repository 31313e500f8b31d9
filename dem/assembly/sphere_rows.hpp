#pragma once

#include <cstdint>

#include "dem/math/vec.hpp"
#include "dem/motion/lanes/lane_array.hpp"
#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

/// The numbers of all spheres, fiber after fiber, and behind them a few rows that pad whole vectors. What acts on them from
/// outside of their fibers is in StripeLoads.
struct SphereRows {
  static constexpr int pads = 3;

  std::int64_t count = 0;
  LaneArray places, motions;
  LaneArray orientation;  ///< empty where it is not followed

  SphereRows() = default;
  SphereRows(std::int64_t spheres, bool oriented)
      : count(spheres),
        places((spheres + pads) * place_numbers),
        motions((spheres + pads) * motion_numbers),
        orientation(oriented ? (spheres + pads) * orientation_numbers : 0) {}

  bool oriented() const { return orientation.size() > 0; }
  double* place_row(std::int64_t sphere) { return places.data() + sphere * place_numbers; }
  double* motion_row(std::int64_t sphere) { return motions.data() + sphere * motion_numbers; }

  Vec<double, 3> place(std::int64_t sphere) const { return three(places.data() + sphere * place_numbers); }
  double radius(std::int64_t sphere) const { return places.data()[sphere * place_numbers + place_radius]; }
  Vec<double, 3> velocity(std::int64_t sphere) const { return three(motions.data() + sphere * motion_numbers); }
  Vec<double, 3> spin(std::int64_t sphere) const { return three(motions.data() + sphere * motion_numbers + motion_spin); }

 private:
  static Vec<double, 3> three(const double* x) { return {x[0], x[1], x[2]}; }
};

}  // namespace fiberchain::dem
