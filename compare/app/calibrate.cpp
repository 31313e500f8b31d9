#include <fmt/format.h>

#include <array>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/calibration/table.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/units.hpp"

namespace fiberchain::app {
namespace {

using compare::AmplitudeMeasure;
using compare::CalibrationAnswer;
using compare::CalibrationCase;
using compare::DampingMeasure;
using compare::InputError;
using dem::DashpotLaw;

/// The columns worth a look on a terminal; the files and the JSON have them all.
const std::vector<std::string> calibrate_shown = {"aspect_ratio",
                                                  "dashpots",
                                                  "bond_damping",
                                                  "retardation_time",
                                                  "fiber_damping_modes",
                                                  "natural_frequency",
                                                  "natural_frequency_hertz",
                                                  "stable_time_step",
                                                  "stable_step_ratio",
                                                  "expected_error"};

constexpr std::array kTargets = {
    std::pair{"--damping-ratio", DampingMeasure::damping_ratio},
    std::pair{"--log-decrement", DampingMeasure::log_decrement},
    std::pair{"--quality-factor", DampingMeasure::quality_factor},
    std::pair{"--loss-factor", DampingMeasure::loss_factor},
};
constexpr std::array kSettings = {"--bond-damping", "--retardation-time"};

/// A quantity with its unit, or a bare number in SI units. The database of units is read only where one is
/// typed.
double quantity(const Arguments& arguments, const std::string& option, const std::string& si, double usual) {
  if (!arguments.has(option)) return usual;
  const std::string text = arguments.text(option);
  if (const auto number = dem::parse_number(text)) return *number;
  const dem::Units units;
  try {
    return units.to_si(text, si);
  } catch (const dem::UnitError& error) {
    throw InputError(fmt::format("{}: '{}' {}", option, text, error.what()));
  }
}

double number(const Arguments& arguments, const std::string& option, double usual) {
  if (!arguments.has(option)) return usual;
  if (const auto value = dem::parse_number(arguments.text(option))) return *value;
  throw InputError(fmt::format("{}: '{}' is no number", option, arguments.text(option)));
}

void refuse_both(const Arguments& arguments, const std::string& one, const std::string& other) {
  if (arguments.has(one) && arguments.has(other))
    throw InputError(fmt::format("{} and {}: give only one", one, other));
}

dem::Material material_of(const Arguments& arguments, const dem::Material& usual) {
  refuse_both(arguments, "--poisson-ratio", "--shear-modulus");
  const double youngs_modulus = quantity(arguments, "--youngs-modulus", "Pa", usual.youngs_modulus);
  const double density = quantity(arguments, "--density", "kg/m^3", usual.density);
  if (arguments.has("--shear-modulus")) {
    return {youngs_modulus, quantity(arguments, "--shear-modulus", "Pa", 0), density};
  }
  return dem::isotropic_material(youngs_modulus,
                                 number(arguments, "--poisson-ratio", dem::poisson_ratio(usual)), density);
}

/// Whether size and material of a real fiber were given, all three of them; some of them are a mistake.
bool is_dimensional(const Arguments& arguments) {
  const std::vector<std::string> needed = {"--youngs-modulus", "--density", "--diameter"};
  std::vector<std::string> missing;
  for (const std::string& option : needed) {
    if (!arguments.has(option)) missing.push_back(option);
  }
  const bool in_seconds =
      arguments.has("--retardation-time") || arguments.text("--dashpots") == "retardation_time";
  const bool wanted = missing.size() < needed.size() || arguments.has("--shear-modulus") || in_seconds;
  if (wanted && !missing.empty()) {
    throw InputError(
        fmt::format("{} missing: an answer in seconds needs {}; without any of them, without "
                    "--shear-modulus and retardation times, the answers are ratios",
                    fmt::join(missing, ", "), fmt::join(needed, ", ")));
  }
  return missing.empty();
}

template <class Value>
Value choice(const Arguments& arguments, const std::string& option, Value usual,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<Value> chosen{usual};
  read_choices<Value>(arguments, option, chosen, choices);
  if (chosen.size() != 1) throw InputError(fmt::format("{}: give only one", option));
  return chosen.front();
}

/// The fiber without its dashpots' setting.
dem::Fiber fiber_of(const Arguments& arguments) {
  using dem::BondModel;
  int aspect_ratio = 0;
  read_number(arguments, "--aspect-ratio", {.low = 1, .high = 1000}, aspect_ratio);
  dem::Fiber fiber = compare::nominal_fiber(aspect_ratio, 0.3, BondModel::paper);
  fiber.material = material_of(arguments, fiber.material);
  fiber.diameter = quantity(arguments, "--diameter", "m", fiber.diameter);
  fiber.bond_model = choice<BondModel>(arguments, "--bond", BondModel::paper,
                                       {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  using dem::MassModel;
  fiber.mass = choice<MassModel>(arguments, "--mass", fiber.mass,
                                 {{"spheres", MassModel::spheres}, {"cylinder", MassModel::cylinder}});
  fiber.dashpots = choice<DashpotLaw>(arguments, "--dashpots", DashpotLaw::bond_damping,
                                      {{"bond_damping", DashpotLaw::bond_damping},
                                       {"retardation_time", DashpotLaw::retardation_time},
                                       {"bending_only", DashpotLaw::bending_only}});
  return fiber;
}

CalibrationCase case_of(const Arguments& arguments) {
  refuse_both(arguments, "--load", "--tip-deflection");
  CalibrationCase asked{fiber_of(arguments)};
  asked.dimensional = is_dimensional(arguments);
  const bool by_load = arguments.has("--load");
  asked.amplitude = compare::to_amplitude(by_load ? AmplitudeMeasure::load : AmplitudeMeasure::tip_deflection,
                                          number(arguments, by_load ? "--load" : "--tip-deflection", 0));
  if (arguments.has("--step-ratio")) asked.step_ratio = number(arguments, "--step-ratio", 0);
  return asked;
}

/// The one of these options that says what is known.
std::string known(const Arguments& arguments) {
  std::vector<std::string> all, typed;
  for (const auto& [option, measure] : kTargets) all.push_back(option);
  all.insert(all.end(), kSettings.begin(), kSettings.end());
  for (const std::string& option : all) {
    if (arguments.has(option)) typed.push_back(option);
  }
  if (typed.size() == 1) return typed.front();
  throw InputError(fmt::format("give exactly one of {}{}", fmt::join(all, ", "),
                               typed.empty() ? "" : fmt::format(", not {}", fmt::join(typed, " and "))));
}

/// The other way round: the dashpots' setting is given.
CalibrationAnswer from_setting(CalibrationCase asked, const Arguments& arguments, const std::string& option) {
  if (option == "--retardation-time") {
    if (arguments.has("--dashpots") && asked.fiber.dashpots != DashpotLaw::retardation_time) {
      throw InputError("--retardation-time goes with --dashpots retardation_time only");
    }
    asked.fiber.dashpots = DashpotLaw::retardation_time;
    asked.fiber.retardation_time = quantity(arguments, option, "s", 0);
  } else {
    if (asked.fiber.dashpots == DashpotLaw::retardation_time) {
      throw InputError(
          "--bond-damping does not go with --dashpots retardation_time: give --retardation-time");
    }
    asked.fiber.bond_damping = number(arguments, option, 0);
  }
  return {asked, std::nullopt, calibration_of(asked)};
}

CalibrationAnswer answer_of(const Arguments& arguments) {
  const std::string option = known(arguments);
  const CalibrationCase asked = case_of(arguments);
  for (const auto& [name, measure] : kTargets) {
    if (option != name) continue;
    const double target = compare::to_damping_ratio(measure, number(arguments, option, 0));
    const double change = arguments.has("--at-amplitude") ? compare::amplitude_effect(asked.amplitude) : 0;
    return {asked, target, calibrate(asked, target / (1 + change))};
  }
  return from_setting(asked, arguments, option);
}

int run_calibrate(const Arguments& arguments, Context& context) {
  OutputOptions output;
  output.json = arguments.has("--json");
  std::optional<dem::OutputDirectory> directory;
  if (arguments.has("--out")) directory.emplace(arguments.text("--out"));
  CalibrationAnswer answer = answer_of(arguments);
  if (arguments.has("--verify")) answer.run = verify(answer.found, answer.asked.amplitude);
  Results results{.name = "calibrate",
                  .heading = "Damping of the bonds for a damping of the fiber",
                  .table = compare::calibration_table({answer}),
                  .notes = compare::calibration_notes(answer)};
  deliver(results, results.table.select(calibrate_shown), output, directory, context);
  return kSuccess;
}

}  // namespace

Command calibrate_command() {
  return {
      .name = "calibrate",
      .description = "the damping of the bonds that gives a fiber its material's damping, and the reverse",
      .footer =
          "Give one target (--damping-ratio, --log-decrement, --quality-factor, --loss-factor) or, for the "
          "reverse, one\n"
          "setting (--bond-damping, --retardation-time). Quantities take units; bare numbers are SI.\n"
          "Without size and material the answers are ratios; --youngs-modulus, --density and --diameter "
          "together give them in seconds.\n"
          "Examples:\n"
          "  fiberchain calibrate --damping-ratio 0.02 --aspect-ratio 20 --verify\n"
          "  fiberchain calibrate --bond-damping 1 --aspect-ratio 10 --poisson-ratio 0.17 --json",
      .options =
          {{"--damping-ratio", "NUMBER", "target: xi_f"},
           {"--log-decrement", "NUMBER", "target: 2 pi xi_f/sqrt(1 - xi_f^2)"},
           {"--quality-factor", "NUMBER", "target: 1/(2 xi_f)"},
           {"--loss-factor", "NUMBER", "target: 2 xi_f"},
           {"--bond-damping", "NUMBER", "reverse: xi_b"},
           {"--retardation-time", "TIME", "reverse: retardation time of all bonds"},
           {"--dashpots", "WORD", "bond_damping, retardation_time, bending_only [bond_damping]"},
           {"--bond", "WORD", "bond law: paper, corrected [paper]"},
           {"--aspect-ratio", "NUMBER", "r_f = L/d, number of bonds, 1 to 1000", OptionKind::required},
           {"--youngs-modulus", "PRESSURE", "E; with --density and --diameter, for answers in seconds"},
           {"--poisson-ratio", "NUMBER", "Poisson's ratio [0.3]"},
           {"--shear-modulus", "PRESSURE", "G, in place of Poisson's ratio"},
           {"--density", "DENSITY", "of the material"},
           {"--mass", "WORD", "what the chain weighs: spheres (two thirds of the fiber), cylinder [spheres]"},
           {"--diameter", "LENGTH", "d"},
           {"--load", "NUMBER", "expected amplitude: load before the release, P L^2/(E I), up to 2.4 [0]"},
           {"--tip-deflection", "NUMBER", "expected amplitude: y/L of the free end, up to 0.55 [0]"},
           {"--at-amplitude", "", "the target was measured at that amplitude, not at a vanishing one",
            OptionKind::flag},
           {"--step-ratio", "NUMBER", "time step over t_b [0.25, at most 0.8 of the largest stable one]"},
           {"--verify", "", "run the chain, at the amplitude given, and report its damping",
            OptionKind::flag},
           json_option(),
           {"--out", "DIR", "directory for the results [none]"}},
      .run = &run_calibrate};
}

}  // namespace fiberchain::app
