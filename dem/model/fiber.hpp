#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "dem/model/bond_failure.hpp"
#include "dem/model/prony_series.hpp"

namespace fiberchain::dem {

/// What a fiber is across its axis, where it is stiffer along it than across (wood, carbon, aramid).
struct TransverseElasticity {
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
};

/// Elastic material of the spheres and bonds, isotropic or transversely so: bonds take E along the fiber and
/// G, which are independent of each other.
struct Material {
  double youngs_modulus;                                      ///< E [Pa]
  double shear_modulus;                                       ///< G [Pa]
  double density;                                             ///< rho of the spheres [kg/m^3]
  std::optional<TransverseElasticity> across = std::nullopt;  ///< for contacts
};

/// Material with G = E / (2 (1 + nu)). Throws InvalidInput unless -1 < nu <= 0.5.
Material isotropic_material(double youngs_modulus, double poisson_ratio, double density);

/// nu = E / (2 G) - 1 of an isotropic material; not a number where that is not above -1 and at most 0.5: the
/// material is stiffer along the fiber than across, or the other way round.
double poisson_ratio(const Material& material);

/// Poisson's ratio of contacts where neither E and G nor the user say it.
inline constexpr double usual_poisson_ratio = 0.3;

/// What contacts see: `across`, else E with nu, or the usual one where there is none.
TransverseElasticity contact_elasticity(const Material& material);

/// Which bond joins the spheres.
enum class BondModel {
  paper,     ///< Nan, Wang & Tang (2015): K_t = G A / l, rest length l
  corrected  ///< the rod between two spheres to fourth order: K_t = 12 E I / l^3, the chord of the bent arc
};

std::string_view name(BondModel model);

/// How the dashpots of the bonds are set.
enum class DashpotLaw {
  bond_damping,      ///< the paper's xi_b: c = xi_b sqrt(2 m K), with J for the rotations (Eqs 7-10)
  retardation_time,  ///< one time tau for all: c = tau K, a Kelvin-Voigt material
  bending_only       ///< the paper's xi_b in bending, no other dashpot
};

std::string_view name(DashpotLaw law);

/// What the chain weighs.
enum class MassModel {
  spheres,  ///< that of the paper's touching spheres of the material's density: two thirds of the fiber
  cylinder  ///< the fiber's own: a sphere has the cylinder of a bond's length, an end sphere half of it
};

std::string_view name(MassModel model);

/// Maxwell branches beside each spring of a bond: stiffness K (1 + sum g_j exp(-t / tau_j)), K that of the
/// fiber's material, which is the relaxed one.
struct MaxwellBranches {
  PronySeries stretch, shear, twist, bend;

