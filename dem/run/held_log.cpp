#include "dem/run/held_log.hpp"

#include <string>

namespace fiberchain::dem {

Table held_log_table() {
  return Table({"step", "simulated_time", "held", "held_name", "held_kind", "held_spheres", "held_force_x",
                "held_force_y", "held_force_z", "held_moment_x", "held_moment_y", "held_moment_z",
                "held_force_peak", "held_moment_peak", "held_work", "held_center_x", "held_center_y",
                "held_center_z"});
}

Table held_log_rows(const Assembly& assembly) {
  Table table = held_log_table();
  const std::vector<WallSample> samples = assembly.held_samples();
  for (std::size_t g = 0; g < samples.size(); ++g) {
    const WallSample& sample = samples[g];
    const Grip& grip = assembly.grips()[g];
    const Vec<double, 3>&force = sample.mean.force, &moment = sample.mean.moment, &center = sample.center;
    const NamedRow row = {{"step", assembly.steps()},
                          {"simulated_time", assembly.time()},
                          {"held", static_cast<std::int64_t>(g) + 1},
                          {"held_name", grip.body.name},
                          {"held_kind", std::string(grip.holds() ? "held" : "load")},
                          {"held_spheres", std::ssize(grip.spheres)},
                          {"held_force_x", force[0]},
                          {"held_force_y", force[1]},
                          {"held_force_z", force[2]},
                          {"held_moment_x", moment[0]},
                          {"held_moment_y", moment[1]},
                          {"held_moment_z", moment[2]},
                          {"held_force_peak", sample.force_peak},
                          {"held_moment_peak", sample.moment_peak},
                          {"held_work", sample.work},
                          {"held_center_x", center[0]},
                          {"held_center_y", center[1]},
                          {"held_center_z", center[2]}};
    table.append(row);
  }
  return table;
}

}  // namespace fiberchain::dem
