#include "compare/app/calibrate_case.hpp"
#include "compare/app/results.hpp"
#include "compare/calibration/material_table.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

using compare::MaterialAnswer;

const std::vector<std::string> material_shown = {
    "material",        "aspect_ratio",    "stiffness_stretch", "stiffness_shear", "stiffness_twist",
    "stiffness_bend",  "relaxed_modulus", "thermal_peak",      "time_step",       "bond_damping",
    "dashpot_stretch", "dashpot_shear",   "dashpot_twist",     "dashpot_bend"};

/// The material's own damping with what is typed in its place.
dem::MaterialDamping damping_of(const Quantities& typed, const std::optional<dem::MaterialData>& data) {
  dem::MaterialDamping damping = data ? dem::damping_of(*data) : dem::MaterialDamping{};
  if (typed.has("--loss-factor")) damping.loss_factor = typed.number("--loss-factor");
  if (typed.has("--shear-loss-factor")) damping.shear_loss_factor = typed.number("--shear-loss-factor");
  if (typed.has("--band")) damping.band = typed.band("--band");
  if (typed.has("--modulus-frequency"))
    damping.modulus_frequency = typed.quantity("--modulus-frequency", "Hz");
  if (const auto count = typed.number("--branches")) damping.branches = static_cast<int>(*count);
  const bool flat = damping.loss_factor || damping.shear_loss_factor;
  if (typed.has("--band") && !flat)
    throw compare::InputError("--band: is of use only with a loss factor, and the material has none");
  return damping;
}

void refuse_dashpots(const Arguments& arguments) {
  for (const char* option :
       {"--dashpots", "--load", "--tip-deflection", "--at-amplitude", "--step-ratio", "--verify"}) {
    if (arguments.has(option))
      throw compare::InputError(std::string(option) + ": is of use only with a target or a setting");
  }
}

}  // namespace

int run_calibrate_material(const Arguments& arguments, Context& context) {
  refuse_dashpots(arguments);
  OutputOptions output;
  output.json = arguments.has("--json");
  std::optional<dem::OutputDirectory> directory;
  if (arguments.has("--out")) directory.emplace(arguments.text("--out"));
  const Quantities typed(arguments);
  const CalibratedFiber asked = calibrated_fiber(arguments, typed);
  const MaterialAnswer answer = compare::answer_material({asked.fiber, damping_of(typed, asked.material)});
  const std::string name = asked.material ? asked.material->name : "";
  const dem::Fiber& dashpots = answer.dashpots ? answer.dashpots->fiber : answer.asked.fiber;
  const double step = answer.dashpots ? answer.dashpots->step : answer.step;
  const Results results{
      .name = "calibrate",
      .heading = "Damping of the bonds by the material",
      .table = compare::material_answer_table(answer, name),
      .notes = compare::material_answer_notes(answer, asked.material),
      .more_tables = {{"calibrate-modes", compare::material_modes_table(answer)},
                      {"calibrate-branches", compare::branches_table(answer.damped.fiber.branches)},
                      {"calibrate-codes", compare::codes_table(dashpots, step)}}};
  deliver(results, results.table.select(material_shown), output, directory, context);
  return kSuccess;
}

}  // namespace fiberchain::app
