#include "compare/fit/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

/// Number `i` of a list that may be shorter.
dem::Cell entry(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? dem::Cell{values[i]} : dem::Cell{dem::Missing{}};
}

/// Value, half width, variance of parameter `i` if the law has it under this name.
struct FittedParameter {
  dem::Cell value, half_width, variance;
};
FittedParameter parameter(const DampingFit& fit, bool has, std::size_t i) {
  if (!has) return {};
  return {entry(fit.parameters, i), entry(fit.half_widths, i),
          fit.covariance.empty() ? dem::Cell{} : dem::Cell{fit.covariance[i][i]}};
}

dem::NamedRow row_of(const DampingFit& fit) {
  const bool shifted = fit.model.law == DampingLaw::shifted_square;
  const FittedParameter a = parameter(fit, !shifted, 0), b = parameter(fit, !shifted, 1),
                        c = parameter(fit, shifted, 0);
  const bool both = !shifted && !fit.covariance.empty();
  return {{"law", std::string(name(fit.model.law))},
          {"weighting", std::string(name(fit.model.kind))},
          {"fit_a", a.value},
          {"fit_a_half_width", a.half_width},
          {"fit_b", b.value},
          {"fit_b_half_width", b.half_width},
          {"fit_c", c.value},
          {"fit_c_half_width", c.half_width},
          {"fit_a_variance", a.variance},
          {"fit_b_variance", b.variance},
          {"fit_ab_covariance", both ? dem::Cell{fit.covariance[0][1]} : dem::Cell{}},
          {"fit_c_variance", c.variance},
          {"fit_points", static_cast<std::int64_t>(fit.fitted.residuals.size())},
          {"fit_rms", fit.fitted.rms},
          {"fit_largest", fit.fitted.largest},
          {"held_out_points", static_cast<std::int64_t>(fit.held_out.residuals.size())},
          {"held_out_rms", fit.held_out.rms},
          {"held_out_largest", fit.held_out.largest},
          {"information_criterion", fit.information_criterion},
          {"within_1_percent", describe(fit.within_1)},
          {"within_5_percent", describe(fit.within_5)},
          {"within_20_percent", describe(fit.within_20)}};
}

void append_residuals(dem::Table& table, const FitStudy& study, const DampingFit& fit,
                      const std::vector<DampingDatum>& points, bool held_out) {
  const FitError& error = held_out ? fit.held_out : fit.fitted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int r_f = points[i].aspect_ratio;
    table.append({{"law", std::string(name(fit.model.law))},
                  {"weighting", std::string(name(fit.model.kind))},
                  {"aspect_ratio", std::int64_t{r_f}},
                  {"held_out", std::int64_t{held_out}},
                  {"damping_slope", points[i].slope},
                  {"damping_slope_fit", damping_law(fit.model.law, fit.parameters, r_f)},
                  {"fit_residual", error.residuals[i]},
                  {"damping_slope_modes",
                   linear_chain_slope(r_f, {study.asked.poisson_ratio, study.asked.bond_damping})}});
  }
}

dem::NamedRow row_of(const ChoiceOutcome& outcome) {
  const FitChoice& choice = outcome.choice;
  const bool by_force = choice.load.kind == ChoiceLoad::Kind::force;
  return {{"aspect_ratios", describe(choice.aspect_ratios)},
          {"load", by_force ? dem::Cell{} : dem::Cell{choice.load.value}},
          {"force", by_force ? dem::Cell{choice.load.value} : dem::Cell{}},
          {"peaks_first", std::int64_t{choice.peaks.first}},
          {"peaks_last", std::int64_t{choice.peaks.last}},
          {"weighting", std::string(name(choice.weighting))},
          {"fit_a", outcome.fit.parameters[0]},
          {"fit_a_half_width", outcome.fit.half_widths[0]},
          {"fit_b", outcome.fit.parameters[1]},
          {"fit_b_half_width", outcome.fit.half_widths[1]},
          {"departure_a", outcome.departure_a},
          {"departure_b", outcome.departure_b},
          {"departure_curve", outcome.departure_curve},
          {"damping_slope_8", outcome.slope_8},
          {"damping_slope_10", outcome.slope_10}};
}

}  // namespace

dem::Table fit_table(const FitStudy& study) {
  return tabulate(study.fits, [](const DampingFit& fit) { return row_of(fit); });
}

dem::Table fit_residual_table(const FitStudy& study) {
  dem::Table table({"law", "weighting", "aspect_ratio", "held_out", "damping_slope", "damping_slope_fit",
                    "fit_residual", "damping_slope_modes"});
  for (const DampingFit& fit : study.fits) {
    append_residuals(table, study, fit, study.points, false);
    append_residuals(table, study, fit, study.held_out, true);
  }
  return table;
}

dem::Table fit_choice_table(const FitStudy& study) {
  return tabulate(study.choices, [](const ChoiceOutcome& outcome) { return row_of(outcome); });
}

}  // namespace fiberchain::compare
