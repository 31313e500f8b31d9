#include "dem/run/held_log.hpp"

#include <string>

#include "dem/run/force_rows.hpp"

namespace fiberchain::dem {
namespace {

const ForceColumns held_columns{.number = "held",
                                .name = "held_name",
                                .own = {"held_kind", "held_spheres"},
                                .force = {"held_force_x", "held_force_y", "held_force_z"},
                                .moment = {"held_moment_x", "held_moment_y", "held_moment_z"},
                                .force_peak = "held_force_peak",
                                .moment_peak = "held_moment_peak",
                                .work = "held_work",
                                .center = {"held_center_x", "held_center_y", "held_center_z"}};

}  // namespace

Table held_log_table() { return force_table(held_columns); }

Table held_log_rows(const Assembly& assembly) {
  Table table = held_log_table();
  const std::vector<WallSample> samples = assembly.held_samples();
  for (std::size_t g = 0; g < samples.size(); ++g) {
    const Grip& grip = assembly.grips()[g];
    append_force_row(table, held_columns, assembly, g + 1, grip.body.name,
                     {std::string(grip.holds() ? "held" : "load"), std::ssize(grip.spheres)}, samples[g]);
  }
  return table;
}

}  // namespace fiberchain::dem
