#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/capstan/capstan.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> tables_capstan_shown = {
    "drum_surface",        "drum_friction",     "turning",           "drum_bending",  "tension_ratio",
    "tension_ratio_euler", "tension_ratio_rod", "tension_error_rod", "tension_ripple"};

SweepOptions<compare::CapstanSweep> tables_capstan_options() {
  using Sweep = compare::CapstanSweep;
  using enum compare::DrumSurface;
  const Sweep usual;
  return {words_of<Sweep, compare::DrumSurface>(
              "--surface", &Sweep::surface,
              {{"smooth", smooth}, {"wall", wall}, {"ring", ring}, {"spheres", spheres}},
              "smooth fiber on a thick one, spheres on a cylinder (wall), smooth fiber on a ring of the same "
              "fiber "
              "(ring), spheres on a ring of spheres [all]"),
          list_of("--friction", &Sweep::friction, {.low = 0, .high = 1},
                  fmt::format("Coulomb's coefficient [{}]", fmt::join(usual.friction, ","))),
          list_of("--turning", &Sweep::turning, {.low = 0.2, .high = 8},
                  fmt::format("angle between the directions of both ends over pi; on rings 1 at most [{}]",
                              fmt::join(usual.turning, ","))),
          list_of("--drum", &Sweep::drum, {.low = 5, .high = 1000},
                  fmt::format("radius of the drum over that of the fiber [{}]", fmt::join(usual.drum, ","))),
          list_of("--bending", &Sweep::bending, {.low = 1e-3, .high = 2},
                  fmt::format("E I/(F_0 rho^2), F_0 the force that holds back, rho of the fiber's axis [{}]",
                              fmt::join(usual.bending, ","))),
          list_of("--spacing", &Sweep::spacing, {.low = 0.5, .high = 20},
                  fmt::format("length of the bonds of smooth fibers over the diameter [{}]",
                              fmt::join(usual.spacing, ",")))};
}

int run_tables_capstan(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::CapstanSweep sweep = read_sweep(tables_capstan_options(), arguments);
  const auto directory = open_output(output, context);
  const auto [points, numbers] =
      measured(compare::capstan_points, compare::capstan_cases(sweep), output, context);
  Results results{.name = "capstan",
                  .heading = "Fibers that slide about a drum",
                  .table = table_by_case(points, numbers, output, compare::capstan_table)};
  if (!output.shard) results.figures = {{"capstan", compare::capstan_figure(points)}};
  deliver(results, results.table.select(tables_capstan_shown), output, directory, context);
  return status_of(points, context, [](const auto& point) { return point.status == "converged"; });
}

}  // namespace

Command tables_capstan_command() {
  return {
      .name = "tables capstan",
      .description =
          "fibers drawn about a fixed drum: ratio of the tensions against exp(mu phi) and "
          "against a rod that bends and is thick",
      .footer = std::string("Example:\n  fiberchain tables capstan --surface smooth --turning 0.5 --friction "
                            "0.3\n") +
                kListHelp,
      .options = with_shards(tables_capstan_options()),
      .run = &run_tables_capstan};
}

}  // namespace fiberchain::app
