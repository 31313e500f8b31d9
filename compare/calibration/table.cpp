#include "compare/calibration/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/measure/peaks.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/record/columns.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

double expected_error(const Calibration& found) { return found.amplitude_effect + found.time_step_effect; }

dem::Cell optional(const std::optional<double>& value) {
  return value ? dem::Cell{*value} : dem::Cell{dem::Missing{}};
}

dem::NamedRow material_row(const CalibrationAnswer& answer) {
  const dem::Fiber& fiber = answer.found.fiber;
  return {{"aspect_ratio", std::int64_t{fiber.aspect_ratio}},
          {"poisson_ratio", dem::known(dem::poisson_ratio(fiber.material))},
          {"youngs_modulus", fiber.material.youngs_modulus},
          {"shear_modulus", fiber.material.shear_modulus},
          {"density", fiber.material.density},
          {"diameter", fiber.diameter},
          {"mass", std::string(dem::name(fiber.mass))},
          {"bond", std::string(dem::name(fiber.bond_model))},
          {"dashpots", std::string(dem::name(fiber.dashpots))},
          {"target_damping", optional(answer.target)}};
}

dem::NamedRow damping_row(const Calibration& found, double amplitude) {
  const bool retarded = found.fiber.dashpots == dem::DashpotLaw::retardation_time;
  return {{"bond_damping", retarded ? dem::Cell{} : dem::Cell{found.setting}},
          {"retardation_time", found.retardation_time},
          {"retardation_ratio", found.retardation_time / found.bond_time},
          {"fiber_damping_modes", found.damping_ratio},
          {"log_decrement", log_decrement(found.damping_ratio)},
          {"quality_factor", 1 / (2 * found.damping_ratio)},
          {"loss_factor", 2 * found.damping_ratio},
          {"natural_frequency", found.natural_frequency},
          {"natural_frequency_hertz", found.natural_frequency / (2 * pi)},
          {"bond_time", found.bond_time},
          {"stable_time_step", found.stable_step},
          {"stable_step_ratio", found.stable_step / found.bond_time},
          {"step_ratio", found.step / found.bond_time},
          {"verification_cost", verification_cost(found, amplitude)}};
}

dem::NamedRow error_row(const CalibrationAnswer& answer) {
  const Calibration& found = answer.found;
  return {{"amplitude", answer.asked.amplitude},
          {"amplitude_effect", found.amplitude_effect},
          {"time_step_effect", found.time_step_effect},
          {"expected_error", expected_error(found)},
          {"fiber_damping_expected", found.damping_ratio * (1 + expected_error(found))},
          {"fiber_damping_beam", found.beam_damping},
          {"damping_mass", found.damping_departure.mass},
          {"damping_discretization", found.damping_departure.discretization},
          {"damping_shear", found.damping_departure.shear},
          {"beam_frequency", found.beam_frequency},
          {"frequency_mass", found.frequency_departure.mass},
          {"frequency_discretization", found.frequency_departure.discretization},
          {"frequency_shear", found.frequency_departure.shear}};
}

dem::NamedRow run_row(const CalibrationAnswer& answer) {
  const auto cell = [&](double Verification::*part) {
    return answer.run ? dem::Cell{*answer.run.*part} : dem::Cell{};
  };
  return {{"fiber_damping", cell(&Verification::damping_ratio)},
          {"verified_amplitude", cell(&Verification::amplitude)},
          {"verified_expected", cell(&Verification::expected)},
          {"verified_difference", cell(&Verification::difference)}};
}

/// Without the fiber's size and material nothing in meters, seconds or pascals is known.
void leave_out_dimensional(dem::NamedRow& row) {
  for (auto& [column, cell] : row) {
    const std::string_view unit = dem::find_column(column).unit;
    if (!unit.empty() && unit != "1") cell = dem::Missing{};
  }
}

std::string beam_frequency_text(const CalibrationAnswer& answer) {
  return answer.asked.dimensional ? fmt::format(" {:.6g} rad/s", answer.found.beam_frequency) : "";
}

std::string mass_text(const dem::Fiber& fiber) {
  return fiber.mass == dem::MassModel::cylinder ? "the fiber's own"
                                                : "two thirds of the fiber's; --mass cylinder gives it all";
}

std::string run_note(const CalibrationAnswer& answer) {
  if (!answer.run) return "";
  const Verification& run = *answer.run;
  const std::string start = answer.asked.amplitude > 0
                                ? fmt::format("its equilibrium at y/L = {:.3g}", answer.asked.amplitude)
                                : "the first mode at y/L = 1/300";
  return fmt::format(
      "Run: released from {} and marched at {:.4g} t_b, the chain has xi_f = {:.8g} at peaks of y/L = {:.3g} "
      "(root mean square), {:+.2e} of the {:.8g} expected at these ({:.2g} bond-steps).\n",
      start, run.time_step / answer.found.bond_time, run.damping_ratio, run.amplitude, run.difference,
      run.expected, run.bond_steps);
}

}  // namespace

dem::Table calibration_table(const std::vector<CalibrationAnswer>& answers) {
  return tabulate(answers, [](const CalibrationAnswer& answer) {
    dem::NamedRow row =
        joined(joined(joined(material_row(answer), damping_row(answer.found, answer.asked.amplitude)),
                      error_row(answer)),
               run_row(answer));
    if (!answer.asked.dimensional) leave_out_dimensional(row);
    return row;
  });
}

std::string calibration_notes(const CalibrationAnswer& answer) {
  const Calibration& f = answer.found;
  return fmt::format(
             "- Expected of a run that swings to y/L = {:.3g}: xi_f changed by {:+.2e} of itself, {:+.2e} by "
             "the amplitude (a "
             "real fiber does that too) and {:+.2e} by a time step of {:.4g} t_b.\n"
             "- Made up for by the setting: the fiber, a uniform beam, has xi_f = {:.6g} with this "
             "retardation "
             "time; the chain's is {:+.2e} of that by the mass of its spheres, {:+.2e} by finite bonds and "
             "the "
             "end sphere and {:+.2e} by shear.\n"
             "- Not made up for: the chain's natural frequency is off the fiber's{} by {:+.2e} by the mass "
             "of "
             "its spheres ({}), {:+.2e} by finite bonds and the end sphere and {:+.2e} by shear.\n",
             answer.asked.amplitude, expected_error(f), f.amplitude_effect, f.time_step_effect,
             f.step / f.bond_time, f.beam_damping, f.damping_departure.mass,
             f.damping_departure.discretization, f.damping_departure.shear, beam_frequency_text(answer),
             f.frequency_departure.mass, mass_text(f.fiber), f.frequency_departure.discretization,
             f.frequency_departure.shear) +
         (answer.run ? "- " + run_note(answer) : "");
}

}  // namespace fiberchain::compare
