#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/damping/table.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> tables_damping_shown = {"aspect_ratio",
                                                       "bond_damping",
                                                       "load",
                                                       "fiber_damping",
                                                       "fiber_damping_paper",
                                                       "fiber_damping_modes",
                                                       "fiber_damping_elastica",
                                                       "fiber_damping_closed_form",
                                                       "fiber_damping_eq20",
                                                       "status"};

using compare::DampingPoints;

compare::DampingSweep tables_damping_sweep(const Arguments& arguments) {
  using dem::BondForm;
  using dem::BondModel;
  using dem::DashpotLaw;
  compare::DampingSweep sweep;
  read_list(arguments, "--aspect-ratio", {.low = 2, .high = 1e4}, sweep.aspect_ratio);
  read_list(arguments, "--poisson-ratio", kPoissonRatios, sweep.poisson_ratio);
  read_list(arguments, "--bond-damping", {.low = 0, .high = 1e6, .low_open = true}, sweep.bond_damping);
  read_list(arguments, "--load", {.low = 0, .high = 10, .low_open = true}, sweep.load);
  read_choices<BondModel>(arguments, "--bond", sweep.bond,
                          {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  read_choices<BondForm>(arguments, "--form", sweep.form,
                         {{"total", BondForm::total}, {"incremental", BondForm::incremental}});
  read_choices<DashpotLaw>(arguments, "--dashpots", sweep.dashpots,
                           {{"bond_damping", DashpotLaw::bond_damping},
                            {"retardation_time", DashpotLaw::retardation_time},
                            {"bending_only", DashpotLaw::bending_only}});
  sweep.peaks = peak_range(arguments, sweep.peaks);
  return sweep;
}

/// Whether any case was asked for; without, the figures' own are run.
bool chose_tables_damping_cases(const Arguments& arguments) {
  const auto options = {"--aspect-ratio", "--poisson-ratio", "--bond-damping", "--load",
                        "--dashpots",     "--bond",          "--form"};
  return std::ranges::any_of(options, [&](const char* option) { return arguments.has(option); });
}

/// All figures' cases measured together, then handed back figure by figure.
compare::DampingFigurePoints measure_figures(const compare::PeakRange& peaks, int jobs,
                                             const Context& context, DampingPoints& all) {
  const compare::DampingFigureCases wanted = compare::damping_figure_cases(peaks);
  all = measured(
      compare::damping_points,
      joined<compare::DampingCase>({wanted.bond_damping, wanted.load, wanted.modulus, wanted.aspect_ratio}),
      jobs, context);
  Portions portions(all);
  compare::DampingFigurePoints figures;
  figures.bond_damping = portions.next(wanted.bond_damping.size());
  figures.load = portions.next(wanted.load.size());
  figures.modulus = portions.next(wanted.modulus.size());
  figures.aspect_ratio = portions.next(wanted.aspect_ratio.size());
  return figures;
}

int run_tables_damping(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::DampingSweep sweep = tables_damping_sweep(arguments);
  const auto directory = open_output(output);
  DampingPoints points;
  Results results{.name = "damping",
                  .heading = "Damping of the fiber by dashpots in its bonds",
                  .table = compare::damping_table({})};
  if (chose_tables_damping_cases(arguments)) {
    points = measured(compare::damping_points, compare::cases(sweep), output.jobs, context);
  } else {
    const compare::DampingFigurePoints figures = measure_figures(sweep.peaks, output.jobs, context, points);
    const dem::Table ring_down = compare::ring_down_table({.load = 1.0}, 12);
    results.more_tables = {{"fig-6", ring_down}, {"damping-dashpots", compare::dashpot_table(10, 0.3)}};
    results.figures = compare::damping_figures(figures, ring_down);
  }
  results.table = compare::damping_table(points);
  deliver(results, results.table.select(tables_damping_shown), output, directory, context);
  // a row may have one of its dampings alone: its status says why
  for (compare::DampingPoint& point : points) {
    if (std::isnan(point.damping)) point.damping = point.damping_paper;
  }
  return status_of(points, context);
}

}  // namespace

Command tables_damping_command() {
  return {
      .name = "tables damping",
      .description = "damping of the fiber by that of the bonds and what it is made of (Figs 6 to 9)",
      .footer = std::string("Without a choice of cases those of the figures are run.\n"
                            "Example:\n  fiberchain tables damping --aspect-ratio 13 --poisson-ratio 0.17 "
                            "--bond-damping 0.7 --load 0.05 --json\n") +
                kListHelp,
      .options = with_output(
          {{"--aspect-ratio", "LIST", "r_f = L/d, number of bonds [10]"},
           {"--poisson-ratio", "LIST", "Poisson's ratio [0.3]"},
           {"--bond-damping", "LIST", "xi_b; with --dashpots retardation_time the time over t_b [1]"},
           {"--load", "LIST", "load before the release, P L^2/(E I) [0.05]"},
           {"--dashpots", "LIST",
            "what sets the dashpots: bond_damping, retardation_time, bending_only [bond_damping]"},
           {"--bond", "LIST", "bond law: paper, corrected [paper]"},
           {"--form", "LIST", "form of the bond law: total, incremental [incremental]"},
           {"--peaks", "LIST", "peaks of fiber_damping_paper; 0 is the point of release [1..10]"}}),
      .run = &run_tables_damping};
}

}  // namespace fiberchain::app
