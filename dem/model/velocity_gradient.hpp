#pragma once

#include <functional>

#include "dem/math/small_matrix.hpp"

// Flows that are linear in space: u = A x, A the velocity gradient.
namespace fiberchain::dem {

/// A[i][j] = du_i / dx_j [1/s]
using Gradient = Square<double, 3>;

/// The undisturbed flow u = A(t) x, at rest at the origin.
struct Flow {
  Gradient gradient{};  ///< A, constant in time
  std::function<Gradient(double)> at_time =
      {};  ///< A(t) in place of `gradient` where given; t [s] since the start
};

Gradient gradient_at(const Flow& flow, double time);

/// Largest size of an entry [1/s]; infinite if one is not finite.
double largest_rate(const Gradient& A);

Gradient simple_shear(double rate);        ///< u = rate (y, 0, 0)
Gradient planar_extension(double rate);    ///< u = rate (x, -y, 0)
Gradient uniaxial_extension(double rate);  ///< u = rate (x, -y/2, -z/2)
Gradient solid_rotation(double rate);      ///< u = rate (-y, x, 0)

/// The gradient reached as 1 - exp(-t / time). Throws InvalidInput unless time > 0.
Flow start_up(const Gradient& gradient, double time);

/// cos(2 pi t / period + phase) times the gradient. Throws InvalidInput unless period > 0.
Flow oscillation(const Gradient& gradient, double period, double phase = 0);

/// Velocity u [m/s] at a place.
template <int Dim>
Vec<double, Dim> velocity_at(const Gradient& A, const Vec<double, Dim>& x) {
  Vec<double, Dim> u{};
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) u[i] += A[i][j] * x[j];
  }
  return u;
}

/// Spin of the fluid, 1/2 curl u [1/s].
template <int Dim>
Spin<double, Dim> spin_of(const Gradient& A) {
  const double z = 0.5 * (A[1][0] - A[0][1]);
  if constexpr (Dim == 2) {
    return {z};
  } else {
    return {0.5 * (A[2][1] - A[1][2]), 0.5 * (A[0][2] - A[2][0]), z};
  }
}

}  // namespace fiberchain::dem
