#pragma once

#include <vector>

#include "dem/model/fiber.hpp"

// One bond of a fiber bent to and fro by the bond law itself: what it loses in a cycle.
namespace fiberchain::compare {

/// The last cycle, of an angle that goes as a sine.
struct BendingLoop {
  double frequency;            ///< [Hz]
  std::vector<double> angle;   ///< of the bond [rad], the first once more at the end
  std::vector<double> moment;  ///< that bends it [N m]
  double loss;  ///< energy lost in the cycle over 2 pi times the largest that its storage modulus stores [-]
  double storage;  ///< moment in phase with the angle, over the angle [N m]
};

struct BendingDrive {
  double amplitude = 1e-3;  ///< [rad]
  int cycles = 8;           ///< for the branches to settle
  int steps = 400;          ///< a cycle
};

/// The law of bonds with branches in the total form, dashpots of the fiber beside them.
BendingLoop bending_loop(const dem::Fiber& fiber, double frequency, const BendingDrive& drive = {});

/// K''/K' of the fiber's bending, branches and dashpots, by formula. Frequency in Hz.
double bending_loss_factor(const dem::Fiber& fiber, double frequency);

}  // namespace fiberchain::compare