  bool empty() const { return stretch.empty() && shear.empty() && twist.empty() && bend.empty(); }
};

/// How a fiber's material relaxes: its moduli, and what relaxes in bending alone (thermoelasticity).
struct MaterialRelaxation {
  PronySeries youngs_modulus, shear_modulus, bending;
};

/// Branches of stretch and bending by Young's modulus, of shear and twist by the shear modulus. The corrected
/// bond's shear spring is a part of how a rod bends: it relaxes as bending does.
MaxwellBranches maxwell_branches(const MaterialRelaxation& relaxation, BondModel model);

/// Most parameters that one bond law alone may have.
inline constexpr int law_parameter_count = 3;

/// A fiber, straight or an arc: aspect_ratio bonds of length 2R join aspect_ratio + 1 touching spheres. With
/// another `spacing` the bonds are of length spacing * 2R and join nodes that need not touch; stiffnesses
/// per length, mass and inertia of the whole are the same.
struct Fiber {
  Material material;
  double diameter;   ///< d = 2R [m]
  int aspect_ratio;  ///< number of bonds n, r_f = L / d where these are as long as thick: slenderness()
  BondModel bond_model = BondModel::paper;
  double bond_damping = 0.0;  ///< xi_b of Eqs 7-10 [-]; 0 with DashpotLaw::retardation_time
  DashpotLaw dashpots = DashpotLaw::bond_damping;
  double retardation_time = 0.0;  ///< tau [s]; 0 unless DashpotLaw::retardation_time
  double rolling_friction = 0.0;  ///< xi_r of Eq 21 [-]
  double rest_angle = 0.0;        ///< of an arc: angle between the ends of a bond at rest [rad]
  MassModel mass = MassModel::spheres;
  std::array<double, law_parameter_count> law_parameters{};  ///< of a bond law that has its own, in its units
  MaxwellBranches branches = {};  ///< of the material's memory; `material` has the relaxed moduli then
  std::optional<BondStrength> strength = std::nullopt;  ///< bonds break beyond it
  std::optional<BondYield> yield = std::nullopt;        ///< bonds bend plastically beyond it
  double spacing = 1.0;                                 ///< s = l / d, length of a bond over the diameter [-]
};

/// Throws InvalidInput where the fiber has Maxwell branches, which are not built for `what`.
void refuse_branches(const Fiber& fiber, std::string_view what);

/// Whether any dashpot of the bonds does anything.
bool damped(const Fiber& fiber);

/// Throws InvalidInput when a value is not finite or makes no physical sense:
/// E, G, rho, d, s > 0; r_f > 1 of several bonds that are not as long as thick; across the fiber E > 0 and
/// -1 < nu <= 0.5; |rest_angle| <= 2 pi / 3; bonds >= 1; xi_b, tau, xi_r >= 0, of xi_b and tau only the one
/// that the dashpot law uses; branches as check(PronySeries); strengths and yielding as check_failure().
void check(const Fiber& fiber);

/// Stiffness of one bond of length l (Eqs 3-6 at l = 2R), of the corrected bond l that of its arc.
struct BondStiffness {
  double stretch;  ///< K_n = E A / l = pi R E / (2 s) [N/m]
  double shear;    ///< K_t = G A / l = pi R G / (2 s), corrected bond 12 E I / l^3 = 3 K_n / (4 s^2) [N/m]
  double twist;    ///< K_twist = G I_p / l = pi R^3 G / (4 s) [N m]
  double bend;     ///< K_bend = E I / l = pi R^3 E / (8 s) [N m]
};

/// Dashpots beside the springs of one bond, by the fiber's dashpot law.
struct BondDashpot {
  double stretch;  ///< [N s/m]
  double shear;    ///< [N s/m]
  double twist;    ///< [N m s]
  double bend;     ///< [N m s]
};

double sphere_radius(const Fiber& fiber);  ///< R [m]
double bond_length(const Fiber& fiber);    ///< l = s 2R [m]
double arc_length(const Fiber& fiber);     ///< of a bond's axis at rest; l if straight [m]
double fiber_length(const Fiber& fiber);   ///< L = n l, between the centers of the end spheres [m]
double slenderness(const Fiber& fiber);    ///< r_f = L / d, n where s = 1 [-]
/// Of a sphere that is not an end [kg]. Touching: m = 4/3 pi R^3 rho, or 2 pi R^3 rho of the cylinder.
/// Otherwise such that the whole has the mass and the moment of inertia of r_f + 1 touching spheres, 4/3 pi
/// R^3 rho (r_f^2 - 1) / (s (n^2 - 1)), or of the cylinder of length L, pi R^2 rho l n^2 / (n^2 - 1); of a
/// single bond, which has no such sphere, the mass of its length.
double sphere_mass(const Fiber& fiber);
/// J = 2/5 m R^2, or 1/2 m R^2 of the cylinder about its axis, taken about every axis: what the whole has for
/// twist does not depend on s. Across it a cylinder's section has half of that, which lowers the first
/// bending frequency by (1.875 / (4 r_f))^2 / 2 of itself; m l^2 / 12 of the segment as a rigid body is no
/// part of it, as the masses at both its ends are what turns it [kg m^2].
double sphere_inertia(const Fiber& fiber);
/// Mass and inertia of an end sphere over those of the others. Touching: 1, or 1/2 of the cylinder. Otherwise
/// (1 + s) (n - 1) / (2 (r_f - 1)), or (n - 1) / (2 n) of the cylinder, see sphere_mass(); of a single bond
/// half of the whole.
double end_mass_share(const Fiber& fiber);
double mass_share(const Fiber& fiber, int sphere);  ///< the same for any sphere, 0 to aspect_ratio
double fiber_mass(const Fiber& fiber);              ///< of all spheres [kg]
double bending_stiffness(const Fiber& fiber);       ///< E I, I = pi R^4 / 4 [N m^2]
double axial_stiffness(const Fiber& fiber);         ///< E A = K_n l [N]
double shear_stiffness(const Fiber& fiber);         ///< K_t l, G A for the paper's bond [N]

BondStiffness bond_stiffness(const Fiber& fiber);
/// With the springs of the Maxwell branches: against a sudden load.
BondStiffness unrelaxed_stiffness(const Fiber& fiber);
BondDashpot bond_dashpot(const Fiber& fiber);

/// t_b = sqrt(m / K_n), the paper's critical bond time step, 0.8165 d sqrt(rho / E) of touching spheres (Eq
/// 11) [s]. The largest stable step depends on damping and nu too: stable_time_step() in
/// motion/time_step.hpp.
double bond_time_step(const Fiber& fiber);

/// Dead load P [N] of the dimensionless load P L^2 / (E I).
double load_force(const Fiber& fiber, double load);

}  // namespace fiberchain::dem
