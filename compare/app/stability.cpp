#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
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

compare::StabilitySweep stability_sweep(const Arguments& arguments) {
  using dem::BondModel;
  using dem::Integrator;
  using reference::ChainEnds;
  compare::StabilitySweep sweep;
  read_list(arguments, "--aspect-ratio", {.low = 1, .high = 1e4}, sweep.aspect_ratio);
  read_list(arguments, "--poisson-ratio", kPoissonRatios, sweep.poisson_ratio);
  read_list(arguments, "--bond-damping", {.low = 0, .high = 1e6}, sweep.bond_damping);
  read_choices<BondModel>(arguments, "--bond", sweep.bond,
                          {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  read_choices<Integrator>(
      arguments, "--scheme", sweep.scheme,
      {{"leapfrog", Integrator::leapfrog}, {"leapfrog-damped", Integrator::leapfrog_damped}});
  read_choices<ChainEnds>(arguments, "--ends", sweep.ends,
                          {{"clamped_free", ChainEnds::clamped_free}, {"free_free", ChainEnds::free_free}});
  read_choices<int>(arguments, "--dimension", sweep.dimension, {{"planar", 2}, {"spatial", 3}});
  return sweep;
}

/// Whether any case was asked for; without, the map's and the figures' own are run.
bool chose_stability_cases(const Arguments& arguments) {
  const auto options = {"--aspect-ratio", "--poisson-ratio", "--bond-damping", "--bond",
                        "--scheme",       "--ends",          "--dimension"};
  return std::ranges::any_of(options, [&](const char* option) { return arguments.has(option); });
}

int run_stability(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::StabilitySweep sweep = stability_sweep(arguments);
  const auto directory = open_output(output, context);
  const auto cases =
      chose_stability_cases(arguments) ? compare::cases(sweep) : compare::stability_figure_cases();
  const auto points = measured(compare::stability_points, cases, output.jobs, context);
  Results results{.name = "stability",
                  .heading = "Largest stable time step of a chain",
                  .table = compare::stability_table(points),
                  .notes = compare::stability_notes(points)};
  if (directory && context.stopped == 0) results.figures = compare::stability_figures(points);
  deliver(results, results.table.select(stability_shown), output, directory, context);
  return context.stopped != 0 ? kSignaled + context.stopped : kSuccess;
}

}  // namespace

Command stability_command() {
  return {
      .name = "stability",
      .description = "largest stable time step of a chain: theory, runs, the paper's rules",
      .footer = std::string("Without a choice of cases the map over Poisson's ratio and damping is made.\n"
                            "Example:\n  fiberchain stability --aspect-ratio 13 --poisson-ratio 0.17,0.3 "
                            "--bond-damping 0,0.7 --bond paper\n") +
                kListHelp,
      .options = with_output(
          {{"--aspect-ratio", "LIST", "r_f = L/d, number of bonds [10]"},
           {"--poisson-ratio", "LIST", "Poisson's ratio [-0.2 to 0.49]"},
           {"--bond-damping", "LIST", "xi_b [0 to 10]"},
           {"--bond", "LIST", "bond law: paper, corrected [both]"},
           {"--scheme", "LIST",
            "leapfrog (lagged dashpots), leapfrog-damped (dashpots solved within the step) [both]"},
           {"--ends", "LIST", "clamped_free, free_free [clamped_free]"},
           {"--dimension", "LIST", "planar, spatial [planar]"}}),
      .run = &run_stability};
}

}  // namespace fiberchain::app
