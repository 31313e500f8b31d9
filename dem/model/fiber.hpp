#pragma once

#include <array>
#include <string_view>

namespace fiberchain::dem {

/// Isotropic elastic material of the spheres and bonds.
struct Material {
  double youngs_modulus;  ///< E [Pa]
  double shear_modulus;   ///< G [Pa]
  double density;         ///< rho of the spheres [kg/m^3]
};

/// Material with G = E / (2 (1 + nu)). Throws InvalidInput unless -1 < nu <= 0.5.
Material isotropic_material(double youngs_modulus, double poisson_ratio, double density);

/// nu = E / (2 G) - 1
double poisson_ratio(const Material& material);

/// Which bond joins the spheres.
enum class BondModel {
  paper,     ///< Nan, Wang & Tang (2015): K_t = pi R G / 2, rest length 2R
  corrected  ///< K_t = 3/4 K_n, rest length 2R (1 - theta_b^2 / 24), the chord of the bent arc
};

std::string_view name(BondModel model);

/// How the dashpots of the bonds are set.
enum class DashpotLaw {
  bond_damping,      ///< the paper's xi_b: c = xi_b sqrt(2 m K), with J for the rotations (Eqs 7-10)
  retardation_time,  ///< one time tau for all: c = tau K, a Kelvin-Voigt material
  bending_only       ///< the paper's xi_b in bending, no other dashpot
};

std::string_view name(DashpotLaw law);

/// Most parameters that one bond law alone may have.
inline constexpr int law_parameter_count = 3;

/// A straight fiber: aspect_ratio bonds of length 2R join aspect_ratio + 1 touching spheres.
struct Fiber {
  Material material;
  double diameter;   ///< d = 2R [m]
  int aspect_ratio;  ///< r_f = L / d, the number of bonds
  BondModel bond_model = BondModel::paper;
  double bond_damping = 0.0;  ///< xi_b of Eqs 7-10 [-]; 0 with DashpotLaw::retardation_time
  DashpotLaw dashpots = DashpotLaw::bond_damping;
  double retardation_time = 0.0;  ///< tau [s]; 0 unless DashpotLaw::retardation_time
  double rolling_friction = 0.0;  ///< xi_r of Eq 21 [-]
  std::array<double, law_parameter_count> law_parameters{};  ///< of a bond law that has its own, in its units
};

/// Whether any dashpot of the bonds does anything.
bool damped(const Fiber& fiber);

/// Throws InvalidInput when a value is not finite or makes no physical sense:
/// E, G, rho, d > 0; -1 < nu <= 0.5; r_f >= 1; xi_b, tau, xi_r >= 0, of xi_b and tau only the one that the
/// dashpot law uses.
void check(const Fiber& fiber);

/// Stiffness of one bond (Eqs 3-6).
struct BondStiffness {
  double stretch;  ///< K_n = pi R E / 2 [N/m]
  double shear;    ///< K_t = pi R G / 2, corrected bond 3/4 K_n [N/m]
  double twist;    ///< K_twist = pi R^3 G / 4 [N m]
  double bend;     ///< K_bend = pi R^3 E / 8 [N m]
};

/// Dashpots beside the springs of one bond, by the fiber's dashpot law.
struct BondDashpot {
  double stretch;  ///< [N s/m]
  double shear;    ///< [N s/m]
  double twist;    ///< [N m s]
  double bend;     ///< [N m s]
};

double sphere_radius(const Fiber& fiber);      ///< R [m]
double bond_length(const Fiber& fiber);        ///< l = 2R [m]
double fiber_length(const Fiber& fiber);       ///< L = r_f l [m]
double sphere_mass(const Fiber& fiber);        ///< m = 4/3 pi R^3 rho [kg]
double sphere_inertia(const Fiber& fiber);     ///< J = 2/5 m R^2 [kg m^2]
double bending_stiffness(const Fiber& fiber);  ///< E I, I = pi R^4 / 4 [N m^2]
double axial_stiffness(const Fiber& fiber);    ///< E A = K_n l [N]
double shear_stiffness(const Fiber& fiber);    ///< K_t l, G A for the paper's bond [N]

BondStiffness bond_stiffness(const Fiber& fiber);
BondDashpot bond_dashpot(const Fiber& fiber);

/// t_b = 0.8165 d sqrt(rho / E) = sqrt(m / K_n), the paper's critical bond time step (Eq 11) [s].
/// The largest stable step depends on damping and nu too: stable_time_step() in motion/time_step.hpp.
double bond_time_step(const Fiber& fiber);

/// Dead load P [N] of the dimensionless load P L^2 / (E I).
double load_force(const Fiber& fiber, double load);

}  // namespace fiberchain::dem
