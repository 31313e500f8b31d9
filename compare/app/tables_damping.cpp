#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/damping/table.hpp"

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

SweepOptions<compare::DampingSweep> tables_damping_options() {
  using Sweep = compare::DampingSweep;
  using dem::DashpotLaw;
  return {
      list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 2, .high = 1e4},
              "r_f = L/d, number of bonds [10]"),
      list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios, "Poisson's ratio [0.3]"),
      list_of("--bond-damping", &Sweep::bond_damping, {.low = 0, .high = 1e6, .low_open = true},
              "xi_b; with --dashpots retardation_time the time over t_b [1]"),
      list_of("--load", &Sweep::load, {.low = 0, .high = 10, .low_open = true},
              "load before the release, P L^2/(E I) [0.05]"),
      words_of("--dashpots", &Sweep::dashpots,
               {{"bond_damping", DashpotLaw::bond_damping},
                {"retardation_time", DashpotLaw::retardation_time},
                {"bending_only", DashpotLaw::bending_only}},
               "what sets the dashpots: bond_damping, retardation_time, bending_only [bond_damping]"),
      words_of("--bond", &Sweep::bond, kBondModels, "bond law: paper, corrected [paper]"),
      words_of("--form", &Sweep::form, kBondForms, "form of the bond law: total, incremental [incremental]"),
      peaks_of(&Sweep::peaks, "peaks of fiber_damping_paper; 0 is the point of release [1..10]")};
}

int run_tables_damping(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const auto options = tables_damping_options();
  const compare::DampingSweep sweep = read_sweep(options, arguments);
  const auto directory = open_output(output, context);
  CasePoints<compare::DampingPoint> all;
  Results results{.name = "damping", .heading = "Damping of the fiber by dashpots in its bonds"};
  if (chose_cases(options, arguments)) {
    all = measured(compare::damping_points, compare::cases(sweep), output, context);
  } else {
    const compare::DampingFigureCases wanted = compare::damping_figure_cases(sweep.peaks);
    const auto groups = measured_groups(
        compare::damping_points, {wanted.bond_damping, wanted.load, wanted.modulus, wanted.aspect_ratio},
        output, context, all);
    if (context.stopped == 0 && output.makes_fixed_tables()) {
      const dem::Table ring_down = compare::ring_down_table({.load = 1.0}, 12);
      results.more_tables = {{"fig-6", ring_down}, {"damping-dashpots", compare::dashpot_table(10, 0.3)}};
      if (!output.shard)
        results.figures = compare::damping_figures(
            {groups[0].points, groups[1].points, groups[2].points, groups[3].points}, ring_down);
    }
  }
  results.table = table_by_case(all.points, all.numbers, output, compare::damping_table);
  deliver(results, results.table.select(tables_damping_shown), output, directory, context);
  // a row may have one of its dampings alone: its status says why
  return status_of(all.points, context, [](const compare::DampingPoint& point) {
    return !std::isnan(point.damping) || !std::isnan(point.damping_paper);
  });
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
      .options = with_shards(tables_damping_options()),
      .run = &run_tables_damping};
}

}  // namespace fiberchain::app
