#pragma once

// How the numbers of many spheres lie in memory: one row a sphere, array by array.
namespace fiberchain::dem {

inline constexpr int position_numbers = 4;     ///< x, y, z, radius
inline constexpr int motion_numbers = 6;       ///< velocity half a step before, spin
inline constexpr int load_numbers = 6;         ///< force, moment from outside the fiber
inline constexpr int orientation_numbers = 4;  ///< quaternion

inline constexpr int memory_numbers = 6;       ///< of a contact: tangential spring, overlap, opening velocity, unused

/// Rows are read (never written) up to so many numbers beyond their end.
inline constexpr int row_overhang = 2;

}  // namespace fiberchain::dem
