#include "dem/trajectory/h5md_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "dem/trajectory/h5md_layout.hpp"

namespace fiberchain::dem::h5md {
namespace {

using hdf5::Handle;

std::string wall_group(std::size_t n) { return fmt::format("{}/{}", kWalls, n + 1); }

}  // namespace

bool has_walls(hid_t file) { return hdf5::has(file, "parameters") && hdf5::has(file, kWalls); }

void write_wall_surfaces(hid_t file, const std::vector<WallSurface>& walls) {
  hdf5::make_group(file, kWalls);
  for (std::size_t n = 0; n < walls.size(); ++n) {
    const WallSurface& wall = walls[n];
    const Handle group = hdf5::make_group(file, wall_group(n).c_str());
    hdf5::set_attribute(group, "shape", wall.shape);
    const Handle points = hdf5::write_array(group, "points", {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE},
                                            {wall.points.size(), 3}, wall.points.data(), true);
    hdf5::set_text_for_python(points, "unit", "m");
    hdf5::write_array(group, "triangles", {H5T_NATIVE_INT32, H5T_STD_I32LE}, {wall.triangles.size(), 3},
                      wall.triangles.data(), true);
  }
  make_element(file, kWallPoses, H5T_IEEE_F64LE, {walls.size(), wall_pose_size}, "", true);
}

std::vector<WallSurface> read_wall_surfaces(hid_t file) {
  std::vector<WallSurface> all;
  if (!has_walls(file)) return all;
  while (hdf5::has(file, wall_group(all.size()))) {
    const Handle group = hdf5::open_group(file, wall_group(all.size()).c_str());
    WallSurface wall{hdf5::text_attribute(group, "shape").value_or(""), {}, {}};
    const auto read = [&](const char* name, hid_t type, auto& to) {
      const Handle array = hdf5::open_array(group, name);
      const std::vector<hsize_t> size = hdf5::size_of(array);
      if (size.size() != 2 || size[1] != 3) throw hdf5::Failure("a wall's surface is of another size");
      to.resize(size[0]);
      if (size[0] > 0) hdf5::check(H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to.data()), name);
    };
    read("points", H5T_NATIVE_DOUBLE, wall.points);
    read("triangles", H5T_NATIVE_INT32, wall.triangles);
    const auto points = static_cast<std::int32_t>(wall.points.size());
    for (const auto& triangle : wall.triangles) {
      if (std::ranges::any_of(triangle, [&](std::int32_t i) { return i < 0 || i >= points; }))
        throw hdf5::Failure("a wall's triangle has no such points");
    }
    all.push_back(std::move(wall));
  }
  return all;
}

void pose_numbers(const TrajectoryFrame& frame, std::vector<double>& numbers) {
  numbers.clear();
  for (const FrameWall& wall : frame.walls) {
    numbers.insert(numbers.end(), wall.offset.c, wall.offset.c + 3);
    numbers.push_back(wall.turn.w);
    numbers.insert(numbers.end(), wall.turn.v.c, wall.turn.v.c + 3);
    numbers.push_back(wall.is_there ? 1 : 0);
  }
}

void set_poses(const std::vector<double>& numbers, TrajectoryFrame& frame) {
  for (std::size_t n = 0; n + wall_pose_size <= numbers.size(); n += wall_pose_size) {
    const double* p = &numbers[n];
    frame.walls.push_back(
        {.offset = {p[0], p[1], p[2]}, .turn = {p[3], {p[4], p[5], p[6]}}, .is_there = p[7] != 0});
  }
}

}  // namespace fiberchain::dem::h5md
