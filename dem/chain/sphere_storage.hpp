#pragma once

#include <cstdint>

#include "dem/math/vec.hpp"
#include "dem/simd/lane_array.hpp"
#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {

/// The numbers of all spheres, fiber after fiber, and behind them a few rows that pad whole vectors. What
/// acts on them from outside of their fibers is in ForceBuffers.
struct SphereStorage {
  static constexpr int pads = 3;

  std::int64_t count = 0;
  LaneArray position_radius, velocity_spin;
  LaneArray orientation;  ///< empty where it is not followed

  SphereStorage() = default;
  SphereStorage(std::int64_t spheres, bool oriented)
      : count(spheres),
        position_radius((spheres + pads) * position_radius_size),
        velocity_spin((spheres + pads) * velocity_spin_size),
        orientation(oriented ? (spheres + pads) * quaternion_size : 0) {}

  bool oriented() const { return orientation.size() > 0; }
  double* position_row(std::int64_t sphere) { return position_radius.data() + sphere * position_radius_size; }
  double* velocity_row(std::int64_t sphere) { return velocity_spin.data() + sphere * velocity_spin_size; }

  Vec<double, 3> position(std::int64_t sphere) const {
    return three(position_radius.data() + sphere * position_radius_size);
  }
  double radius(std::int64_t sphere) const {
    return position_radius.data()[sphere * position_radius_size + radius_offset];
  }
  Vec<double, 3> velocity(std::int64_t sphere) const {
    return three(velocity_spin.data() + sphere * velocity_spin_size);
  }
  Vec<double, 3> spin(std::int64_t sphere) const {
    return three(velocity_spin.data() + sphere * velocity_spin_size + spin_offset);
  }

 private:
  static Vec<double, 3> three(const double* x) { return {x[0], x[1], x[2]}; }
};

}  // namespace fiberchain::dem
