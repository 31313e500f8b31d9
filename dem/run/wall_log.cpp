#include "dem/run/wall_log.hpp"

#include <string>

#include "dem/run/force_rows.hpp"

namespace fiberchain::dem {
namespace {

const ForceColumns wall_columns{.number = "wall",
                                .name = "wall_name",
                                .own = {"wall_shape"},
                                .force = {"wall_force_x", "wall_force_y", "wall_force_z"},
                                .moment = {"wall_moment_x", "wall_moment_y", "wall_moment_z"},
                                .force_peak = "wall_force_peak",
                                .moment_peak = "wall_moment_peak",
                                .work = "wall_work",
                                .center = {"wall_center_x", "wall_center_y", "wall_center_z"}};

}  // namespace

Table wall_log_table() { return force_table(wall_columns); }

Table wall_log_rows(const Assembly& assembly) {
  Table table = wall_log_table();
  const std::vector<WallSample> samples = assembly.wall_samples();
  for (std::size_t w = 0; w < samples.size(); ++w) {
    const Wall& wall = assembly.walls()[w];
    append_force_row(table, wall_columns, assembly, w + 1, wall.name, {std::string(wall.shape.type().name)},
                     samples[w]);
  }
  return table;
}

}  // namespace fiberchain::dem
