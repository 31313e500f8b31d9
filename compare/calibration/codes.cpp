#include "compare/calibration/codes.hpp"

#include <fmt/format.h>

#include <numbers>

namespace fiberchain::compare {
namespace {

/// Density of spheres that weigh what the chain's do.
double sphere_density(const dem::Fiber& fiber) {
  dem::Fiber spheres = fiber;
  spheres.mass = dem::MassModel::spheres;
  return fiber.material.density * dem::sphere_mass(fiber) / dem::sphere_mass(spheres);
}

std::string mass_comment(const dem::Fiber& fiber) {
  return fiber.mass == dem::MassModel::spheres
             ? "# these spheres weigh two thirds of the fiber; --mass cylinder gives its whole mass"
             : "# spheres as heavy as the fiber; not as here: end spheres half as heavy, J = 1/2 m R^2";
}

std::string number(double value) { return fmt::format("{:.10g}", value); }

}  // namespace

std::vector<CodeLine> lammps_lines(const dem::Fiber& fiber, double time_step) {
  const dem::BondStiffness k = dem::bond_stiffness(fiber);
  const dem::BondDashpot c = dem::bond_dashpot(fiber);
  const double R = dem::sphere_radius(fiber), d = dem::bond_length(fiber), pi = std::numbers::pi;
  const std::string code = "LAMMPS";
  return {
      {code,
       "# as src/BPM/bond_bpm_rotational.cpp at commit 07ac9307 (style since 4May2022, break since "
       "28Mar2023), not run"},
      {code, "units si"},
      {code, "atom_style bpm/sphere"},
      {code, "newton on off"},
      {code, "comm_modify vel yes"},
      {code, "special_bonds lj 0 1 1 coul 1 1 1"},
      {code, mass_comment(fiber)},
      {code, fmt::format("set group all diameter {} density {}", number(d), number(sphere_density(fiber)))},
      {code, "# limits at a strain of 1 and half a turn: break no ends the run there"},
      {code, "bond_style bpm/rotational break no smooth no"},
      {code, fmt::format("bond_coeff 1 {} {} {} {} {} {} {} {} {} {} {} {}", number(k.stretch),
                         number(k.shear), number(k.twist), number(k.bend), number(k.stretch * d),
                         number(k.shear * d), number(k.twist * pi), number(k.bend * pi), number(c.stretch),
                         number(c.shear), number(c.bend / R), number(2 * c.twist))},
      {code, "fix 1 all nve/bpm/sphere"},
      {code, fmt::format("timestep {}", number(time_step))}};
}

std::vector<CodeLine> liggghts_lines(const dem::Fiber& fiber, double time_step) {
  const std::string code = "LIGGGHTS";
  const dem::Material& material = fiber.material;
  std::vector<CodeLine> lines = {
      {code,
       "# flexible fibers, as src/bond_gran.cpp at commits 04432a39 and 0ea55cc3 (damping type 1), not "
       "run"}};
  if (fiber.bond_model != dem::BondModel::paper) {
    lines.push_back({code, "# its bonds are the paper's, K_t = pi R G/2: --bond paper"});
    return lines;
  }
  if (fiber.dashpots != dem::DashpotLaw::bond_damping) {
    lines.push_back({code, "# its dashpots are set by xi_b: --dashpots bond_damping"});
    return lines;
  }
  const std::string E = number(material.youngs_modulus);
  lines.push_back({code, "units si"});
  lines.push_back({code, "atom_style hybrid granular bond/gran n_bondtypes 1 bonds_per_atom 2"});
  lines.push_back({code, mass_comment(fiber)});
  lines.push_back({code, fmt::format("# spheres: radius {}, density {}", number(dem::sphere_radius(fiber)),
                                     number(sphere_density(fiber)))});
  lines.push_back({code, "# ro ri E G damping_type xi_b break_type sigma tau; bonds break at a strain of 1"});
  lines.push_back({code, "bond_style gran"});
  lines.push_back(
      {code, fmt::format("bond_coeff 1 1.0 0.0 {} {} 1 {} 1 {} {}", E, number(material.shear_modulus),
                         number(fiber.bond_damping), E, number(material.shear_modulus))});
  lines.push_back({code, fmt::format("timestep {}", number(time_step))});
  return lines;
}

}  // namespace fiberchain::compare
