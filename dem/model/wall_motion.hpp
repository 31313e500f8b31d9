#pragma once

#include <optional>

#include "dem/math/monotone_cubic.hpp"
#include "dem/math/vec.hpp"

// How a wall moves beside its constant velocity: a rigid body that turns about a line and is shifted.
namespace fiberchain::dem {

/// The line that a wall turns about.
struct WallAxis {
  Vec<double, 3> point{};  ///< at t = 0; it is shifted with the wall [m]
  Vec<double, 3> axis{};   ///< unit vector
};

/// s(t) = A e(t) (sin(2 pi f t + phase) - sin phase), e from 0 to 1 with continuous rate within `ramp`: at
/// t = 0 the wall is where it was put. With the phase 90 degrees, or a ramp, it starts at rest.
struct WallOscillation {
  Vec<double, 3> axis{};  ///< unit vector
  double amplitude = 0;   ///< A [m]
  double frequency = 0;   ///< f [1/s]
  double phase = 0;       ///< [rad]
  double ramp = 0;        ///< [s]

  double at(double time) const;       ///< s [m]
  double rate_at(double time) const;  ///< ds/dt [m/s]
  double largest_rate() const;        ///< a bound [m/s]
};

/// Places and angles at given times.
struct WallCourse {
  Vec<double, 3> axis{};  ///< of places, unit vector
  MonotoneCubic place;    ///< [m]
  MonotoneCubic angle;    ///< about WallMotion::about [rad]
};

/// A plate of given mass that is pushed along an axis by a force beside what touches it: the mass moves as
/// Newton has it, other directions are held.
struct WallDrive {
  Vec<double, 3> axis{};  ///< unit vector
  double mass = 0;        ///< [kg]
  double force = 0;       ///< along the axis [N]
  double damping = 0;     ///< its drag over its velocity [N s/m]
  double shift = 0;       ///< now, along the axis [m]
  double speed = 0;       ///< half a step before, likewise [m/s]
};

struct WallMotion {
  std::optional<WallAxis> about = {};  ///< where it turns
  double angular_velocity = 0;         ///< constant, about it [1/s]
  std::optional<WallOscillation> oscillation = {};
  std::optional<WallCourse> course = {};
  std::optional<WallDrive> drive = {};

  bool moves() const { return about || oscillation || course || drive; }
};

}  // namespace fiberchain::dem
