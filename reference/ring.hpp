#pragma once

#include "reference/tip_state.hpp"

namespace fiberchain::reference {

/// Inextensible beam under a moment M at its free end: an arc of a circle of radius E I / M.
/// `moment` is M L / (E I), any finite value; 2 pi closes the beam to a ring (y = 0, x = 1, angle = 2 pi).
/// Throws InvalidArgument.
TipState end_moment_tip(double moment);

}  // namespace fiberchain::reference
