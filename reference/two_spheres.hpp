#pragma once

#include <array>

#include "reference/hertz.hpp"

namespace fiberchain::reference {

// Two spheres, or a sphere and a wall, that collide obliquely in a plane with Hertz-Mindlin contact, as
// ordinary differential equations (no time step): the normal force max(0, k d^(3/2) + c d^(1/4) d'), a
// tangential spring
//   T' = k_t sqrt(d) s + min(d', 0) / (2 d) T                        while the contact sticks,
// whose stiffness 8 G* sqrt(R* d) softens on unloading (Thornton, Cummins & Cleary, Powder Technol. 233
// (2013) 30), a dashpot c_t d^(1/4) s beside it, and Coulomb's limit: a slider of mu F_n in series with both.
// It slides while |T + c_t d^(1/4) s| > mu F_n; the spring then stretches at the rate r that the dashpot
// allows, T + c_t d^(1/4) r = +- mu F_n, in place of s.

/// How the bodies touch.
struct ContactLaw {
  double damping_ratio = 0;  ///< zeta of c = 2 zeta sqrt(5/4 m* k), c_t = 2 zeta sqrt(5/6 m* k_t) [-]
  double friction = 0;       ///< Coulomb's mu [-]
};

/// In the plane: x from the first body to the second at the first touch, y across, spin from x to y.
struct PlanarMotion {
  std::array<double, 2> velocity{};  ///< [m/s]
  double spin = 0;                   ///< [1/s]
};

struct Impact {
  PlanarMotion first, second;        ///< when the contact has ended, at zero force
  std::array<double, 2> separation;  ///< of the centers then, from the first; of a wall's surface [m]
  double time;                       ///< of contact [s]
  double overlap;                    ///< largest [m]
  double dissipated;                 ///< kinetic energy lost [J]
  int changes;                       ///< between sticking and sliding, the start not counted
  bool starts_sliding, ends_sliding;
};

/// From the first touch to the end of contact, by CVODE with the changes between sticking and sliding
/// located. The second body may be a wall (infinite radius and mass), which keeps its motion and its
/// direction. Forces act on the line of centers, its length shared as the radii; on a wall at its surface.
/// Solid spheres, J = 2/5 m R^2. Throws InvalidArgument unless the bodies approach, zeta in [0, 1) and mu >=
/// 0; NoConvergence.
Impact collide(const ElasticBody& first, const ElasticBody& second, const ContactLaw& law,
               const PlanarMotion& first_motion, const PlanarMotion& second_motion);

}  // namespace fiberchain::reference
