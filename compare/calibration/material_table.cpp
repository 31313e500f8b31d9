#include "compare/calibration/material_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compare/calibration/codes.hpp"
#include "compare/study/markdown.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/record/columns.hpp"

namespace fiberchain::compare {
namespace {

/// The fiber whose dashpots stand in for the branches, or the one without damping.
const dem::Fiber& dashpot_fiber(const MaterialAnswer& answer) {
  return answer.dashpots ? answer.dashpots->fiber : answer.asked.fiber;
}

double dashpot_step(const MaterialAnswer& answer) {
  return answer.dashpots ? answer.dashpots->step : answer.step;
}

dem::Cell optional_cell(const std::optional<double>& value) {
  return value ? dem::Cell{*value} : dem::Cell{dem::Missing{}};
}

dem::NamedRow damping_row(const MaterialAnswer& answer) {
  const dem::DampingSummary& summary = answer.damped.summary;
  const auto& damping = answer.asked.damping;
  const bool flat = summary.ripple > 0;
  return {{"material_loss_factor", optional_cell(damping.loss_factor)},
          {"band_low", flat ? dem::Cell{damping.band->low} : dem::Cell{}},
          {"band_high", flat ? dem::Cell{damping.band->high} : dem::Cell{}},
          {"loss_ripple", flat ? dem::Cell{summary.ripple} : dem::Cell{}},
          {"relaxation_strength", summary.peak ? dem::Cell{summary.relaxation_strength} : dem::Cell{}},
          {"thermal_peak", optional_cell(summary.peak)},
          {"relaxed_modulus", answer.damped.fiber.material.youngs_modulus},
          {"relaxed_shear_modulus", answer.damped.fiber.material.shear_modulus},
          {"time_step", answer.step}};
}

dem::NamedRow dashpot_row(const MaterialAnswer& answer) {
  const dem::Fiber& fiber = dashpot_fiber(answer);
  const dem::BondStiffness k = dem::bond_stiffness(fiber);
  const dem::BondDashpot c = dem::bond_dashpot(fiber);
  const bool has = answer.dashpots.has_value();
  const auto cell = [&](double value) { return has ? dem::Cell{value} : dem::Cell{}; };
  return {{"bond_damping", cell(fiber.bond_damping)},
          {"stable_time_step", has ? answer.dashpots->stable_step : answer.step / 0.8},
          {"stiffness_stretch", k.stretch},
          {"stiffness_shear", k.shear},
          {"stiffness_twist", k.twist},
          {"stiffness_bend", k.bend},
          {"dashpot_stretch", cell(c.stretch)},
          {"dashpot_shear", cell(c.shear)},
          {"dashpot_twist", cell(c.twist)},
          {"dashpot_bend", cell(c.bend)}};
}

dem::NamedRow mode_row(const MaterialAnswer& answer, const MaterialMode& mode) {
  const auto& peak = answer.damped.summary.peak;
  const auto n = static_cast<std::size_t>(mode.number - 1);
  const bool dashpots = n < answer.dashpot_damping.size();
  return {
      {"mode", std::int64_t{mode.number}},
      {"mode_frequency", mode.frequency},
      {"peak_ratio", peak ? dem::Cell{mode.frequency / *peak} : dem::Cell{}},
      {"mode_damping", mode.damping},
      {"mode_damping_beam", mode.beam_damping},
      {"mode_error", mode.damping / mode.beam_damping - 1},
      {"mode_ripple", optional_cell(mode.ripple)},
      {"mechanism", std::string(mode.thermoelastic_part > mode.flat_part ? "thermoelastic" : "loss factor")},
      {"flat_part", mode.flat_part},
      {"thermoelastic_part", mode.thermoelastic_part},
      {"mode_damping_dashpots", dashpots ? dem::Cell{answer.dashpot_damping[n]} : dem::Cell{}}};
}

std::string band_words(const MaterialAnswer& answer) {
  if (!answer.asked.band_of_modes) return "";
  const dem::FrequencyBand& band = *answer.asked.damping.band;
  return fmt::format(
      "- Nobody says over which band the loss factor holds: {:.4g} to {:.4g} Hz are taken, a "
      "third of mode 1 to three times mode 5; --band says another.\n",
      band.low, band.high);
}

std::string total_words(const std::optional<dem::MaterialData>& data, const MaterialAnswer& answer) {
  if (!data || !data->loss_factor || !data->loss_factor->total || answer.asked.damping.loss_factor) return "";
  return fmt::format(
      "- The loss factor {:g} of the file is a total in which a thermoelastic part may be: "
      "thermoelasticity alone is taken; --loss-factor and --band add one.\n",
      data->loss_factor->value);
}

std::string dashpot_words(const MaterialAnswer& answer) {
  if (!answer.dashpots) return "- Codes that have dashpots only: no dashpots, " + answer.no_dashpots + ".\n";
  return fmt::format(
      "- Codes that have dashpots only: xi_b = {:.6g} on the moduli as given meets zeta of mode 1 alone, the "
      "others are in mode_damping_dashpots. Step {:.4g} s.\n",
      answer.dashpots->fiber.bond_damping, answer.dashpots->step);
}

std::string sources_of(const dem::MaterialData& data) {
  std::vector<std::string> sources;
  for (const auto* value :
       {&data.youngs_modulus, &data.poisson_ratio, &data.shear_modulus, &data.density, &data.loss_factor,
        &data.shear_loss_factor, &data.thermal_expansion, &data.heat_capacity, &data.conductivity}) {
    if (*value && !std::ranges::count(sources, (*value)->source)) sources.push_back((*value)->source);
  }
  return fmt::format("{}", fmt::join(sources, ", "));
}

dem::Cell cell_of(const std::optional<dem::MaterialValue>& value) {
  return value ? dem::Cell{value->value} : dem::Cell{dem::Missing{}};
}

dem::NamedRow data_row(const dem::MaterialData& data) {
  dem::Cell strength, peak;
  if (const auto thermal = dem::thermal_properties(data); thermal && data.youngs_modulus && data.density) {
    strength = dem::relaxation_strength(*thermal, data.youngs_modulus->value, data.density->value);
    peak = dem::thermal_peak(dem::thermal_diffusivity(*thermal, data.density->value), 0.5);
  }
  return {{"material", data.name},
          {"youngs_modulus", cell_of(data.youngs_modulus)},
          {"poisson_ratio", cell_of(data.poisson_ratio)},
          {"shear_modulus", cell_of(data.shear_modulus)},
          {"density", cell_of(data.density)},
          {"material_loss_factor", cell_of(data.loss_factor)},
          {"relaxation_strength", strength},
          {"peak_diameter_squared", peak},
          {"sources", sources_of(data)}};
}

}  // namespace

dem::Table material_answer_table(const MaterialAnswer& answer, const std::string& material) {
  const dem::Fiber& fiber = answer.asked.fiber;
  const dem::NamedRow about = {{"material", material.empty() ? dem::Cell{} : dem::Cell{material}},
                               {"aspect_ratio", std::int64_t{fiber.aspect_ratio}},
                               {"diameter", fiber.diameter},
                               {"youngs_modulus", fiber.material.youngs_modulus},
                               {"shear_modulus", fiber.material.shear_modulus},
                               {"density", fiber.material.density},
                               {"mass", std::string(dem::name(fiber.mass))},
                               {"bond", std::string(dem::name(fiber.bond_model))}};
  return table_of(joined(joined(about, damping_row(answer)), dashpot_row(answer)));
}

dem::Table material_modes_table(const MaterialAnswer& answer) {
  dem::Table table(names_of(mode_row(answer, MaterialMode{})));
  for (const MaterialMode& mode : answer.modes) table.append(mode_row(answer, mode));
  return table;
}

dem::Table branches_table(const dem::MaxwellBranches& branches) {
  dem::Table table({"spring", "branch_strength", "branch_time"});
  const auto add = [&](const char* spring, const dem::PronySeries& series) {
    for (const dem::MaxwellBranch& branch : series)
      table.append({{"spring", std::string(spring)},
                    {"branch_strength", branch.strength},
                    {"branch_time", branch.time}});
  };
  add("stretch", branches.stretch);
  add("shear", branches.shear);
  add("twist", branches.twist);
  add("bend", branches.bend);
  return table;
}

dem::Table codes_table(const dem::Fiber& fiber, double time_step) {
  dem::Table table({"code", "line"});
  for (const auto& lines : {lammps_lines(fiber, time_step), liggghts_lines(fiber, time_step)}) {
    for (const CodeLine& line : lines) table.append({{"code", line.code}, {"line", line.line}});
  }
  return table;
}

std::string codes_notes(const dem::Table& codes) {
  std::string text, code;
  for (std::size_t row = 0; row < codes.rows().size(); ++row) {
    if (codes.text(row, "code") != code) {
      text += (code.empty() ? "" : "```\n\n") + codes.text(row, "code") + ":\n\n```\n";
      code = codes.text(row, "code");
    }
    text += codes.text(row, "line") + "\n";
  }
  return text + "```\n";
}

std::string material_answer_notes(const MaterialAnswer& answer,
                                  const std::optional<dem::MaterialData>& data) {
  std::string text;
  if (!answer.modes.empty()) {
    text =
        "Modes of the clamped fiber in free decay; the error is the chain's against a uniform beam of the "
        "fiber's own mass and without shear, which has its own loss:\n\n" +
        dem::to_markdown(material_modes_table(answer)) +
        "\nMaxwell branches beside each spring, on the relaxed moduli:\n\n" +
        dem::to_markdown(branches_table(answer.damped.fiber.branches)) + "\n";
  } else {
    text =
        "- Nothing damps this fiber: neither a loss factor nor thermal data of the material are known; "
        "--loss-factor with --band gives it one.\n";
  }
  return text + band_words(answer) + total_words(data, answer) + dashpot_words(answer) + "\n" +
         codes_notes(codes_table(dashpot_fiber(answer), dashpot_step(answer)));
}

dem::Table materials_table(const std::vector<dem::MaterialData>& materials) {
  return tabulate(materials, &data_row);
}

}  // namespace fiberchain::compare
