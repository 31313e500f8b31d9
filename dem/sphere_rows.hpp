#pragma once

// How the numbers of many spheres and contacts lie in memory: rows of whole cache lines.
namespace fiberchain::dem {

/// A sphere's row: center and radius, velocity and spin half a step before, force and moment from outside the fiber.
inline constexpr int row_numbers = 16, row_position = 0, row_radius = 3, row_velocity = 4, row_spin = 7, row_force = 10, row_moment = 13;
/// Numbers of a line.
inline constexpr int line_numbers = 8;

inline constexpr int orientation_numbers = 4;  ///< quaternion

inline constexpr int memory_numbers = 8;  ///< of a contact: tangential spring, root of the overlap, opening velocity, 3 unused

inline constexpr int work_numbers = 8;    ///< booked contacts: dashpot force, tangential force, 3 unused, its power

}  // namespace fiberchain::dem
