#pragma once

#include <array>
#include <string_view>

namespace fiberchain::dem {

/// Energy stored now, and dissipated or supplied since the start by each mechanism that is accounted [J].
struct EnergyBalance {
  double kinetic, bonds, contacts, gravity;  ///< stored
  double bond_damping,
      bond_friction;  ///< dissipated by the dashpots and branches, by the rolling friction of bonds
  double contact_normal, contact_tangential, contact_rolling;  ///< dissipated by contacts
  double scheme;  ///< work on the springs' part of the mass matrix, where bonds are solved for; falls as dt^2
  double breaking;   ///< stored by bonds as they broke, less what contacts between their spheres began with
  double yielding;   ///< plastic work of bonds
  double fluid;      ///< dissipated by the fluid, negative where it drives
  double wall_work;  ///< supplied by moving walls
  double held_work;  ///< supplied by what holds, drives and loads spheres
  double inserted;   ///< supplied with inserted fibers
};

enum class EnergyRole {
  stored,      ///< known at any moment
  dissipated,  ///< summed where energy is accounted
  supplied     ///< likewise; taken off the total
};

/// A term of the balance. Total, log columns, tables, figures and their legends follow from this declaration.
struct EnergyMechanism {
  double EnergyBalance::*value;
  EnergyRole role;
  std::string_view column;   ///< of logs and tables, in J
  std::string_view label;    ///< in figures
  std::string_view meaning;  ///< in the dictionary of columns
};

inline constexpr std::array energy_mechanisms = {
    EnergyMechanism{&EnergyBalance::kinetic, EnergyRole::stored, "kinetic_energy", "kinetic",
                    "of all spheres, spin included"},
    EnergyMechanism{&EnergyBalance::bonds, EnergyRole::stored, "energy_bonds", "elastic, bonds",
                    "elastic, in the bonds"},
    EnergyMechanism{&EnergyBalance::contacts, EnergyRole::stored, "energy_contacts", "elastic, contacts",
                    "elastic, in the contacts"},
    EnergyMechanism{&EnergyBalance::gravity, EnergyRole::stored, "energy_gravity", "of height", "of height"},
    EnergyMechanism{&EnergyBalance::bond_damping, EnergyRole::dissipated, "taken_bond_damping",
                    "taken by bond damping",
                    "taken by the dashpots and Maxwell branches of the bonds since the start"},
    EnergyMechanism{&EnergyBalance::bond_friction, EnergyRole::dissipated, "taken_bond_friction",
                    "taken by bond friction", "taken by the rolling friction of the bonds"},
    EnergyMechanism{&EnergyBalance::contact_normal, EnergyRole::dissipated, "taken_contact_normal",
                    "taken by contacts, normal", "taken by contacts along their normal"},
    EnergyMechanism{&EnergyBalance::contact_tangential, EnergyRole::dissipated, "taken_contact_tangential",
                    "taken by contacts, tangential", "taken by contacts along the surface"},
    EnergyMechanism{&EnergyBalance::contact_rolling, EnergyRole::dissipated, "taken_contact_rolling",
                    "taken by contacts, rolling", "taken by the rolling friction of contacts"},
    EnergyMechanism{&EnergyBalance::scheme, EnergyRole::dissipated, "taken_scheme", "taken by the scheme",
                    "work of beta dt^2 K, which stands beside the masses where bonds are "
                    "solved for within the step"},
    EnergyMechanism{&EnergyBalance::breaking, EnergyRole::dissipated, "taken_breaking", "taken by breaking",
                    "stored by bonds as they broke, less what contacts of the spheres that they joined began "
                    "with"},
    EnergyMechanism{&EnergyBalance::yielding, EnergyRole::dissipated, "taken_yielding", "taken by yielding",
                    "plastic work of bonds that bend beyond their yield moment"},
    EnergyMechanism{&EnergyBalance::fluid, EnergyRole::dissipated, "taken_fluid", "taken by the fluid",
                    "taken by the fluid"},
    EnergyMechanism{&EnergyBalance::wall_work, EnergyRole::supplied, "given_walls", "given by walls",
                    "given by walls that move"},
    EnergyMechanism{&EnergyBalance::held_work, EnergyRole::supplied, "given_held", "given by grips and loads",
                    "given by what holds, drives and loads spheres"},
    EnergyMechanism{&EnergyBalance::inserted, EnergyRole::supplied, "given_inserted",
                    "given by inserted fibers", "brought by fibers put in later"},
};
static_assert(energy_mechanisms.size() * sizeof(double) == sizeof(EnergyBalance), "every term is declared");

/// The sum over all mechanisms, in the column "energy_total".
inline constexpr EnergyMechanism energy_total{
    nullptr, EnergyRole::stored, "energy_total", "total",
    "stored and taken less given: constant but for errors of the step"};

/// Sum of the terms of a role [J].
constexpr double sum_of(const EnergyBalance& energy, EnergyRole role) {
  double sum = 0;
  for (const EnergyMechanism& term : energy_mechanisms) {
    if (term.role == role) sum += energy.*term.value;
  }
  return sum;
}

/// Stored and dissipated less supplied [J]: constant but for errors of the step.
constexpr double total(const EnergyBalance& energy) {
  double sum = 0;
  for (const EnergyMechanism& term : energy_mechanisms) {
    sum += term.role == EnergyRole::supplied ? -(energy.*term.value) : energy.*term.value;
  }
  return sum;
}

}  // namespace fiberchain::dem
