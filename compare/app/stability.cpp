#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/stability/table.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> stability_shown = {"aspect_ratio",
                                                  "poisson_ratio",
                                                  "bond_damping",
                                                  "bond",
                                                  "scheme",
                                                  "stable_step_endless",
                                                  "stable_step_modes",
                                                  "stable_step_measured",
                                                  "stable_step_difference",
                                                  "bond_time_verdict",
                                                  "quarter_verdict"};

const std::vector<std::string> growth_shown = {
    "aspect_ratio", "poisson_ratio", "bond_damping",    "bond",          "form",  "dimension",
    "step_ratio",   "growth_modes",  "growth_measured", "growth_margin", "swell", "growth_verdict"};

SweepOptions<compare::StabilitySweep> stability_options() {
  using Sweep = compare::StabilitySweep;
  using dem::Integrator;
  using reference::ChainEnds;
  return {list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 1, .high = 1e4},
                  "r_f = L/d, number of bonds [10]"),
          list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios, "Poisson's ratio [-0.2 to 0.49]"),
          list_of("--bond-damping", &Sweep::bond_damping, {.low = 0, .high = 1e6}, "xi_b [0 to 10]"),
          words_of("--bond", &Sweep::bond, kBondModels, "bond law: paper, corrected [both]"),
          words_of("--scheme", &Sweep::scheme,
                   {{"leapfrog", Integrator::leapfrog},
                    {"leapfrog-damped", Integrator::leapfrog_damped},
                    {"leapfrog-stiff", Integrator::leapfrog_stiff}},
                   "leapfrog (lagged dashpots), leapfrog-damped (dashpots solved within the step), "
                   "leapfrog-stiff (springs, too) [all]"),
          words_of("--ends", &Sweep::ends,
                   {{"clamped_free", ChainEnds::clamped_free}, {"free_free", ChainEnds::free_free}},
                   "clamped_free, free_free [clamped_free]"),
          words_of("--dimension", &Sweep::dimension, kDimensions, "planar, spatial [planar]"),
          words_of("--form", &Sweep::form, kBondForms, "total, incremental [incremental]"),
          list_of("--step", &Sweep::step_ratio, {.low = 1e-3, .high = 1e6},
                  "time steps over t_b of leapfrog-stiff, which has no stable one [10, 100, 1000]")};
}

/// Schemes with a stable step and those without: each a table where it has cases, the second beside the
/// first.
Results results_of(const CasePoints<compare::StabilityPoint>& limited,
                   const CasePoints<compare::GrowthPoint>& unlimited, const OutputOptions& output) {
  const auto& points = limited.points;
  const auto& growth = unlimited.points;
  Results results{
      .name = points.empty() ? "stability-growth" : "stability",
      .heading = points.empty() ? "Growth at large time steps" : "Largest stable time step of a chain",
      .notes = compare::stability_notes(points) + compare::growth_notes(growth)};
  if (!points.empty())
    results.table = table_by_case(points, limited.numbers, output, compare::stability_table);
  if (growth.empty()) return results;
  dem::Table growth_rows = table_by_case(growth, unlimited.numbers, output, compare::growth_table);
  if (points.empty())
    results.table = std::move(growth_rows);
  else
    results.more_tables.emplace_back("stability-growth", std::move(growth_rows));
  return results;
}

int run_stability(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const auto options = stability_options();
  const compare::StabilitySweep sweep = read_sweep(options, arguments);
  const auto directory = open_output(output, context);
  const bool chose = chose_cases(options, arguments);
  const auto limited = chose ? compare::cases(sweep) : compare::stability_figure_cases();
  const auto unlimited = chose ? compare::growth_cases(sweep) : compare::growth_figure_cases();
  // both are dealt together: cases without a stable step are numbered behind those with one
  const auto numbers = deal(limited.size() + unlimited.size(), output, context);
  const auto middle = std::ranges::lower_bound(numbers, limited.size());
  const auto points =
      measured(compare::stability_points, limited, {numbers.begin(), middle}, output.jobs, context);
  CasePoints<compare::GrowthPoint> growth;
  if (context.stopped == 0) {
    std::vector<std::size_t> behind(middle, numbers.end());
    for (std::size_t& n : behind) n -= limited.size();
    growth = measured(compare::growth_points, unlimited, behind, output.jobs, context);
    for (std::size_t& n : growth.numbers) n += limited.size();
  }
  Results results = results_of(points, growth, output);
  if (directory && context.stopped == 0 && !output.shard)
    results.figures = compare::stability_figures(points.points);
  deliver(results, results.table.select(points.points.empty() ? growth_shown : stability_shown), output,
          directory, context);
  return context.stopped != 0 ? kSignaled + context.stopped : kSuccess;
}

}  // namespace

Command stability_command() {
  return {
      .name = "stability",
      .description = "largest stable time step of a chain, growth beyond: theory, runs, the paper's rules",
      .footer = std::string("Without a choice of cases the map over Poisson's ratio and damping is made.\n"
                            "Example:\n  fiberchain stability --aspect-ratio 13 --poisson-ratio 0.17,0.3 "
                            "--bond-damping 0,0.7 --bond paper\n") +
                kListHelp,
      .options = with_shards(stability_options()),
      .run = &run_stability};
}

}  // namespace fiberchain::app
