#pragma once

// How the numbers of many spheres and contacts lie in memory: in rows, together what is wanted together. Scenes are larger
// than the inner caches, and a step then takes as long as its bytes need to come and go.
namespace fiberchain::dem {

inline constexpr int place_numbers = 4, place_radius = 3;  ///< center and radius of a sphere

inline constexpr int motion_numbers = 6, motion_spin = 3;  ///< velocity and spin half a step before

/// Force and moment from outside the fiber, 2 unused. Only a few stripes of spheres have any at a time.
inline constexpr int load_numbers = 8, load_moment = 3;

inline constexpr int orientation_numbers = 4;  ///< quaternion

/// Numbers of a cache line.
inline constexpr int line_numbers = 8;

inline constexpr int memory_numbers = 8;  ///< of a contact: tangential spring, root of the overlap, opening velocity, power of rolling, 2 unused

inline constexpr int work_numbers = 8;    ///< booked contacts: dashpot force, tangential force, rolling moment, power of the tangential force

}  // namespace fiberchain::dem
