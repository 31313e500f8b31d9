#pragma once

#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "dem/model/fluid.hpp"

// What fibers meet beside each other: walls, periodic sides, gravity, a fluid; and how they touch.
namespace fiberchain::dem {

/// A wall that fills the half space behind it.
struct Plane {
  Vec<double, 3> point;   ///< of the wall at t = 0 [m]
  Vec<double, 3> normal;  ///< unit vector into the room
};

/// The inside of a cylinder.
struct Cylinder {
  Vec<double, 3> point;  ///< of the axis at t = 0 [m]
  Vec<double, 3> axis;   ///< unit vector
  double radius;         ///< [m]
};

/// A wall that may move at constant speed and be there for a while only.
struct Wall {
  std::variant<Plane, Cylinder> shape;
  Vec<double, 3> velocity{};  ///< [m/s]
  double from = 0;            ///< there from this time [s]
  double until = std::numeric_limits<double>::infinity();  ///< and gone from this one: a wall that opens
};

bool is_active(const Wall& wall, double time);

/// Whether it looks the same from every place along an axis.
bool is_invariant_along(const Wall& wall, int axis);

/// Gap [m] between a place and the wall where it stands at that time, there or not; negative behind it.
double gap_to(const Wall& wall, const Vec<double, 3>& place, double time);

/// Unit vector from a place to the wall.
Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time);

/// How surfaces touch, the same for every pair: Hertz-Mindlin with these.
struct ContactProperties {
  double restitution = 1;       ///< normal coefficient of restitution, 0 < e <= 1
  double friction = 0;          ///< Coulomb's mu
  double rolling_friction = 0;  ///< mu_r: a moment of at most mu_r R* F_n against rolling
};

struct Domain {
  std::vector<Wall> walls;
  double wall_youngs_modulus = 0;  ///< [Pa]; 0: rigid walls
  double wall_poisson_ratio = 0.3;
  Vec<double, 3> period{};         ///< length of the periodic cell along x, y, z [m]; 0: not periodic
  Vec<double, 3> gravity{};        ///< [m/s^2]
  std::optional<Fluid> fluid;      ///< free draining only
  ContactProperties contacts;
};

}  // namespace fiberchain::dem
