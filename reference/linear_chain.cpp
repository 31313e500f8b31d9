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

}  // namespace

LinearChain linear_chain(const ChainMaterial& material) {
  require_between("bonds", material.bonds, 1, 100000);
  require_positive("radius", material.radius);
  require_positive("modulus", material.modulus);
  require_positive("density", material.density);
  const double nu = material.poisson_ratio;
  if (!(nu > -1 && nu <= 0.5)) throw InvalidArgument("poisson_ratio", nu, "above -1, up to 0.5");
  using std::numbers::pi;
  const double r = material.radius;
  const double shear_modulus = material.modulus / (2 * (1 + nu));
  const double mass = 4.0 / 3 * pi * r * r * r * material.density;
  const BondCoefficients stiffness{pi * r * material.modulus / 2, pi * r * shear_modulus / 2,
                                   pi * r * r * r * shear_modulus / 4, pi * r * r * r * material.modulus / 8};
  return {material.bonds, 2 * r, mass, 0.4 * mass * r * r, stiffness, {0, 0, 0, 0}};
}

LinearChain with_cylinder_mass(LinearChain chain) {
  const double r = chain.spacing / 2;
  chain.mass *= 1.5;
  chain.inertia = chain.mass * r * r / 2;
  chain.end_share = 0.5;
  return chain;
}

LinearChain with_shear_modulus(LinearChain chain, double shear_modulus) {
  require_positive("shear_modulus", shear_modulus);
  const double r = chain.spacing / 2;
  chain.stiffness.shear = std::numbers::pi * r * shear_modulus / 2;
  chain.stiffness.twist = std::numbers::pi * r * r * r * shear_modulus / 4;
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
  require_between("end_share", chain.end_share, 1e-3, 1);
  for (const BondCoefficients* each : {&chain.stiffness, &chain.dashpot}) {
    const bool spring = each == &chain.stiffness;
    for (const double value : {each->stretch, each->shear, each->twist, each->bend}) {
      spring ? require_positive("bond stiffness", value) : require_not_negative("bond dashpot", value);
    }
  }
}

}  // namespace fiberchain::reference
