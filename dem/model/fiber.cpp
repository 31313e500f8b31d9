#include "dem/model/fiber.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using std::numbers::pi;

constexpr double largest_rest_angle = 2 * pi / 3;

void require(bool allowed, std::string_view name, double value, std::string_view allowed_text) {
  if (!allowed) throw InvalidInput(fmt::format("{} = {} is not allowed: {}", name, value, allowed_text));
}

void require_positive(std::string_view name, double value) {
  require(std::isfinite(value) && value > 0, name, value, "it must be finite and greater than 0");
}

void require_poisson_ratio(double nu) {
  require(nu > -1 && nu <= 0.5, "poisson_ratio", nu, "it must be greater than -1 and at most 0.5");
}

}  // namespace

Material isotropic_material(double youngs_modulus, double nu, double density) {
  require_poisson_ratio(nu);
  return {youngs_modulus, youngs_modulus / (2 * (1 + nu)), density};
}

double poisson_ratio(const Material& material) {
  const double nu = (material.youngs_modulus - 2 * material.shear_modulus) / (2 * material.shear_modulus);
  // recovered from E and G it carries their rounding
  return nu > -1 && nu <= 0.5 + 1e-12 ? nu : std::numeric_limits<double>::quiet_NaN();
}

TransverseElasticity contact_elasticity(const Material& material) {
  if (material.across) return *material.across;
  const double nu = poisson_ratio(material);
  return {material.youngs_modulus, std::isnan(nu) ? usual_poisson_ratio : nu};
}

std::string_view name(MassModel model) { return model == MassModel::spheres ? "spheres" : "cylinder"; }

std::string_view name(BondModel model) { return model == BondModel::paper ? "paper" : "corrected"; }

std::string_view name(DashpotLaw law) {
  switch (law) {
    case DashpotLaw::retardation_time:
      return "retardation_time";
    case DashpotLaw::bending_only:
      return "bending_only";
    default:
      return "bond_damping";
  }
}

void check(const Fiber& fiber) {
  require_positive("youngs_modulus", fiber.material.youngs_modulus);
  require_positive("shear_modulus", fiber.material.shear_modulus);
  require_positive("density", fiber.material.density);
  require_positive("diameter", fiber.diameter);
  if (const auto& across = fiber.material.across) {
    require_positive("transverse_modulus", across->youngs_modulus);
    require_poisson_ratio(across->poisson_ratio);
  }
  require_positive("spacing", fiber.spacing);
  require(fiber.aspect_ratio >= 1, "aspect_ratio", fiber.aspect_ratio,
          "it must be a whole number, 1 or more");
  require(fiber.spacing == 1 || fiber.aspect_ratio == 1 || slenderness(fiber) > 1, "spacing", fiber.spacing,
          "several bonds of another length than a diameter must make up more than a diameter");
  require(std::isfinite(fiber.bond_damping) && fiber.bond_damping >= 0, "bond_damping", fiber.bond_damping,
          "it must be finite and 0 or more");
  require(std::isfinite(fiber.retardation_time) && fiber.retardation_time >= 0, "retardation_time",
          fiber.retardation_time, "it must be finite and 0 or more");
  require(std::isfinite(fiber.rolling_friction) && fiber.rolling_friction >= 0, "rolling_friction",
          fiber.rolling_friction, "it must be finite and 0 or more");
  require(std::abs(fiber.rest_angle) <= largest_rest_angle, "rest_angle", fiber.rest_angle,
          "it must be between -2 pi / 3 and 2 pi / 3, where every other sphere touches");
  for (const double own : fiber.law_parameters)
    require(std::isfinite(own), "law_parameters", own, "they must be finite");
  for (const PronySeries* series :
       {&fiber.branches.stretch, &fiber.branches.shear, &fiber.branches.twist, &fiber.branches.bend})
    check(*series);
  require(fiber.branches.empty() || fiber.rolling_friction == 0, "rolling_friction", fiber.rolling_friction,
          "of bonds it is not built beside Maxwell branches");
  if (fiber.dashpots == DashpotLaw::retardation_time) {
    require(fiber.bond_damping == 0, "bond_damping", fiber.bond_damping,
            "dashpots set by a retardation time take no xi_b");
  } else {
    require(fiber.retardation_time == 0, "retardation_time", fiber.retardation_time,
            "dashpots set by xi_b take no retardation time");
  }
  check_failure(fiber);
}

MaxwellBranches maxwell_branches(const MaterialRelaxation& relaxation, BondModel model) {
  PronySeries bend = relaxation.youngs_modulus;
  bend.insert(bend.end(), relaxation.bending.begin(), relaxation.bending.end());
  return {.stretch = relaxation.youngs_modulus,
          .shear = model == BondModel::corrected ? bend : relaxation.shear_modulus,
          .twist = relaxation.shear_modulus,
          .bend = bend};
}

void refuse_branches(const Fiber& fiber, std::string_view what) {
  if (!fiber.branches.empty())
    throw InvalidInput(fmt::format("Maxwell branches are not allowed: they are not built for {}", what));
}

bool damped(const Fiber& fiber) { return fiber.bond_damping > 0 || fiber.retardation_time > 0; }

