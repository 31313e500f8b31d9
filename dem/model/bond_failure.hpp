#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

// What the bonds of a fiber bear: strengths beyond which they break for good, a moment beyond which they bend
// plastically.
namespace fiberchain::dem {

struct Fiber;

/// Strengths that differ from bond to bond: that of a bond of length l is S (l_0/l)^(1/m) (-ln u)^(1/m), u
/// uniform in (0, 1], the same number for all its strengths. A length L under the stress sigma survives with
/// exp(-(L/l_0) (sigma/S)^m), whatever the bonds it is cut into (Weibull 1939).
struct WeibullSpread {
  double modulus;           ///< m [-]
  double reference_length;  ///< l_0, of which S is the strength that 1/e survive [m]
  std::uint64_t seed = 1;
};

/// Stresses that bonds bear [Pa]; none where left out. N is the bond's force along its axis, positive in
/// tension, M its bending moment, Q its shear force, T its torque, of the springs alone, at its middle.
struct BondStrength {
  std::optional<double> tension = {};      ///< of N/A + |M| R/I
  std::optional<double> compression = {};  ///< of -N/A + |M| R/I
  std::optional<double> shear = {};        ///< of |Q|/A
  std::optional<double> torsion = {};      ///< of |T| R/(2 I)
  std::optional<WeibullSpread> weibull = {};

  bool any() const { return tension || compression || shear || torsion; }
};

/// A hinge in every bond: it bends elastically up to a moment, plastically from there on.
struct BondYield {
  double moment;         ///< at which it begins [N m]
  double hardening = 0;  ///< bending stiffness while it yields over the elastic one; 0: ideally plastic [-]
};

/// Why a bond broke.
enum class BreakCause { none, tension, compression, shear, torsion, by_hand };

std::string_view name(BreakCause cause);

/// Throws InvalidInput for strengths, moduli and lengths that are not above 0, for a hardening that is not
/// from 0 to below 1, and for both beside Maxwell branches or rolling friction of the bonds.
void check_failure(const Fiber& fiber);

/// Whether its bonds break or yield.
bool fails(const Fiber& fiber);

/// Throws InvalidInput where bonds break or yield, which is not built for `what`.
void refuse_failure(const Fiber& fiber, std::string_view what);

/// Factor of a bond's strengths by WeibullSpread [-], `u` uniform in (0, 1].
double weibull_factor(const WeibullSpread& spread, double bond_length, double u);

/// Moment of a round section that yields all over, 4/3 sigma_y R^3 [N m].
double plastic_moment(double yield_stress, double radius);

}  // namespace fiberchain::dem
