#include <fmt/format.h>

#include <array>

#include "compare/app/calibrate_case.hpp"
#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/calibration/material_table.hpp"
#include "compare/calibration/table.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

using compare::AmplitudeMeasure;
using compare::CalibrationAnswer;
using compare::CalibrationCase;
using compare::DampingMeasure;
using compare::InputError;
using dem::DashpotLaw;

constexpr std::array kOfMaterial = {"--band", "--shear-loss-factor", "--branches", "--modulus-frequency"};

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
CalibrationCase case_of(const Quantities& typed, const CalibratedFiber& from) {
  if (typed.has("--load") && typed.has("--tip-deflection"))
    throw InputError("--load and --tip-deflection: give only one");
  CalibrationCase asked{from.fiber};
  asked.dimensional = from.dimensional;
  const bool by_load = typed.has("--load");
  asked.amplitude = compare::to_amplitude(by_load ? AmplitudeMeasure::load : AmplitudeMeasure::tip_deflection,
                                          typed.number(by_load ? "--load" : "--tip-deflection", 0));
  if (typed.has("--step-ratio")) asked.step_ratio = typed.number("--step-ratio", 0);
  return asked;
}

/// The other way round: the dashpots' setting is given.
CalibrationAnswer from_setting(CalibrationCase asked, const Quantities& typed, const std::string& option) {
  if (option == "--retardation-time") {
    if (typed.has("--dashpots") && asked.fiber.dashpots != DashpotLaw::retardation_time) {
      throw InputError("--retardation-time goes with --dashpots retardation_time only");
    }
    asked.fiber.dashpots = DashpotLaw::retardation_time;
    asked.fiber.retardation_time = typed.quantity(option, "s", 0);
  } else {
    if (asked.fiber.dashpots == DashpotLaw::retardation_time) {
      throw InputError(
          "--bond-damping does not go with --dashpots retardation_time: give --retardation-time");
    }
    asked.fiber.bond_damping = typed.number(option, 0);
  }
  return {asked, std::nullopt, calibration_of(asked)};
}

CalibrationAnswer answer_of(const Arguments& arguments) {
  const std::string option = known_target(arguments);
  const Quantities typed(arguments);
  const CalibrationCase asked = case_of(typed, calibrated_fiber(arguments, typed));
  for (const auto& [name, measure] : kTargets) {
    if (option != name) continue;
    const double target = compare::to_damping_ratio(measure, typed.number(option, 0));
    const double change = arguments.has("--at-amplitude") ? compare::amplitude_effect(asked.amplitude) : 0;
    return {asked, target, calibrate(asked, target / (1 + change))};
  }
  return from_setting(asked, typed, option);
}

int run_calibrate(const Arguments& arguments, Context& context) {
  const bool own = arguments.has("--material") || arguments.has("--band");
  if (own && calibration_targets(arguments).empty()) return run_calibrate_material(arguments, context);
  for (const char* option : kOfMaterial) {
    if (arguments.has(option))
      throw InputError(std::string(option) +
                       ": is of use only with a material's own damping, without a target");
  }
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
  if (answer.asked.dimensional) {
    const dem::Table codes = compare::codes_table(answer.found.fiber, answer.found.step);
    results.notes += "\n" + compare::codes_notes(codes);
    results.more_tables = {{"calibrate-codes", codes}};
  }
  deliver(results, results.table.select(calibrate_shown), output, directory, context);
  return kSuccess;
}

}  // namespace

Command calibrate_command() {
  return {
      .name = "calibrate",
      .description = "the damping of the bonds that gives a fiber its material's damping, and the reverse",
      .footer =
          "Give a material for its own damping (branches to set, zeta of five modes, lines for other codes), "
          "or\n"
          "one target (--damping-ratio, --log-decrement, --quality-factor, --loss-factor) or, for the "
          "reverse, one\n"
          "setting (--bond-damping, --retardation-time). Quantities take units; bare numbers are SI.\n"
          "Without size and material the answers are ratios; --diameter with --material, or with "
          "--youngs-modulus and\n"
          "--density, gives them in seconds. A material's values give way to those typed. Of a loss factor "
          "whose source\n"
          "names no band, a band about the fiber's five modes is taken and said.\n"
          "Examples:\n"
          "  fiberchain calibrate --material carbon-steel --diameter 2e-5 --aspect-ratio 20\n"
          "  fiberchain calibrate --damping-ratio 0.02 --aspect-ratio 20 --verify\n"
          "  fiberchain calibrate --bond-damping 1 --aspect-ratio 10 --poisson-ratio 0.17 --json",
      .options =
          {{"--material", "NAME", "of `fiberchain materials`, or a .yaml file"},
           {"--damping-ratio", "NUMBER", "target: xi_f"},
           {"--log-decrement", "NUMBER", "target: 2 pi xi_f/sqrt(1 - xi_f^2)"},
           {"--quality-factor", "NUMBER", "target: 1/(2 xi_f)"},
           {"--loss-factor", "NUMBER", "target: 2 xi_f; with --band the material's"},
           {"--band", "BAND", "'10 Hz,10 kHz': where the material's loss factor is flat"},
           {"--shear-loss-factor", "NUMBER", "of the shear modulus [that of Young's modulus]"},
           {"--branches", "NUMBER", "Maxwell branches of a flat loss factor [within 1.5 %]"},
           {"--modulus-frequency", "FREQUENCY", "at which E and G were measured [middle of the band]"},
           {"--bond-damping", "NUMBER", "reverse: xi_b"},
           {"--retardation-time", "TIME", "reverse: retardation time of all bonds"},
           {"--dashpots", "WORD", "bond_damping, retardation_time, bending_only [bond_damping]"},
           {"--bond", "WORD", "bond law: paper, corrected [paper]"},
           {"--aspect-ratio", "NUMBER", "r_f = L/d, number of bonds, 1 to 1000", OptionKind::required},
           {"--youngs-modulus", "PRESSURE", "E"},
           {"--poisson-ratio", "NUMBER", "Poisson's ratio [0.3]"},
           {"--shear-modulus", "PRESSURE", "G, in place of Poisson's ratio"},
           {"--density", "DENSITY", "of the solid"},
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
