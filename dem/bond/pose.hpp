#pragma once

#include <cmath>

#include "dem/math/quaternion.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Position of a sphere's center [m] and its orientation.
template <class Real, int Dim>
struct Pose;

template <class Real>
struct Pose<Real, 2> {
  Vec<Real, 2> position;
  Real orientation;  ///< angle about z [rad], not wrapped
};

template <class Real>
struct Pose<Real, 3> {
  Vec<Real, 3> position;
  Quaternion<Real> orientation;  ///< turns the reference x axis into the sphere's fiber axis
};

/// A rotated frame: the unit vector of its x axis in the plane, a unit quaternion in space.
template <class Real, int Dim>
struct Frame;

template <class Real>
struct Frame<Real, 2> {
  Vec<Real, 2> axis;

  Vec<Real, 2> to_local(const Vec<Real, 2>& u) const {
    return {dot(axis, u), axis[0] * u[1] - axis[1] * u[0]};
  }
  Vec<Real, 2> to_global(const Vec<Real, 2>& u) const {
    return {axis[0] * u[0] - axis[1] * u[1], axis[1] * u[0] + axis[0] * u[1]};
  }
  Vec<Real, 1> to_global(const Vec<Real, 1>& w) const { return w; }
};

template <class Real>
struct Frame<Real, 3> {
  Quaternion<Real> turn;

  Vec<Real, 3> to_local(const Vec<Real, 3>& u) const { return rotate(conjugate(turn), u); }
  Vec<Real, 3> to_global(const Vec<Real, 3>& u) const { return rotate(turn, u); }
};

}  // namespace fiberchain::dem
