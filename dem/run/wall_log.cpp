#include "dem/run/wall_log.hpp"

#include <string>

namespace fiberchain::dem {
namespace {

const char* const kAlong[] = {"x", "y", "z"};

void put_vector(NamedRow& row, const std::string& name, const Vec<double, 3>& v) {
  for (int c = 0; c < 3; ++c) row.emplace_back(name + "_" + kAlong[c], v[c]);
}

}  // namespace

Table wall_log_table() {
  return Table({"step", "simulated_time", "wall", "wall_shape", "wall_force_x", "wall_force_y", "wall_force_z",
                "wall_moment_x", "wall_moment_y", "wall_moment_z", "wall_force_peak", "wall_moment_peak",
                "wall_work", "wall_center_x", "wall_center_y", "wall_center_z"});
}

Table wall_log_rows(const Assembly& assembly) {
  Table table = wall_log_table();
  const std::vector<WallSample> samples = assembly.wall_samples();
  for (std::size_t w = 0; w < samples.size(); ++w) {
    const WallSample& sample = samples[w];
    NamedRow row = {{"step", assembly.steps()},
                    {"simulated_time", assembly.time()},
                    {"wall", static_cast<std::int64_t>(w) + 1},
                    {"wall_shape", std::string(assembly.walls()[w].shape.type().name)},
                    {"wall_force_peak", sample.force_peak},
                    {"wall_moment_peak", sample.moment_peak},
                    {"wall_work", sample.work}};
    put_vector(row, "wall_force", sample.mean.force);
    put_vector(row, "wall_moment", sample.mean.moment);
    put_vector(row, "wall_center", sample.center);
    table.append(row);
  }
  return table;
}

}  // namespace fiberchain::dem
