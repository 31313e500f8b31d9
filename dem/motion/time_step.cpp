#include "dem/motion/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Symmetric 2 x 2 of one wave: transverse displacement (over l) and rotation of the spheres.
struct Wave {
  double ww, wp, pp;
};

/// Bond stiffness (or dashpots) across the chain at phase angle k between neighbors, displacements in units of l:
/// shear |2 sin(k/2) w - cos(k/2) phi|^2, bending |2 sin(k/2) phi|^2.
Wave across(double shear, double bend, double length, double k) {
  const double s = 2 * std::sin(k / 2), c = std::cos(k / 2), shear_moment = shear * length * length;
  return {shear_moment * s * s, -shear_moment * s * c, shear_moment * c * c + bend * s * s};
}

struct Inertia {
  double w, p;
};

bool stable(const Wave& K, const Wave& C, const Inertia& M, double dt) {
  const double ww = 4 * M.w - 2 * dt * C.ww - dt * dt * K.ww;
  const double pp = 4 * M.p - 2 * dt * C.pp - dt * dt * K.pp;
  const double wp = -2 * dt * C.wp - dt * dt * K.wp;
  return ww > 0 && pp > 0 && ww * pp > wp * wp;
}

/// Smallest positive root of 4 m - 2 dt c - dt^2 k
double scalar_limit(double k, double c, double m) { return 4 * m / (c + std::sqrt(c * c + 4 * k * m)); }

double across_limit(const Wave& K, const Wave& C, const Inertia& M) {
  double low = 0, high = std::min(scalar_limit(K.pp, C.pp, M.p), K.ww > 0 ? scalar_limit(K.ww, C.ww, M.w) : 1e300);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (stable(K, C, M, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double stable_time_step(const Fiber& fiber, double drag) {
  check(fiber);
  const BondStiffness K = bond_stiffness(fiber);
  const BondDashpot C = bond_dashpot(fiber);
  const double m = sphere_mass(fiber), J = sphere_inertia(fiber), l = bond_length(fiber);
  // along and about the chain: 2 sin(k/2) at its largest, k = pi
  double limit = std::min(scalar_limit(4 * K.stretch, 4 * C.stretch + drag * m, m),
                          scalar_limit(4 * K.twist, 4 * C.twist + drag * J, J));
  constexpr int waves = 64;
  for (int i = 0; i <= waves; ++i) {
    const double k = std::numbers::pi * i / waves;
    Wave dashpots = across(C.shear, C.bend, l, k);
    dashpots.ww += drag * m * l * l;
    dashpots.pp += drag * J;
    limit = std::min(limit, across_limit(across(K.shear, K.bend, l, k), dashpots, {m * l * l, J}));
  }
  return limit;
}

double undamped_time_step(const Fiber& fiber) {
  Fiber undamped = fiber;
  undamped.bond_damping = 0;
  undamped.retardation_time = 0;
  undamped.dashpots = DashpotLaw::bond_damping;
  return stable_time_step(undamped);
}

}  // namespace fiberchain::dem
