#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "dem/model/contact_properties.hpp"
#include "dem/model/fluid.hpp"
#include "dem/model/shapes/shapes.hpp"
#include "dem/model/shapes/wall_shape.hpp"

// What fibers meet beside each other: walls, periodic sides, gravity, a fluid; and how they touch.
namespace fiberchain::dem {

/// A wall that may move at constant speed and be there for a while only.
struct Wall {
  WallShape shape;
  Vec<double, 3> velocity{};  ///< [m/s]
  double active_from = 0;     ///< [s]
  double active_until =
      std::numeric_limits<double>::infinity();  ///< [s]; a wall that opens is gone from then on
};

bool is_active(const Wall& wall, double time);

/// Whether it looks the same from every place along an axis.
bool is_invariant_along(const Wall& wall, int axis);

/// Gap [m] between a place and the wall where it stands at that time, there or not; negative behind it.
double gap_to(const Wall& wall, const Vec<double, 3>& place, double time);

/// Unit vector from a place to the wall.
Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time);

/// Whether two walls are one given twice: there at the same time, moving alike, equally far from everywhere.
/// Spheres would touch both and be pushed twice.
bool are_same(const Wall& one, const Wall& other);

struct Domain {
  std::vector<Wall> walls;
  double wall_youngs_modulus = 0;  ///< [Pa]; 0: rigid walls
  double wall_poisson_ratio = 0.3;
  Vec<double, 3> period{};     ///< length of the periodic cell along x, y, z [m]; 0: not periodic
  Vec<double, 3> gravity{};    ///< [m/s^2]
  std::optional<Fluid> fluid;  ///< free draining only
  ContactProperties contacts;
};

}  // namespace fiberchain::dem
