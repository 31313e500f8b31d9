#include "reference/stable_step.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::reference {
namespace {

/// dt/2 c + dt^2/4 k
double load_of(double dt, double dashpot, double stiffness) {
  return dt / 2 * dashpot + dt * dt / 4 * stiffness;
}

/// Bending waves with x = sin^2(half the phase from sphere to sphere): with T and B the loads of shear and
/// bend, det = mJ - mTl^2 + x (mTl^2 - 4mB - 4TJ) + 16TB x^2 for 0 <= x <= 1.
bool bending_is_stable(const LinearChain& chain, double dt) {
  const double shear = load_of(dt, chain.dashpot.shear, chain.stiffness.shear);
  const double bend = load_of(dt, chain.dashpot.bend, chain.stiffness.bend);
  const double m = chain.mass;
  const double j = chain.inertia;
  const double rotation = shear * chain.spacing * chain.spacing;
  if (m <= 4 * shear || j <= 4 * bend || j <= rotation) return false;
  const double linear = m * rotation - 4 * m * bend - 4 * shear * j;
  const double square = 16 * shear * bend;
  const double lowest = std::clamp(-linear / (2 * square), 0.0, 1.0);
  return m * (j - rotation) + linear * lowest + square * lowest * lowest > 0;
}

bool is_stable(const LinearChain& chain, double dt, bool planar) {
  const BondCoefficients& k = chain.stiffness;
  const BondCoefficients& c = chain.dashpot;
  const bool axial = 4 * load_of(dt, c.stretch, k.stretch) < chain.mass;
  const bool twist = planar || 4 * load_of(dt, c.twist, k.twist) < chain.inertia;
  return axial && twist && bending_is_stable(chain, dt);
}

}  // namespace

double largest_stable_step(const LinearChain& chain, bool planar) {
  validate(chain);
  double stable = 0;
  double unstable = 2 * bond_time(chain);
  while (unstable - stable > 1e-14 * unstable) {
    const double middle = (stable + unstable) / 2;
    (is_stable(chain, middle, planar) ? stable : unstable) = middle;
  }
  return stable;
}

}  // namespace fiberchain::reference