double sphere_radius(const Fiber& fiber) { return fiber.diameter / 2; }
double bond_length(const Fiber& fiber) { return fiber.diameter * fiber.spacing; }

double arc_length(const Fiber& fiber) {
  const double half = fiber.rest_angle / 2;
  return half == 0 ? bond_length(fiber) : bond_length(fiber) * (half / std::sin(half));
}

double fiber_length(const Fiber& fiber) { return fiber.aspect_ratio * bond_length(fiber); }
double slenderness(const Fiber& fiber) { return fiber.aspect_ratio * fiber.spacing; }

double sphere_mass(const Fiber& fiber) {
  const bool spheres = fiber.mass == MassModel::spheres;
  const double radii = spheres ? 4.0 / 3.0 : 2.0;
  const double touching = radii * pi * std::pow(sphere_radius(fiber), 3) * fiber.material.density;
  const double n = fiber.aspect_ratio, s = fiber.spacing, r = n * s;
  if (s == 1) return touching;
  if (n == 1) return touching * s;
  // the sums of mass and of mass times the square of its place, solved for this one and the ends'
  return spheres ? touching * (r * r - 1) / (s * (n * n - 1)) : touching * s * (n * n / (n * n - 1));
}

double sphere_inertia(const Fiber& fiber) {
  const double part = fiber.mass == MassModel::spheres ? 0.4 : 0.5;
  return part * sphere_mass(fiber) * std::pow(sphere_radius(fiber), 2);
}

double end_mass_share(const Fiber& fiber) {
  const bool spheres = fiber.mass == MassModel::spheres;
  const double n = fiber.aspect_ratio, s = fiber.spacing;
  if (s == 1) return spheres ? 1.0 : 0.5;
  if (n == 1) return spheres ? (1 + s) / (2 * s) : 0.5;
  return spheres ? (1 + s) * (n - 1) / (2 * (n * s - 1)) : (n - 1) / (2 * n);
}

double mass_share(const Fiber& fiber, int sphere) {
  return sphere == 0 || sphere == fiber.aspect_ratio ? end_mass_share(fiber) : 1.0;
}

double fiber_mass(const Fiber& fiber) {
  return (fiber.aspect_ratio - 1 + 2 * end_mass_share(fiber)) * sphere_mass(fiber);
}

double bending_stiffness(const Fiber& fiber) {
  return fiber.material.youngs_modulus * pi * std::pow(sphere_radius(fiber), 4) / 4;
}

double axial_stiffness(const Fiber& fiber) { return bond_stiffness(fiber).stretch * bond_length(fiber); }
double shear_stiffness(const Fiber& fiber) { return bond_stiffness(fiber).shear * bond_length(fiber); }

BondStiffness bond_stiffness(const Fiber& fiber) {
  const double R = sphere_radius(fiber);
  const double E = fiber.material.youngs_modulus;
  const double G = fiber.material.shear_modulus;
  const double s = fiber.spacing;
  const double stretch = pi * R * E / 2 / s;
  const double twist = pi * R * R * R * G / 4 / s, bend = pi * R * R * R * E / 8 / s;
  if (fiber.bond_model == BondModel::paper) return {stretch, pi * R * G / 2 / s, twist, bend};
  const double straight = bond_length(fiber) / arc_length(fiber);
  // K_t l_0^2 = 12 K_bend: the shear that bending of the bond gives
  return {stretch * straight, 0.75 * stretch / (s * s) * (straight * straight * straight), twist * straight,
          bend * straight};
}

BondStiffness unrelaxed_stiffness(const Fiber& fiber) {
  const BondStiffness K = bond_stiffness(fiber);
  const MaxwellBranches& own = fiber.branches;
  return {K.stretch * unrelaxed_modulus(own.stretch), K.shear * unrelaxed_modulus(own.shear),
          K.twist * unrelaxed_modulus(own.twist), K.bend * unrelaxed_modulus(own.bend)};
}

BondDashpot bond_dashpot(const Fiber& fiber) {
  const BondStiffness K = bond_stiffness(fiber);
  const double tau = fiber.retardation_time, xi_b = fiber.bond_damping;
  if (fiber.dashpots == DashpotLaw::retardation_time) {
    return {tau * K.stretch, tau * K.shear, tau * K.twist, tau * K.bend};
  }
  const double m = sphere_mass(fiber);
  const double J = sphere_inertia(fiber);
  const double bend = xi_b * std::sqrt(2 * J * K.bend);
  if (fiber.dashpots == DashpotLaw::bending_only) return {0, 0, 0, bend};
  return {xi_b * std::sqrt(2 * m * K.stretch), xi_b * std::sqrt(2 * m * K.shear),
          xi_b * std::sqrt(2 * J * K.twist), bend};
}

double bond_time_step(const Fiber& fiber) {
  return std::sqrt(sphere_mass(fiber) / bond_stiffness(fiber).stretch);
}

double load_force(const Fiber& fiber, double load) {
  const double L = fiber_length(fiber);
  return load * bending_stiffness(fiber) / (L * L);
}

}  // namespace fiberchain::dem
