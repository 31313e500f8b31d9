#include "dem/trajectory/atom_files.hpp"

#include <fmt/format.h>

#include <iterator>

namespace fiberchain::dem {

std::string lammps_frame(const TrajectoryFrame& all) {
  const TrajectoryFrame frame = present_part(all);
  std::string text =
      fmt::format("ITEM: UNITS\nsi\nITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n",
                  frame.time, frame.step, frame.position.size());
  text += "ITEM: BOX BOUNDS";
  for (const bool periodic : frame.periodic) text += periodic ? " pp" : " ff";
  for (int c = 0; c < 3; ++c) text += fmt::format("\n{} {}", frame.low[c], frame.high[c]);
  text += "\nITEM: ATOMS id mol type radius x y z vx vy vz\n";
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const auto &x = frame.position[i], &v = frame.velocity[i];
    fmt::format_to(std::back_inserter(text), "{} {} 1 {:.9g} {:.12g} {:.12g} {:.12g} {:.7g} {:.7g} {:.7g}\n",
                   i + 1, frame.fiber[i] + 1, frame.radius[i], x[0], x[1], x[2], v[0], v[1], v[2]);
  }
  return text;
}

std::string extended_xyz_frame(const TrajectoryFrame& all) {
  const TrajectoryFrame frame = present_part(all);
  const auto size = frame.high - frame.low;
  const auto flag = [&](int c) { return frame.periodic[c] ? 'T' : 'F'; };
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" Time={} Timestep={} "
      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:molecule:I:1:id:I:1\n",
      frame.position.size(), size[0], size[1], size[2], frame.low[0], frame.low[1], frame.low[2], flag(0),
      flag(1), flag(2), frame.time, frame.step);
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const auto &x = frame.position[i], &v = frame.velocity[i];
    fmt::format_to(std::back_inserter(text), "S {:.12g} {:.12g} {:.12g} {:.7g} {:.7g} {:.7g} {:.9g} {} {}\n",
                   x[0], x[1], x[2], v[0], v[1], v[2], frame.radius[i], frame.fiber[i] + 1, i + 1);
  }
  return text;
}

}  // namespace fiberchain::dem
