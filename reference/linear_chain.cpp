#include "reference/linear_chain.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

void require_not_negative(const char* argument, double value) {
  require_between(argument, value, 0, std::numeric_limits<double>::max());
}

double total_mass(const LinearChain& chain) { return chain.mass * (chain.bonds - 1 + 2 * chain.end_share); }

/// Equal masses between the ends and others at the ends that have a total and a moment about the middle
/// [kg m^2].
LinearChain with_masses(LinearChain chain, double total, double moment) {
  double between = 0, between_squared = 0;  // of unit masses
  const double half = chain.bonds * chain.spacing / 2;
  for (int i = 1; i < chain.bonds; ++i) {
    const double place = i * chain.spacing - half;
    between += 1, between_squared += place * place;
  }
  // total = m between + 2 e, moment = m between_squared + 2 e half^2
  chain.mass = (total * half * half - moment) / (between * half * half - between_squared);
  chain.end_share = (total - chain.mass * between) / 2 / chain.mass;
  return chain;
}

double radius_of(const LinearChain& chain) { return chain.spacing / (2 * chain.spacing_ratio); }

}  // namespace

LinearChain linear_chain(const ChainMaterial& material) {
  require_between("bonds", material.bonds, 1, 100000);
  require_positive("radius", material.radius);
  require_positive("modulus", material.modulus);
  require_positive("density", material.density);
  require_between("spacing_ratio", material.spacing_ratio, 1e-3, 1e6);
  const double nu = material.poisson_ratio;
  if (!(nu > -1 && nu <= 0.5)) throw InvalidArgument("poisson_ratio", nu, "above -1, up to 0.5");
  using std::numbers::pi;
  const double r = material.radius;
  const double shear_modulus = material.modulus / (2 * (1 + nu));
  const double mass = 4.0 / 3 * pi * r * r * r * material.density;
  const BondCoefficients stiffness{pi * r * material.modulus / 2, pi * r * shear_modulus / 2,
                                   pi * r * r * r * shear_modulus / 4, pi * r * r * r * material.modulus / 8};
  LinearChain chain{material.bonds, 2 * r, mass, 0.4 * mass * r * r, stiffness, {0, 0, 0, 0}};
  const double s = material.spacing_ratio;
  if (s == 1) return chain;
  const double area = pi * r * r, second = area * r * r / 4, l = s * 2 * r;
  chain.spacing = l;
  chain.spacing_ratio = s;
  const double spheres = s * chain.bonds + 1, whole = spheres * mass;
  if (chain.bonds == 1) {
    chain.mass *= s, chain.end_share = whole / 2 / chain.mass;
  } else {
    chain = with_masses(chain, whole, whole * 4 * r * r * (spheres * spheres - 1) / 12);
  }
  chain.inertia = 0.4 * chain.mass * r * r;
  chain.stiffness = {material.modulus * area / l, shear_modulus * area / l, shear_modulus * 2 * second / l,
                     material.modulus * second / l};
  return chain;
}

LinearChain with_cylinder_mass(LinearChain chain) {
  const double r = radius_of(chain);
  if (chain.spacing_ratio != 1) {
    const double length = chain.bonds * chain.spacing,
                 whole = 1.5 * total_mass(chain) * length / (length + 2 * r);
    if (chain.bonds == 1) {
      chain.mass = whole, chain.end_share = 0.5;
    } else {
      chain = with_masses(chain, whole, whole * length * length / 12);
    }
    chain.inertia = chain.mass * r * r / 2;
    return chain;
  }
  chain.mass *= 1.5;
  chain.inertia = chain.mass * r * r / 2;
  chain.end_share = 0.5;
  return chain;
}

LinearChain with_slender_shear(LinearChain chain) {
  chain.stiffness.shear = 0.75 * chain.stiffness.stretch / (chain.spacing_ratio * chain.spacing_ratio);
  return chain;
}

LinearChain with_shear_modulus(LinearChain chain, double shear_modulus) {
  require_positive("shear_modulus", shear_modulus);
  const double r = radius_of(chain), s = chain.spacing_ratio;
  chain.stiffness.shear = std::numbers::pi * r * shear_modulus / 2 / s;
  chain.stiffness.twist = std::numbers::pi * r * r * r * shear_modulus / 4 / s;
  return chain;
}

LinearChain with_bond_damping(LinearChain chain, double bond_damping) {
  require_not_negative("bond_damping", bond_damping);
  const BondCoefficients& k = chain.stiffness;
  const auto dashpot = [&](double inertia, double stiffness) {
    return bond_damping * std::sqrt(2 * inertia * stiffness);
  };
  chain.dashpot = {dashpot(chain.mass, k.stretch), dashpot(chain.mass, k.shear),
                   dashpot(chain.inertia, k.twist), dashpot(chain.inertia, k.bend)};
  return chain;
}

LinearChain with_retardation_time(LinearChain chain, double retardation_time) {
  require_not_negative("retardation_time", retardation_time);
  const BondCoefficients& k = chain.stiffness;
  chain.dashpot = {retardation_time * k.stretch, retardation_time * k.shear, retardation_time * k.twist,
                   retardation_time * k.bend};
  return chain;
}

LinearChain with_bending_damping(LinearChain chain, double bond_damping) {
  const double bend = with_bond_damping(chain, bond_damping).dashpot.bend;
  chain.dashpot = {0, 0, 0, bend};
  return chain;
}

double bond_time(const LinearChain& chain) { return std::sqrt(chain.mass / chain.stiffness.stretch); }

void validate(const LinearChain& chain) {
  require_between("bonds", chain.bonds, 1, 100000);
  require_positive("spacing", chain.spacing);
  require_positive("mass", chain.mass);
  require_positive("inertia", chain.inertia);
  require_positive("spacing_ratio", chain.spacing_ratio);
  require_between("end_share", chain.end_share, 1e-3, 1e3);
  for (const BondCoefficients* each : {&chain.stiffness, &chain.dashpot}) {
    const bool spring = each == &chain.stiffness;
    for (const double value : {each->stretch, each->shear, each->twist, each->bend}) {
      spring ? require_positive("bond stiffness", value) : require_not_negative("bond dashpot", value);
    }
  }
}

}  // namespace fiberchain::reference
