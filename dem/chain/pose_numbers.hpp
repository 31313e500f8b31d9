#pragma once

#include "dem/bond/pose.hpp"

// A pose as the numbers of an integrator that knows none: position, then angle or quaternion.
namespace fiberchain::dem {

template <int Dim>
inline constexpr int orientation_size = Dim == 2 ? 1 : 4;
template <int Dim>
inline constexpr int pose_size = Dim + orientation_size<Dim>;

inline void write(double angle, double* y) { y[0] = angle; }
inline void write(const Quaternion<double>& q, double* y) {
  y[0] = q.w, y[1] = q.v[0], y[2] = q.v[1], y[3] = q.v[2];
}
inline void read(const double* y, double& angle) { angle = y[0]; }
inline void read(const double* y, Quaternion<double>& q) {
  q = normalized(Quaternion<double>{y[0], {y[1], y[2], y[3]}});
}

template <int Dim>
void write_pose(const Pose<double, Dim>& pose, double* y) {
  for (int c = 0; c < Dim; ++c) y[c] = pose.position[c];
  write(pose.orientation, y + Dim);
}

template <int Dim>
Pose<double, Dim> read_pose(const double* y) {
  Pose<double, Dim> pose;
  for (int c = 0; c < Dim; ++c) pose.position[c] = y[c];
  read(y + Dim, pose.orientation);
  return pose;
}

/// d(orientation)/dt of a spin.
inline void write_rate(double, const Vec<double, 1>& spin, double* y) { y[0] = spin[0]; }
inline void write_rate(const Quaternion<double>& q, const Vec<double, 3>& spin, double* y) {
  write(Quaternion<double>{0, 0.5 * spin} * q, y);
}

/// The rotation vector that a small change of the orientation's numbers stands for.
inline Vec<double, 1> rotation_of(double, const double* change) { return {change[0]}; }
inline Vec<double, 3> rotation_of(const Quaternion<double>& q, const double* change) {
  return 2.0 * (Quaternion<double>{change[0], {change[1], change[2], change[3]}} * conjugate(q)).v;
}

}  // namespace fiberchain::dem
