#include "reference/tension_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/amplification.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

/// Whether the bending waves' matrix is positive definite at the step squared y: with x = sin^2(half the
/// phase from sphere to sphere), s = y (beta - 1/4) K_t, b = y (beta - 1/4) K_bend and g = y N/l,
///   ww: m + 4 s x - g x,  tt: J + s l^2 (1 - x) + 4 b x,  |wt|^2: 4 s^2 l^2 x (1 - x),
/// a determinant square in x.
bool bending_is_definite(const LinearChain& chain, double beta, double tension, double y) {
  const double s = y * (beta - 0.25) * chain.stiffness.shear, b = y * (beta - 0.25) * chain.stiffness.bend;
  const double g = y * tension / chain.spacing, m = chain.mass, j = chain.inertia;
  const double turn = s * chain.spacing * chain.spacing;
  if (j + turn <= 0 || j + 4 * b <= 0) return false;  // tt, linear in x
  const double flat = m * (j + turn), slope = m * (4 * b - turn) + 4 * s * j - g * (j + turn);
  const double square = 16 * s * b - g * (4 * b - turn);
  const auto determinant = [&](double x) { return flat + x * (slope + x * square); };
  const double lowest = square > 0 ? std::clamp(-slope / (2 * square), 0.0, 1.0) : 0;
  return std::min({determinant(0), determinant(1), determinant(lowest)}) > 0;
}

}  // namespace

double tension_limited_step(const LinearChain& chain, double beta, double tension) {
  validate(chain);
  require_between("tension", tension, -std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::max());
  const double relaxed = endless_stable_step(chain, bonds_in_step(beta));
  if (tension <= 0) return relaxed;
  const auto definite = [&](double dt) { return bending_is_definite(chain, beta, tension, dt * dt); };
  double low = 0, high = bond_time(chain);
  while (definite(high)) low = high, high *= 2;
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    (definite(middle) ? low : high) = middle;
  }
  return std::min(low, relaxed);
}

}  // namespace fiberchain::reference
