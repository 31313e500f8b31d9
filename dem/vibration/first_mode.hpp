#pragma once

#include "dem/model/fiber.hpp"

namespace fiberchain::dem {

/// First bending mode of the straight chain clamped at its first sphere, a small motion proportional to
/// Re(exp(lambda t)).
struct FirstMode {
  double frequency;  ///< |lambda| [rad/s]
  double damping;    ///< -Re(lambda)/|lambda|
  double period;     ///< 2 pi/Im(lambda) [s]
};

/// By inverse iteration on the chain's stiffness, and the dashpots' work on the undamped mode: exact to
/// second order in what couples the modes. Throws InvalidInput for a fiber that makes no sense or whose first
/// mode is overdamped.
FirstMode first_mode(const Fiber& fiber);

}  // namespace fiberchain::dem
