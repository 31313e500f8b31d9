#pragma once

#include <array>
#include <functional>
#include <vector>

#include "reference/cvode.hpp"

namespace fiberchain::reference {

// Jeffery's equation for the axis p (|p| = 1) of a body of revolution, free of force and torque, in a
// creeping linear flow (Jeffery 1922; Bretherton 1962, J. Fluid Mech. 14, 284, for bodies other than
// ellipsoids):
//   dp/dt = Omega p + Lambda (E p - p (p . E p)),
// Omega and E the antisymmetric and the symmetric part of the velocity gradient, Lambda the body's Bretherton
// constant, (r^2 - 1)/(r^2 + 1) for an ellipsoid of axis ratio r.

using Direction = std::array<double, 3>;
/// gradient[i][j] = du_i/dx_j [1/s]
using VelocityGradient = std::array<std::array<double, 3>, 3>;

/// u = (rate y, 0, 0): flow x, gradient y, vorticity z.
VelocityGradient simple_shear(double rate);

/// Lambda = (r^2 - 1)/(r^2 + 1). Throws InvalidArgument unless 0 < aspect_ratio <= 1e7.
double bretherton_constant(double aspect_ratio);

/// r = sqrt((1 + Lambda)/(1 - Lambda)). Throws InvalidArgument unless -1 < bretherton < 1 (other bodies do
/// not turn for ever in simple shear).
double equivalent_aspect_ratio(double bretherton);

/// dp/dt [1/s] as above, for any p, Lambda and gradient.
Direction jeffery_rate(double bretherton, const VelocityGradient& gradient, const Direction& p);

/// Period in simple shear, 2 pi (r + 1/r)/rate [s]: the axis comes back to itself, after two half turns.
/// Throws InvalidArgument unless both are positive (r up to 1e7).
double jeffery_period(double aspect_ratio, double rate);

/// An orbit in simple shear and the place on it at time 0. With tau = phase + rate t/(r + 1/r),
///   p_x : p_y : p_z = C r sin(tau) : C cos(tau) : 1   (C = infinity: p_z = 0, the orbit in the flow plane).
/// With theta the angle to the vorticity and tan(phi) = p_x/p_y: tan(phi) = r tan(tau) and
/// tan(theta) = C r/sqrt(r^2 cos^2 phi + sin^2 phi).
struct JefferyOrbit {
  double aspect_ratio;    ///< r of the equivalent ellipsoid
  double rate;            ///< shear rate [1/s]
  double constant;        ///< C, 0 (log rolling) to infinity; tan(theta) where p lies in the plane x = 0
  double phase;           ///< tau at time 0 [rad], above -pi, up to pi
  bool reversed = false;  ///< p is the opposite of the above: p_z < 0 (the body does not know head from tail)
};

/// The orbit through p at time 0. Throws InvalidArgument unless aspect_ratio and rate are positive and p is
/// finite and not zero (it is scaled to a unit vector).
JefferyOrbit jeffery_orbit(double aspect_ratio, double rate, const Direction& p);

/// Orbit constant C of p alone: sqrt(p_y^2 + p_x^2/r^2)/|p_z|. Throws as jeffery_orbit.
double orbit_constant(double aspect_ratio, const Direction& p);

/// C/(1 + C), from 0 to 1.
double bounded_orbit_constant(double constant);

/// p at time t [s] (any sign) in closed form. Throws InvalidArgument for an orbit that makes no sense.
Direction direction_on_orbit(const JefferyOrbit& orbit, double t);

/// Spin about the axis, mean over the orbit [rad/s]: the body turns with the fluid about its axis, at
/// -(rate/2) p_z, whose mean is (rate/2)/AGM(sqrt(1 + C^2), sqrt(1 + C^2 r^2)), AGM the arithmetic-geometric
/// mean; negative about a p with p_z > 0, zero in the flow plane.
double mean_axial_spin(const JefferyOrbit& orbit);

/// p after the time t in any constant gradient: the linear flow exp((Omega + Lambda E) t) carries p, scaled
/// back to length 1. Throws InvalidArgument unless all is finite and |Omega + Lambda E| t <= 300 (the
/// exponential overflows beyond 700).
Direction jeffery_by_exponential(double bretherton, const VelocityGradient& gradient, const Direction& start,
                                 double t);

struct JefferyHistory {
  std::vector<Direction> directions;  ///< at the times asked for; lengths drift from 1 by CVODE's error
  CvodeStatistics statistics;
};

/// Jeffery's equation by CVODE's Adams formulas in a gradient that may change with time. `times` [s]
/// increase; the first may be 0, when p = start (scaled to a unit vector). Throws InvalidArgument,
/// NoConvergence.
JefferyHistory jeffery_by_cvode(double bretherton, const std::function<VelocityGradient(double)>& gradient,
                                const Direction& start, const std::vector<double>& times,
                                const CvodeTolerances& tolerances = {});

/// The same in a constant gradient.
JefferyHistory jeffery_by_cvode(double bretherton, const VelocityGradient& gradient, const Direction& start,
                                const std::vector<double>& times, const CvodeTolerances& tolerances = {});

}  // namespace fiberchain::reference
