#include "tests/fuzz/readers.hpp"

#include <algorithm>
#include <iterator>

#include "dem/files/file_error.hpp"
#include "dem/mesh/mesh_topology.hpp"
#include "dem/mesh/read_mesh.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/fiber_csv.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/trajectory/checkpoint.hpp"
#include "dem/trajectory/h5md.hpp"
#include "dem/trajectory/vtk.hpp"
#include "tests/dem/trajectory/files.hpp"
#include "tests/dem/trajectory/frames.hpp"

namespace fiberchain::test {
namespace {

namespace fs = std::filesystem;

/// Only the errors that a reader is to throw are caught.
template <class Error, class Action>
void refused_or_read(const Action& action) {
  try {
    action();
  } catch (const Error&) {
  }
}

void read_scene_file(const fs::path& place) {
  refused_or_read<dem::SceneError>([&] { dem::read_scene(place / "input"); });
}

void read_starts(const fs::path& place) {
  refused_or_read<dem::SceneError>([&] { dem::read_fiber_starts((place / "input").string()); });
}

void read_mesh_of(const fs::path& place, const std::string& name) {
  refused_or_read<dem::InvalidInput>([&] {
    const dem::TriangleMesh mesh = dem::make_mesh(dem::read_mesh(content(place / "input"), name), 1e-3, name);
    dem::notes_on(mesh, true);
  });
}

void read_stl_file(const fs::path& place) { read_mesh_of(place, "input.stl"); }

void read_obj_file(const fs::path& place) { read_mesh_of(place, "input.obj"); }

void read_checkpoint_file(const fs::path& place) {
  refused_or_read<dem::ReadError>([&] { dem::read_checkpoint(place / "input"); });
}

void read_trajectory(const fs::path& place) {
  refused_or_read<dem::ReadError>([&] {
    const dem::TrajectoryReader reader(place / "input");
    for (std::int64_t n = 0; n < reader.frames(); ++n) reader.read(n), reader.scalars(n);
  });
}

void read_series(const fs::path& place) {
  fs::copy_file(place / "input", place / "s.pvd", fs::copy_options::overwrite_existing);
  refused_or_read<dem::ReadError>([&] { dem::VtkSeries::read(place, "s", {}, 1'000'000); });
}

std::vector<std::string> scenes() {
  std::vector<std::string> all;
  for (const auto& file : fs::directory_iterator(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes"))
    if (file.path().extension() == ".yaml") all.push_back(content(file.path()));
  std::ranges::sort(all);
  return all;
}

std::string some_starts() {
  const std::string all = content(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes/crossed-layers.csv");
  return all.substr(0, all.find('\n', 3000) + 1);
}

std::string ascii_stl() {
  return content(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/meshes/hopper.stl").substr(0, 3 + 40 * 157) +
         "endsolid";
}

/// Two triangles.
std::string binary_stl() {
  std::string bytes(80, ' ');
  bytes += std::string("\2\0\0\0", 4);
  const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0.25f, 0, 1, 0}};
  for (const auto& triangle : corners) {
    bytes += std::string(12, '\0');
    bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string checkpoint(const fs::path& place) {
  dem::Checkpoint state;
  state.program = "p", state.scene_sha256 = "s", state.scene = "scene: packing\n";
  state.threads = 1, state.step = 7, state.time = 0.1;
  state.state["positions"] = {1, std::vector<double>(30, 0.5)};
  state.state["keys"] = {1, std::vector<std::int64_t>{1, 2, 3}};
  dem::write_checkpoint(place / "seed.checkpoint", state);
  return content(place / "seed.checkpoint");
}

std::string trajectory(const fs::path& place) {
  const fs::path path = place / "seed.h5";
  dem::TrajectoryWriter writer(path, {"tester", "1", {{"command", "x"}}});
  for (const std::int64_t step : {0, 10}) writer.append(bent_fibers(2, 5, step), {{"height", 1.0}});
  return content(path);
}

std::string series(const fs::path& place) {
  dem::VtkSeries written(place, "seed", {.provenance = {{"command", "x"}}});
  for (const std::int64_t step : {0, 10}) written.append(bent_fibers(2, 5, step));
  return content(place / "seed.pvd");
}

constexpr const char* kWords[] = {"1e300",
                                  "-1",
                                  "nan",
                                  "inf",
                                  "0",
                                  "1e-300",
                                  " deg",
                                  " m/s",
                                  ": {",
                                  "}",
                                  "[",
                                  "\n- ",
                                  "count",
                                  "z: ",
                                  "scene:",
                                  "&a *a",
                                  "\"",
                                  "\t",
                                  "9223372036854775808",
                                  "\0",
                                  "\xff",
                                  "#",
                                  "<<: ",
                                  "true",
                                  "~",
                                  ",",
                                  "|",
                                  "/>",
                                  "<a"};

}  // namespace

std::vector<Reader> readers(const fs::path& place) {
  return {{"scene", scenes(), read_scene_file},
          {"starts", {some_starts()}, read_starts},
          {"stl", {ascii_stl(), binary_stl()}, read_stl_file},
          {"obj",
           {"# x\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2//1 3 -1\nf 1 2 4\n"},
           read_obj_file},
          {"checkpoint", {checkpoint(place)}, read_checkpoint_file},
          {"trajectory", {trajectory(place)}, read_trajectory},
          {"series", {series(place)}, read_series}};
}

// Knuth's linear congruential generator; the upper bits are good.
std::size_t Mutation::below(std::size_t limit) {
  state_ = state_ * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::size_t>(state_ >> 33) % std::max<std::size_t>(limit, 1);
}

void Mutation::change(std::string& bytes, const Reader& reader) {
  const std::size_t at = below(bytes.size() + 1), length = std::min(below(40), bytes.size() - at);
  switch (below(7)) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = static_cast<char>(below(256));
      break;
    case 2:
      bytes.erase(at, length);
      break;
    case 3:
      bytes.insert(at, bytes.substr(at, length));
      break;
    case 4:
      bytes.replace(at, length, kWords[below(std::size(kWords))]);
      break;
    case 5: {
      const std::string& other = reader.seeds[below(reader.seeds.size())];
      bytes.insert(at, other.substr(below(other.size()), below(80)));
      break;
    }
    default:
      if (below(8) == 0) bytes.resize(at);
  }
}

std::string Mutation::of(const Reader& reader) {
  std::string bytes = reader.seeds[below(reader.seeds.size())];
  for (std::size_t n = 1 + below(6); n > 0; --n) change(bytes, reader);
  return bytes;
}

}  // namespace fiberchain::test
