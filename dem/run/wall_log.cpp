#include "dem/run/wall_log.hpp"

#include <string>

namespace fiberchain::dem {
Table wall_log_table() {
  return Table({"step", "simulated_time", "wall", "wall_name", "wall_shape", "wall_force_x", "wall_force_y",
                "wall_force_z", "wall_moment_x", "wall_moment_y", "wall_moment_z", "wall_force_peak",
                "wall_moment_peak", "wall_work", "wall_center_x", "wall_center_y", "wall_center_z"});
}

Table wall_log_rows(const Assembly& assembly) {
  Table table = wall_log_table();
  const std::vector<WallSample> samples = assembly.wall_samples();
  for (std::size_t w = 0; w < samples.size(); ++w) {
    const WallSample& sample = samples[w];
    const Vec<double, 3>&force = sample.mean.force, &moment = sample.mean.moment, &center = sample.center;
    const NamedRow row = {{"step", assembly.steps()},
                          {"simulated_time", assembly.time()},
                          {"wall", static_cast<std::int64_t>(w) + 1},
                          {"wall_name", assembly.walls()[w].name},
                          {"wall_shape", std::string(assembly.walls()[w].shape.type().name)},
                          {"wall_force_x", force[0]},
                          {"wall_force_y", force[1]},
                          {"wall_force_z", force[2]},
                          {"wall_moment_x", moment[0]},
                          {"wall_moment_y", moment[1]},
                          {"wall_moment_z", moment[2]},
                          {"wall_force_peak", sample.force_peak},
                          {"wall_moment_peak", sample.moment_peak},
                          {"wall_work", sample.work},
                          {"wall_center_x", center[0]},
                          {"wall_center_y", center[1]},
                          {"wall_center_z", center[2]}};
    table.append(row);
  }
  return table;
}

}  // namespace fiberchain::dem
