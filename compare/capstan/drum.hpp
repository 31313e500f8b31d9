#pragma once

#include "dem/assembly/assembly.hpp"

// A fiber wound about a drum, held back by a dead force at one end, held fast at the other one. The drum
// turns towards the first: what a fixed drum is to a fiber that is drawn over it, and the fiber rests.
namespace fiberchain::compare {

/// What the fiber slides on.
enum class DrumSurface {
  smooth,  ///< both fibers are smooth, the drum is one thick one
  wall,    ///< spheres of the fiber on a wall that is a cylinder
  ring,    ///< the drum is a ring of the same smooth fiber, on which the fiber is kept in the plane
  spheres  ///< likewise, of spheres
};

struct CapstanCase {
  DrumSurface surface = DrumSurface::smooth;
  double friction = 0.3;               ///< mu
  double turning = 3.141592653589793;  ///< phi, between the directions of both ends [rad]
  double drum = 39;                    ///< radius of the drum over that of the fiber
  double bending = 0.1;  ///< E I/(F_0 rho^2), F_0 the force that holds back, rho of the fiber's axis
  double spacing = 1;    ///< bonds over diameters; of smooth fibers only
  double speed = 5e-3;   ///< of the drum's surface, over that of sound along the fiber
  double settling = 30;  ///< until tensions are read, in ways of sound along the fiber
};

/// Sizes of a case.
struct WoundFiber {
  dem::Fiber fiber;    ///< of no round numbers
  double drum_radius;  ///< [m]
  double axis_radius;  ///< rho: of the fiber's axis from the drum's [m]
  double pitch_angle;  ///< alpha of the helix, 0 of an arc [rad]
  double held_force;   ///< F_0 [N]
  double speed;        ///< of the drum's surface [m/s]
  double sound_time;   ///< of sound along the fiber [s]
};

/// @throws InputError for a turning or spacing that the surface cannot have
WoundFiber wound_fiber(const CapstanCase& asked);

/// The fiber on the drum, at rest, stretched as a thread by exp(mu angle): group 0. Its last sphere is held
/// along x, the direction in which it leaves; it turns and goes across freely.
/// Beyond half a turn it is a helix whose turns are apart.
dem::Assembly drum_assembly(const CapstanCase& asked);

}  // namespace fiberchain::compare
