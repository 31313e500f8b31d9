#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/fit/table.hpp"

namespace fiberchain::app {
namespace {

/// The columns worth a look on a terminal; the files have them all.
const std::vector<std::string> fit_shown = {"law",
                                            "weighting",
                                            "fit_a",
                                            "fit_b",
                                            "fit_c",
                                            "fit_rms",
                                            "fit_largest",
                                            "held_out_largest",
                                            "information_criterion",
                                            "within_1_percent",
                                            "within_5_percent"};

compare::FitSweep fit_sweep(const Arguments& arguments) {
  compare::FitSweep sweep;
  read_list(arguments, "--aspect-ratio", {.low = 2, .high = 100}, sweep.aspect_ratio);
  if (arguments.text("--held-out") == "none") {
    sweep.held_out.clear();
  } else {
    read_list(arguments, "--held-out", {.low = 2, .high = 100}, sweep.held_out);
  }
  read_number(arguments, "--poisson-ratio", kPoissonRatios, sweep.poisson_ratio);
  read_number(arguments, "--bond-damping", {.low = 0, .high = 1e3, .low_open = true}, sweep.bond_damping);
  read_number(arguments, "--load", {.low = 0, .high = 10, .low_open = true}, sweep.load);
  if (arguments.has("--peaks")) sweep.peaks = peak_range(arguments, {});
  return sweep;
}

int run_fit(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::FitSweep sweep = fit_sweep(arguments);
  const auto directory = open_output(output, context);
  const compare::FitStudy study = compare::fit_study(sweep, output.jobs);
  Results results{.name = "fit",
                  .heading = "Laws fitted to the damping of the fiber against its aspect ratio",
                  .table = compare::fit_table(study),
                  .notes = compare::fit_notes(study),
                  .more_tables = {{"fit-residuals", compare::fit_residual_table(study)},
                                  {"fit-choices", compare::fit_choice_table(study)}}};
  if (directory) results.figures = compare::fit_figures(study);
  deliver(results, results.table.select(fit_shown), output, directory, context);
  return kSuccess;
}

}  // namespace

Command fit_command() {
  return {
      .name = "fit",
      .description = "fit laws of the damping against aspect ratio, and look for the paper's choices (Eq 20)",
      .footer =
          std::string("Example:\n  fiberchain fit --aspect-ratio 5..30 --held-out 40,60 --poisson-ratio 0.3 "
                      "--out results\n") +
          kListHelp,
      .options = with_output(
          {{"--aspect-ratio", "LIST", "r_f of the fibers fitted [5..30]"},
           {"--held-out", "LIST", "r_f of fibers measured and never fitted, or none [40,60]"},
           {"--poisson-ratio", "NUMBER", "Poisson's ratio [0.3]"},
           {"--bond-damping", "NUMBER", "xi_b [1]"},
           {"--load", "NUMBER", "load before the release, P L^2/(E I); up to 0.01 without --peaks [0.01]"},
           {"--peaks", "LIST",
            "release from rest under the load and fit these peaks, 0 the point of release [release from the "
            "first mode]"}}),
      .run = &run_fit};
}

}  // namespace fiberchain::app
