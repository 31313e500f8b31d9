#include "dem/chain/arc_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

Chain<3> arc_chain(const Fiber& fiber) {
  const double angle = fiber.rest_angle;
  const double largest = 2 * std::numbers::pi / std::max(fiber.aspect_ratio + 1, 3);
  if (!(std::abs(angle) <= largest)) {
    throw InvalidInput(
        fmt::format("an arc of {:.6g} rad a bond is not allowed: at most {:.6g}, or the fiber meets itself",
                    angle, largest));
  }
  Fiber straight = fiber;
  straight.rest_angle = 0;
  Chain<3> chain = straight_chain<3>(straight);
  chain.fiber.rest_angle = angle;
  if (angle == 0) return chain;
  Vec<double, 3> place{};
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    chain.poses[static_cast<std::size_t>(i)] = {place, rotation({0, 0, i * angle})};
    const double along = (i + 0.5) * angle;
    place = place + bond_length(fiber) * Vec<double, 3>{std::cos(along), std::sin(along), 0};
  }
  return chain;
}

}  // namespace fiberchain::dem
