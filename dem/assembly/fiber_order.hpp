#pragma once

#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Where the fibers of a group lie in memory: the fiber of each place, the place of each fiber.
class FiberOrder {
 public:
  FiberOrder() = default;
  /// By their numbers.
  explicit FiberOrder(std::int32_t fibers);
  /// By these, one a place.
  /// @throws InvalidInput where one is missing or named twice
  explicit FiberOrder(std::vector<std::int32_t> fiber_of_place);

  std::int32_t count() const { return static_cast<std::int32_t>(fiber_.size()); }
  std::int32_t fiber(std::int64_t place) const { return fiber_[place]; }
  std::int32_t place(std::int64_t fiber) const { return place_[fiber]; }
  const std::vector<std::int32_t>& fibers() const { return fiber_; }

 private:
  std::vector<std::int32_t> fiber_, place_;
};

/// Whether so many spheres in all are worth it: more than two inner caches hold.
bool is_worth_sorting(std::int64_t spheres);

/// Fibers with these middles [m] along a Hilbert curve: neighbors in space come to lie near each other.
/// `period`: 0 along axes that are not periodic [m].
FiberOrder order_in_space(std::vector<Vec<double, 3>> middles, const Vec<double, 3>& period);

}  // namespace fiberchain::dem
