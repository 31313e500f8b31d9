#pragma once

// How the numbers of many spheres and contacts lie in memory: in rows, together what is wanted together.
// Scenes are larger than the inner caches, and a step then takes as long as its bytes need to come and go.
namespace fiberchain::dem {

inline constexpr int position_radius_size = 4, radius_offset = 3;  ///< center and radius of a sphere

inline constexpr int velocity_spin_size = 6, spin_offset = 3;  ///< velocity and spin half a step before

/// Force and moment from outside the fiber, 2 unused. Only a few parts of spheres have any at a time.
inline constexpr int load_size = 8, moment_offset = 3;

inline constexpr int quaternion_size = 4;  ///< orientation

/// Numbers of a cache line.
inline constexpr int cache_line_size = 8;

inline constexpr int contact_history_size =
    8;  ///< of a contact: the History of its law, the tangential spring first

inline constexpr int contact_account_size =
    8;  ///< booked contacts: dashpot force, tangential force, rolling moment, power of the tangential force

}  // namespace fiberchain::dem
