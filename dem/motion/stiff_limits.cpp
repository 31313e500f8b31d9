#include "dem/motion/stiff_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fiberchain::dem {
namespace {

/// Symmetric 2 x 2 of a sphere: transverse displacement over the bond's length, and rotation.
struct Block {
  double ww, wp, pp;
};

/// Weights of a bond under tension: of (w_2 - w_1 - (p_1 + p_2)/2)^2, (p_2 - p_1)^2 and (w_2 - w_1)^2.
struct BondWeights {
  double shear, bend, string;
};

/// Whether A - dt^2/4 (K + G) is positive definite, A = M + beta dt^2 K_0: K_0 the stiffness in the bond's
/// frame as it is solved for, K that of the drawn bond (shear by its angle, bending with the shortened
/// chord), G of its tension.
bool bears(const Fiber& fiber, double tension, double dt, double beta, Clamps clamps) {
  const BondStiffness K = unrelaxed_stiffness(fiber);
  const double l0 = bond_length(fiber), l = l0 + tension / K.stretch, squared = dt * dt;
  const double chord = fiber.bond_model == BondModel::corrected ? tension * l0 / 12 : 0;
  const BondWeights bond{squared * K.shear * (beta * l * l - l0 * l0 / 4),
                         squared * (beta * K.bend - (K.bend + chord) / 4), -squared * tension * l / 4};
  // of one sphere with itself and with the next
  const double ww = bond.shear + bond.string, wp = bond.shear / 2, pp = bond.shear / 4 + bond.bend;
  const double next_pp = bond.shear / 4 - bond.bend;
  Block rest{0, 0, 0};  // from the bond before, what lies before it eliminated
  const int last = fiber.aspect_ratio - (clamps.last ? 1 : 0);
  if (clamps.first) rest = {ww, -wp, pp};
  for (int i = clamps.first ? 1 : 0; i <= last; ++i) {
    const double share = mass_share(fiber, i);
    Block own{rest.ww + share * sphere_mass(fiber) * l * l, rest.wp, rest.pp + share * sphere_inertia(fiber)};
    if (i < fiber.aspect_ratio) own = {own.ww + ww, own.wp + wp, own.pp + pp};
    const double determinant = own.ww * own.pp - own.wp * own.wp;
    if (!(own.ww > 0 && determinant > 0)) return false;
    // rows of this sphere, columns of the next: (-ww, wp; -wp, next_pp)
    const double a = (own.pp * -ww + own.wp * wp) / determinant,
                 b = (own.pp * wp - own.wp * next_pp) / determinant,
                 c = (own.wp * ww - own.ww * wp) / determinant,
                 d = (-own.wp * wp + own.ww * next_pp) / determinant;
    rest = {ww + ww * a + wp * c, -wp + ww * b + wp * d, pp - wp * b - next_pp * d};
  }
  return true;
}

}  // namespace

double largest_tension(const Fiber& fiber, double dt, double beta, Clamps clamps) {
  check(fiber);
  double low = 0, high = sphere_mass(fiber) * bond_length(fiber) / (dt * dt);
  const double most = bond_stiffness(fiber).stretch * bond_length(fiber);  // twice as long
  while (high < most && bears(fiber, high, dt, beta, clamps)) high *= 2;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (bears(fiber, middle, dt, beta, clamps) ? low : high) = middle;
  }
  return low;
}

double free_bending_period(const Fiber& fiber) {
  check(fiber);
  constexpr double root = 4.730040744862704;  // of cos x cosh x = 1
  const double bonds = fiber.aspect_ratio;
  return 2 * std::numbers::pi * (bonds / root) * (bonds / root) * bond_length(fiber) *
         std::sqrt(sphere_mass(fiber) / bond_stiffness(fiber).bend);
}

double step_for_tension(const Fiber& fiber, double tension, double beta, Clamps clamps) {
  if (!(tension > 0)) return std::numeric_limits<double>::infinity();
  double low = 0, high = bond_time_step(fiber);
  check(fiber);
  while (high < 1e12 * bond_time_step(fiber) && bears(fiber, tension, high, beta, clamps)) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (bears(fiber, tension, middle, beta, clamps) ? low : high) = middle;
  }
  return low;
}

}  // namespace fiberchain::dem
