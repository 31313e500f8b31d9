#include "compare/app/calibrate_case.hpp"

#include <fmt/format.h>

#include "compare/app/options.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

using compare::InputError;
using dem::DashpotLaw;

void refuse_both(const Quantities& typed, const std::string& one, const std::string& other) {
  if (typed.has(one) && typed.has(other))
    throw InputError(fmt::format("{} and {}: give only one", one, other));
}

double value_of(const std::optional<double>& typed, const std::optional<dem::MaterialValue>& known,
                const std::string& option, const dem::MaterialData& material) {
  if (typed) return *typed;
  if (known) return known->value;
  throw InputError(fmt::format("material '{}' has no {}: give {}", material.name, option.substr(2), option));
}

/// What is typed counts in place of the material's.
dem::Material named_material(const Quantities& typed, const dem::MaterialData& data) {
  const double E =
      value_of(typed.quantity("--youngs-modulus", "Pa"), data.youngs_modulus, "--youngs-modulus", data);
  const double density = value_of(typed.quantity("--density", "kg/m^3"), data.density, "--density", data);
  std::optional<double> G = typed.quantity("--shear-modulus", "Pa"), nu = typed.number("--poisson-ratio");
  if (!G && !nu && data.shear_modulus) G = data.shear_modulus->value;
  if (!G && !nu && data.poisson_ratio) nu = data.poisson_ratio->value;
  if (!G && !nu) {
    throw InputError(fmt::format(
        "material '{}' has neither a shear modulus nor a Poisson's ratio: give --shear-modulus or "
        "--poisson-ratio",
        data.name));
  }
  return G ? dem::Material{E, *G, density} : dem::isotropic_material(E, *nu, density);
}

dem::Material material_of(const Quantities& typed, const dem::Material& usual) {
  const double youngs_modulus = typed.quantity("--youngs-modulus", "Pa", usual.youngs_modulus);
  const double density = typed.quantity("--density", "kg/m^3", usual.density);
  if (const auto G = typed.quantity("--shear-modulus", "Pa")) return {youngs_modulus, *G, density};
  return dem::isotropic_material(youngs_modulus, typed.number("--poisson-ratio", dem::poisson_ratio(usual)),
                                 density);
}

/// Whether size and material of a real fiber were given, all of them; some of them are a mistake.
bool is_dimensional(const Arguments& arguments) {
  std::vector<std::string> needed = {"--youngs-modulus", "--density", "--diameter"}, missing;
  if (arguments.has("--material")) needed = {"--diameter"};
  for (const std::string& option : needed) {
    if (!arguments.has(option)) missing.push_back(option);
  }
  const bool in_seconds = arguments.has("--retardation-time") || arguments.has("--band") ||
                          arguments.text("--dashpots") == "retardation_time";
  const bool wanted = missing.size() < needed.size() || arguments.has("--shear-modulus") ||
                      arguments.has("--material") || in_seconds;
  if (wanted && !missing.empty()) {
    throw InputError(
        fmt::format("{} missing: an answer in seconds needs {}; without any of them, without "
                    "--material, --band, --shear-modulus and retardation times, the answers are ratios",
                    fmt::join(missing, ", "), fmt::join(needed, ", ")));
  }
  return missing.empty();
}

/// Size, bond and mass model that were typed, of the nominal material.
dem::Fiber shaped_fiber(const Arguments& arguments, const Quantities& typed) {
  using dem::BondModel;
  using dem::MassModel;
  int aspect_ratio = 0;
  read_number(arguments, "--aspect-ratio", {.low = 1, .high = 1000}, aspect_ratio);
  dem::Fiber fiber = compare::nominal_fiber(aspect_ratio, 0.3, BondModel::paper);
  fiber.diameter = typed.quantity("--diameter", "m", fiber.diameter);
  fiber.bond_model = choice<BondModel>(arguments, "--bond", BondModel::paper,
                                       {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  fiber.mass = choice<MassModel>(arguments, "--mass", fiber.mass,
                                 {{"spheres", MassModel::spheres}, {"cylinder", MassModel::cylinder}});
  return fiber;
}

}  // namespace

std::vector<std::string> calibration_targets(const Arguments& arguments) {
  std::vector<std::string> typed;
  for (const char* option : {"--damping-ratio", "--log-decrement", "--quality-factor", "--loss-factor",
                             "--bond-damping", "--retardation-time"}) {
    const bool of_material = option == std::string("--loss-factor") && arguments.has("--band");
    if (arguments.has(option) && !of_material) typed.emplace_back(option);
  }
  return typed;
}

std::string known_target(const Arguments& arguments) {
  const std::vector<std::string> typed = calibration_targets(arguments);
  if (typed.size() == 1) return typed.front();
  throw InputError(
      fmt::format("give exactly one of --damping-ratio, --log-decrement, --quality-factor, "
                  "--loss-factor, --bond-damping, --retardation-time{}",
                  typed.empty() ? ", or --material for its own damping"
                                : fmt::format(", not {}", fmt::join(typed, " and "))));
}

CalibratedFiber calibrated_fiber(const Arguments& arguments, const Quantities& typed) {
  refuse_both(typed, "--poisson-ratio", "--shear-modulus");
  CalibratedFiber found{shaped_fiber(arguments, typed), is_dimensional(arguments), std::nullopt};
  dem::Fiber& fiber = found.fiber;
  if (arguments.has("--material")) {
    found.material = dem::find_material(arguments.text("--material"), {}, typed.units());
    fiber.material = named_material(typed, *found.material);
  } else {
    fiber.material = material_of(typed, fiber.material);
  }
  fiber.dashpots = choice<DashpotLaw>(arguments, "--dashpots", DashpotLaw::bond_damping,
                                      {{"bond_damping", DashpotLaw::bond_damping},
                                       {"retardation_time", DashpotLaw::retardation_time},
                                       {"bending_only", DashpotLaw::bending_only}});
  return found;
}

dem::Fiber identified_fiber(const Arguments& arguments, const Quantities& typed) {
  dem::Fiber fiber = shaped_fiber(arguments, typed);
  fiber.material = material_of(typed, fiber.material);
  return fiber;
}

}  // namespace fiberchain::app
