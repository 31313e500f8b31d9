#pragma once

#include "reference/hertz.hpp"

namespace fiberchain::reference {

// Elastic spheres that adhere with a work of adhesion w [J/m^2]: Johnson, Kendall & Roberts, Proc. R. Soc. A
// 324 (1971) 301 (JKR), in terms of the contact radius a:
//   d = a^2/R* - sqrt(2 pi w a / E*),   F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3);
// Derjaguin, Muller & Toporov, J. Colloid Interface Sci. 53 (1975) 314 (DMT): Hertz's contact and a constant
// pull. All throw InvalidArgument unless w > 0.

double jkr_pull_off(const HertzPair& pair, double work_of_adhesion);  ///< 3/2 pi w R* [N]
double dmt_pull_off(const HertzPair& pair, double work_of_adhesion);  ///< 2 pi w R* [N]

struct JkrState {
  double overlap, force;  ///< negative: parted, pulled
};

JkrState jkr_state(const HertzPair& pair, double work_of_adhesion, double contact_radius);

double jkr_radius_at_touch(const HertzPair& pair, double work_of_adhesion);  ///< where d = 0 [m]
double jkr_radius_at_end(const HertzPair& pair, double work_of_adhesion);    ///< where d has its least [m]

/// On the branch between the least overlap and beyond, by bisection in the radius [N].
double jkr_force(const HertzPair& pair, double work_of_adhesion, double overlap);

/// What making a contact at d = 0 and breaking it at the least d loses: the integral of -F between the two,
/// by Simpson's rule in the radius [J].
double jkr_cycle_loss(const HertzPair& pair, double work_of_adhesion);

/// Speed of approach below which bodies that lose nothing else hold each other: m* v^2 / 2 is the loss [m/s].
double jkr_sticking_speed(const HertzPair& pair, double work_of_adhesion);

}  // namespace fiberchain::reference
