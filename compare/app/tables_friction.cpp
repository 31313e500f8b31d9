#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
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

SweepOptions<compare::RollingSweep> tables_friction_options() {
  using Sweep = compare::RollingSweep;
  using dem::Rolling;
  return {
      list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 2, .high = 1e4},
              "r_f = L/d, number of bonds [30]"),
      list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios, "Poisson's ratio [0.3]"),
      list_of("--load", &Sweep::load, {.low = 0, .high = 10, .low_open = true},
              "load before the release, P L^2/(E I) [3]"),
      list_of("--amplitude", &Sweep::amplitude, {.low = 0, .high = 0.5, .low_open = true},
              "in place of a load: let go from the first mode, tip deflection over L"),
      list_of("--bond-damping", &Sweep::bond_damping, {.low = 0, .high = 1e6, .low_open = true}, "xi_b [1]"),
      list_of("--rolling-friction", &Sweep::rolling_friction, {.low = 0, .high = 1e6}, "xi_r [0,1,2,4,10]"),
      words_of("--law", &Sweep::law,
               {{"set_valued", Rolling::set_valued}, {"explicit_sign", Rolling::explicit_sign}},
               "law of rolling friction: set_valued, explicit_sign [set_valued]"),
      list_of("--step", &Sweep::step_ratio, {.low = 0, .high = 1, .low_open = true},
              "time step over t_b [0.8 of the stable one]"),
      peaks_of(&Sweep::peaks, "peaks the damping is measured on; 0 is the point of release [1..5]")};
}

int run_tables_friction(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const auto options = tables_friction_options();
  const compare::RollingSweep sweep = read_sweep(options, arguments);
  if (arguments.has("--load") && arguments.has("--amplitude")) {
    throw compare::InputError(
        "--amplitude is not allowed with --load: give what the fiber is let go with once");
  }
  const auto directory = open_output(output, context);
  CasePoints<compare::RollingPoint> all;
  Results results{.name = "friction", .heading = "Rolling friction of the bonds and the fiber's damping"};
  if (chose_cases(options, arguments)) {
    all = measured(compare::rolling_points, compare::cases(sweep), output, context);
    results.more_tables = {
        {"friction-peaks", table_by_case(all.points, all.numbers, output, compare::rolling_peaks_table)}};
  } else {
    const compare::RollingFigureCases wanted = compare::rolling_figure_cases(sweep.peaks);
    const auto groups =
        measured_groups(compare::rolling_points,
                        {wanted.friction, wanted.step, wanted.amplitude, wanted.decay}, output, context, all);
    if (!groups[3].points.empty())
      results.more_tables = {{"friction-peaks", table_by_case(groups[3].points, groups[3].numbers, output,
                                                              compare::rolling_peaks_table)}};
    if (context.stopped == 0 && !output.shard)
      results.figures =
          compare::rolling_figures({groups[0].points, groups[1].points, groups[2].points, groups[3].points});
  }
  results.table = table_by_case(all.points, all.numbers, output, compare::rolling_table);
  deliver(results, results.table.select(tables_friction_shown), output, directory, context);
  return status_of(all.points, context);
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
      .options = with_shards(tables_friction_options()),
      .run = &run_tables_friction};
}

}  // namespace fiberchain::app
