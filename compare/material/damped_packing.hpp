#pragma once

#include <vector>

#include "compare/packing/case.hpp"

// The same packing of fibers damped in three ways.
namespace fiberchain::compare {

struct DampedPackingPlan {
  int fibers = 300;
  int seeds = 1;
  double bond_damping = 1;  ///< xi_b
  double duration = 0.4;    ///< [s]
};

/// Damping ratio of the first bending mode of these fibers when free, by xi_b; and the loss factor of the
/// material that has the same.
struct EqualDamping {
  double damping;
  double loss_factor;
};
EqualDamping equal_damping(double bond_damping);

/// Of each seed three: undamped fibers, the paper's dashpots, a flat loss factor with the same damping of the
/// first free bending mode.
std::vector<PackingCase> damped_packings(const DampedPackingPlan& plan);

/// "elastic", "viscous" or "flat".
std::string damper_of(const PackingCase& asked);

/// When the root mean square speed was above a part of its largest for the last time [s].
double settle_time(const PackingRun& run, double part = 0.05);

}  // namespace fiberchain::compare
