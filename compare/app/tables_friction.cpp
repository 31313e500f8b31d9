#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/friction/table.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> tables_friction_shown = {"aspect_ratio",
                                                        "load",
                                                        "amplitude",
                                                        "rolling_friction",
                                                        "rolling",
                                                        "step_ratio",
                                                        "fiber_damping_paper",
                                                        "fiber_damping_modes",
                                                        "fiber_damping_weak",
                                                        "fiber_damping_as_bond",
                                                        "status"};

using compare::RollingPoints;

compare::RollingSweep tables_friction_sweep(const Arguments& arguments) {
  using dem::Rolling;
  compare::RollingSweep sweep;
  read_list(arguments, "--aspect-ratio", {.low = 2, .high = 1e4}, sweep.aspect_ratio);
  read_list(arguments, "--poisson-ratio", kPoissonRatios, sweep.poisson_ratio);
  read_list(arguments, "--load", {.low = 0, .high = 10, .low_open = true}, sweep.load);
  read_list(arguments, "--amplitude", {.low = 0, .high = 0.5, .low_open = true}, sweep.amplitude);
  read_list(arguments, "--bond-damping", {.low = 0, .high = 1e6, .low_open = true}, sweep.bond_damping);
  read_list(arguments, "--rolling-friction", {.low = 0, .high = 1e6}, sweep.rolling_friction);
  read_list(arguments, "--step", {.low = 0, .high = 1, .low_open = true}, sweep.step_ratio);
  read_choices<Rolling>(arguments, "--law", sweep.law,
                        {{"set_valued", Rolling::set_valued}, {"explicit_sign", Rolling::explicit_sign}});
  if (arguments.has("--load") && arguments.has("--amplitude")) {
    throw compare::InputError(
        "--amplitude is not allowed with --load: give what the fiber is let go with once");
  }
  sweep.peaks = peak_range(arguments, sweep.peaks);
  return sweep;
}

/// Whether any case was asked for; without, the figures' own are run.
bool chose_tables_friction_cases(const Arguments& arguments) {
  const auto options = {"--aspect-ratio", "--poisson-ratio",    "--load", "--amplitude",
                        "--bond-damping", "--rolling-friction", "--law",  "--step"};
  return std::ranges::any_of(options, [&](const char* option) { return arguments.has(option); });
}

/// All figures' cases measured together, then handed back figure by figure.
compare::RollingFigurePoints measure_figures(const compare::PeakRange& peaks, int jobs,
                                             const Context& context, RollingPoints& all) {
  const compare::RollingFigureCases wanted = compare::rolling_figure_cases(peaks);
  all = measured(compare::rolling_points,
                 joined<compare::RollingCase>({wanted.friction, wanted.step, wanted.amplitude, wanted.decay}),
                 jobs, context);
  Portions portions(all);
  compare::RollingFigurePoints figures;
  figures.friction = portions.next(wanted.friction.size());
  figures.step = portions.next(wanted.step.size());
  figures.amplitude = portions.next(wanted.amplitude.size());
  figures.decay = portions.next(wanted.decay.size());
  return figures;
}

int run_tables_friction(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::RollingSweep sweep = tables_friction_sweep(arguments);
  const auto directory = open_output(output, context);
  RollingPoints points;
  Results results{.name = "friction",
                  .heading = "Rolling friction of the bonds and the fiber's damping",
                  .table = compare::rolling_table({})};
  if (chose_tables_friction_cases(arguments)) {
    points = measured(compare::rolling_points, compare::cases(sweep), output.jobs, context);
    results.more_tables = {{"friction-peaks", compare::rolling_peaks_table(points)}};
  } else {
    const compare::RollingFigurePoints figures = measure_figures(sweep.peaks, output.jobs, context, points);
    results.more_tables = {{"friction-peaks", compare::rolling_peaks_table(figures.decay)}};
    if (context.stopped == 0) results.figures = compare::rolling_figures(figures);
  }
  results.table = compare::rolling_table(points);
  deliver(results, results.table.select(tables_friction_shown), output, directory, context);
  return status_of(points, context);
}

}  // namespace

Command tables_friction_command() {
  return {
      .name = "tables friction",
      .description =
          "damping of the fiber by rolling friction of its bonds, by step, load and amplitude (Fig 10)",
      .footer = std::string("Without a choice of cases those of the figures are run.\n"
                            "Example:\n  fiberchain tables friction --aspect-ratio 13 --poisson-ratio 0.17 "
                            "--load 0.7 --rolling-friction 0,3 --law set_valued,explicit_sign --json\n") +
                kListHelp,
      .options = with_output(
          {{"--aspect-ratio", "LIST", "r_f = L/d, number of bonds [30]"},
           {"--poisson-ratio", "LIST", "Poisson's ratio [0.3]"},
           {"--load", "LIST", "load before the release, P L^2/(E I) [3]"},
           {"--amplitude", "LIST", "in place of a load: let go from the first mode, tip deflection over L"},
           {"--bond-damping", "LIST", "xi_b [1]"},
           {"--rolling-friction", "LIST", "xi_r [0,1,2,4,10]"},
           {"--law", "LIST", "law of rolling friction: set_valued, explicit_sign [set_valued]"},
           {"--step", "LIST", "time step over t_b [0.8 of the stable one]"},
           {"--peaks", "LIST", "peaks the damping is measured on; 0 is the point of release [1..5]"}}),
      .run = &run_tables_friction};
}

}  // namespace fiberchain::app
