#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dem/model/contact_properties.hpp"
#include "dem/model/fluid.hpp"
#include "dem/model/shapes/shapes.hpp"
#include "dem/model/shapes/wall_shape.hpp"
#include "dem/model/wall_motion.hpp"

// What fibers meet beside each other: walls, periodic sides, gravity, a fluid; and how they touch.
namespace fiberchain::dem {

/// A wall that may move and be there for a while only.
struct Wall {
  WallShape shape;
  Vec<double, 3> velocity{};  ///< [m/s]
  double active_from = 0;     ///< [s]
  double active_until =
      std::numeric_limits<double>::infinity();  ///< [s]; a wall that opens is gone from then on
  WallMotion motion{};                          ///< beside the velocity
  ContactChoices contacts = {};                 ///< of fibers at it
  int surface = 0;                              ///< its number in Domain::pairs
  std::optional<double> youngs_modulus = {};    ///< its own [Pa]; left out: that of all walls
  std::optional<double> poisson_ratio = {};     ///< likewise
  std::string name = {};                        ///< in scenes and logs
};

/// Motion of a rigid body: v + w x (place - center).
struct WallVelocity {
  Vec<double, 3> velocity{};  ///< of the center of its pose [m/s]
  Vec<double, 3> spin{};      ///< [1/s]
};

bool is_active(const Wall& wall, double time);

/// Whether it is always the same from every place along an axis.
bool is_invariant_along(const Wall& wall, int axis);

/// Whether it stands still for good.
bool is_at_rest(const Wall& wall);

/// Whether it turns and does not look the same all the time.
bool turns_visibly(const Wall& wall);

/// Where it stands. Its center is where it turns, of others the point of the shape. A wall that is driven is
/// where it is now, whatever the time.
WallPose pose_at(const Wall& wall, double time);

/// Of a wall that is driven as half a step before now.
WallVelocity velocity_at(const Wall& wall, double time);

/// A bound for all times of the speed of its surface no farther than `reach` [m] from where it turns [m/s].
double largest_speed(const Wall& wall, double reach);

/// Distance [m] of a place from the line that the wall turns about where that stands at t = 0; 0 where it
/// does not turn.
double distance_from_axis(const Wall& wall, const Vec<double, 3>& place);

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
  Vec<double, 3> period{};              ///< length of the periodic cell along x, y, z [m]; 0: not periodic
  Vec<double, 3> gravity{};             ///< [m/s^2]
  std::optional<Fluid> fluid;           ///< free draining only
  ContactProperties contacts;           ///< of all surfaces
  std::vector<SurfacePair> pairs = {};  ///< what some have of their own
};

}  // namespace fiberchain::dem
