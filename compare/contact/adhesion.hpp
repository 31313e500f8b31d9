#pragma once

#include <string>

#include "compare/contact/impact_case.hpp"

// Two spheres that adhere and meet head on, through the whole engine.
namespace fiberchain::compare {

struct AdhesionCase {
  std::string law;          ///< jkr or dmt
  double work_of_adhesion;  ///< [J/m^2]
  ImpactBody first, second;
  double speed;  ///< of approach [m/s]
  double restitution = 1;
};

/// Soft beads of half a millimeter (R* a quarter of one), and larger ones of another modulus, in no round
/// numbers.
AdhesionCase adhesion_case(const std::string& law, double speed_over_sticking);

reference::HertzPair hertz_pair_of(const AdhesionCase& adhesion);

struct AdhesionOutcome {
  bool parted = false;
  double restitution = 0;    ///< speed after over before; 0 where they hold each other
  double pull = 0;           ///< largest, by a parabola through the largest three [N]
  double first_force = 0;    ///< at the first step in contact, positive where pressed [N]
  double last_overlap = 0;   ///< at the last one [m]
  double work_off = 0;       ///< largest difference of the force from the law's curve over the pull-off force
  double taken = 0;          ///< energy booked as taken along the normal, of one contact [J]
  double energy_change = 0;  ///< of the whole account from start to end, over the kinetic energy of approach
};

/// The step that the program chooses [s].
double default_step(const AdhesionCase& adhesion);

AdhesionOutcome marched_adhesion(const AdhesionCase& adhesion, double step, double phase);

}  // namespace fiberchain::compare
