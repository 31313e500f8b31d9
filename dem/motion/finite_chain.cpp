#include "dem/motion/finite_chain.hpp"

namespace fiberchain::dem {
namespace {

/// What the matrix has of a bond's springs and dashpots.
struct BondShare {
  double stretch, shear, twist, bend;
};

/// A sphere between the ends.
struct SphereShare {
  double mass, inertia;
};

/// Stretch or twist.
bool rod_is_stable(const Fiber& fiber, double inertia, double bond) {
  const double ends = end_mass_share(fiber) * inertia - bond;
  double left = ends;  // what elimination leaves of a sphere
  for (int i = 1; i <= fiber.aspect_ratio; ++i) {
    if (!(left > 0)) return false;
    left = (i == fiber.aspect_ratio ? ends : inertia - 2 * bond) - bond * bond / left;
  }
  return left > 0;
}

/// Displacement over l and rotation; shear's strain w_2 - w_1 - (p_1 + p_2) / 2, bending's p_2 - p_1.
bool bending_is_stable(const Fiber& fiber, const SphereShare& own, double shear, double bend) {
  const double near = shear / 4 + bend, far = shear / 4 - bend;
  double ww = 0, wp = 0, pp = 0;  // of the bond before, what lies before it eliminated
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const double share = mass_share(fiber, i);
    ww += share * own.mass, pp += share * own.inertia;
    if (i < fiber.aspect_ratio) ww -= shear, wp -= shear / 2, pp -= near;
    const double determinant = ww * pp - wp * wp;
    if (!(ww > 0 && determinant > 0)) return false;
    // rows of this sphere, columns of the next: (shear, -shear/2; shear/2, -far)
    const double a = (pp * shear - wp * shear / 2) / determinant,
                 b = (-pp * shear / 2 + wp * far) / determinant,
                 c = (-wp * shear + ww * shear / 2) / determinant,
                 d = (wp * shear / 2 - ww * far) / determinant;
    ww = -shear - (shear * a + shear / 2 * c);
    wp = shear / 2 - (shear * b + shear / 2 * d);
    pp = -near - (-shear / 2 * b - far * d);
  }
  return true;
}

}  // namespace

bool finite_chain_is_stable(const Fiber& fiber, double dt, double drag) {
  const BondStiffness K = unrelaxed_stiffness(fiber);
  const BondDashpot C = bond_dashpot(fiber);
  const double m = sphere_mass(fiber) * (4 - 2 * dt * drag), J = sphere_inertia(fiber) * (4 - 2 * dt * drag),
               l = bond_length(fiber);
  const auto part = [&](double spring, double dashpot) { return dt * dt * spring + 2 * dt * dashpot; };
  const BondShare bond{part(K.stretch, C.stretch), part(K.shear, C.shear), part(K.twist, C.twist),
                       part(K.bend, C.bend)};
  return rod_is_stable(fiber, m, bond.stretch) && rod_is_stable(fiber, J, bond.twist) &&
         bending_is_stable(fiber, {m * l * l, J}, bond.shear * l * l, bond.bend);
}

}  // namespace fiberchain::dem
