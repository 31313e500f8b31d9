#include "dem/motion/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"
#include "dem/motion/finite_chain.hpp"

namespace fiberchain::dem {
namespace {

/// Symmetric 2 x 2 of one wave: transverse displacement (over l) and rotation of the spheres.
struct Wave {
  double ww, wp, pp;
};

/// Bond stiffness (or dashpots) across the chain at phase angle k between neighbors, displacements in units
/// of l: shear |2 sin(k/2) w - cos(k/2) phi|^2, bending |2 sin(k/2) phi|^2.
Wave across(double shear, double bend, double length, double k) {
  const double s = 2 * std::sin(k / 2), c = std::cos(k / 2), shear_moment = shear * length * length;
  return {shear_moment * s * s, -shear_moment * s * c, shear_moment * c * c + bend * s * s};
}

/// A sphere's mass (moment of inertia) and Stokes' drag.
struct Body {
  double mass, drag;

  /// dt (1 + keep) / gain of a step: 2 m without drag, else dt c coth(c dt / (2 m))
  double resistance(double dt) const {
    return drag == 0 ? 2 * mass : dt * drag / std::tanh(drag * dt / (2 * mass));
  }
};

struct Sphere {
  Body w, p;
};

bool stable(const Wave& K, const Wave& C, const Sphere& sphere, double dt) {
  const double ww = 2 * sphere.w.resistance(dt) - 2 * dt * C.ww - dt * dt * K.ww;
  const double pp = 2 * sphere.p.resistance(dt) - 2 * dt * C.pp - dt * dt * K.pp;
  const double wp = -2 * dt * C.wp - dt * dt * K.wp;
  return ww > 0 && pp > 0 && ww * pp > wp * wp;
}

/// Smallest positive root of 4 m - 2 dt c - dt^2 k
double scalar_limit(double k, double c, double m) { return 4 * m / (c + std::sqrt(c * c + 4 * k * m)); }

/// Not below the root of 2 resistance - 2 dt c - dt^2 k: the resistance is at most 2 m + dt drag.
double limit_bound(double k, double c, const Body& body) {
  if (body.drag == 0) return scalar_limit(k, c, body.mass);
  const double pull = std::max(2 * body.drag - 2 * c, 0.0);
  return 1.001 * (pull + std::sqrt(pull * pull + 16 * k * body.mass)) / (2 * k);
}

double across_limit(const Wave& K, const Wave& C, const Sphere& sphere) {
  double low = 0, high = std::min(limit_bound(K.pp, C.pp, sphere.p),
                                  K.ww > 0 ? limit_bound(K.ww, C.ww, sphere.w) : 1e300);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (stable(K, C, sphere, middle) ? low : high) = middle;
  }
  return low;
}

/// Along or about the chain, 2 sin(k/2) at its largest, k = pi.
double along_limit(double stiffness, double dashpot, const Body& body) {
  if (body.drag == 0) return scalar_limit(4 * stiffness, 4 * dashpot, body.mass);
  return across_limit({0, 0, 4 * stiffness}, {0, 0, 4 * dashpot},
                      {{1, 0}, body});  // one unknown: the first is at rest
}

/// Over all waves of the endless chain, `settling` the drag [1/s] that adds to the dashpots.
double endless_chain_limit(const Fiber& fiber, const StokesDrag& stokes, double settling) {
  check(fiber);
  const BondStiffness K = unrelaxed_stiffness(fiber);
  const BondDashpot C = bond_dashpot(fiber);
  const double m = sphere_mass(fiber), J = sphere_inertia(fiber), l = bond_length(fiber);
  const Body move{m, stokes.translation}, turn{J, stokes.rotation};
  double limit = std::min(along_limit(K.stretch, C.stretch + settling * m / 4, move),
                          along_limit(K.twist, C.twist + settling * J / 4, turn));
  constexpr int waves = 64;
  for (int i = 0; i <= waves; ++i) {
    const double k = std::numbers::pi * i / waves;
    Wave dashpots = across(C.shear, C.bend, l, k);
    dashpots.ww += settling * m * l * l;
    dashpots.pp += settling * J;
    limit = std::min(limit, across_limit(across(K.shear, K.bend, l, k), dashpots,
                                         {{m * l * l, stokes.translation * l * l}, turn}));
  }
  return limit;
}

}  // namespace

double stable_time_step(const Fiber& fiber, double drag) {
  const double endless = endless_chain_limit(fiber, {}, drag);
  const bool ends_as_others = fiber.spacing == 1 && fiber.mass == MassModel::spheres;
  if (ends_as_others || finite_chain_is_stable(fiber, endless, drag)) return endless;
  double low = 0, high = endless;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (finite_chain_is_stable(fiber, middle, drag) ? low : high) = middle;
  }
  return low;
}

double stable_time_step(const Fiber& fiber, const Fluid& fluid) {
  return endless_chain_limit(fiber, stokes_drag(fluid, fiber), 0);
}

double undamped_time_step(const Fiber& fiber) {
  Fiber undamped = fiber;
  undamped.bond_damping = 0;
  undamped.retardation_time = 0;
  undamped.dashpots = DashpotLaw::bond_damping;
  return stable_time_step(undamped);
}

}  // namespace fiberchain::dem
