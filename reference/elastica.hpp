#pragma once

#include <cstddef>

#include "reference/tip_state.hpp"

namespace fiberchain::reference {

// The Elastica: an inextensible, unshearable cantilever under a dead tip load,
//   E I theta'' = -P cos(theta),  theta(0) = 0,  theta'(L) = 0,  x' = cos(theta),  y' = sin(theta),
// solved three ways that share no formula beyond this one. In all of them load = P L^2 / (E I) and
// 0 <= load <= max_elastica_load, else InvalidArgument; NoConvergence if a tolerance is missed.

/// Largest load accepted; there the free end is within 1e-96 of vertical.
inline constexpr double max_elastica_load = 5e4;

/// How exactly elastica_shooting integrates and searches.
struct ShootingTolerances {
  double absolute = 1e-14;  ///< local error of a step, absolute, in variables scaled to order 1
  double relative = 1e-13;  ///< local error of a step, relative
  double root_step = 1e-8;  ///< last Newton step, relative; the error it leaves is about its square
  int max_iterations = 50;  ///< Newton iterations
};

/// Shooting from the free end. With phi = pi/2 - theta and w = ln tan(phi/2), sigma = 1 - s/L,
///   w'' = load + tanh(w) w'^2,  w'(0) = 0,  w(1) = 0,
/// so the unknown w(0) is the logarithm of the distance from the vertical for large loads and
/// -theta_tip for small ones: no cancellation at either end.
TipState elastica_shooting(double load, const ShootingTolerances& tolerances = {});

/// Shape at n >= 2 stations equally spaced in arc length, by the same shooting.
BeamShape elastica_shape(double load, std::size_t n);

/// Closed form in elliptic integrals (Carlson's R_F and R_D), the modulus found by a bracketed search.
TipState elastica_closed_form(double load);

/// The paper's way (Eqs 13-15) and how far it can be trusted.
struct PaperElastica {
  TipState tip;          ///< the solution
  TipState error;        ///< estimate: |Simpson - Simpson with half the panels| + remaining bracket
  double bracket_width;  ///< width of the last bisection bracket of the shortening, over L
  int bisections;        ///< halvings made
};

/// Bisection on the shortening Delta with Simpson's rule for the length,
///   int_0^{L-Delta} dx / sqrt(1 - G^2) = L,  G = (P/2EI) ((L-Delta)^2 - x^2), x from the free end.
/// The integrand's near-singularity at x = 0 is removed by x = kappa sinh(t),
/// kappa^2 = 2 (1 - G(0)) / load. `panels` is a multiple of 4, 4 to 100000.
PaperElastica elastica_paper(double load, int panels = 400);

/// The same bisection and the same number of panels on the integral as it is printed, equal panels in x.
/// For comparison only. Up to load 20 it is as good or better (400 panels: y to 1e-11 at load 10, against
/// 1e-9 above); beyond, the panels no longer see the peak at x = 0, the angle is wrong in the fourth digit by
/// load 50 and the error estimate falls short of the error.
PaperElastica elastica_paper_singular(double load, int panels = 400);

}  // namespace fiberchain::reference
