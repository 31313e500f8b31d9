#include "compare/bench/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "compare/study/tabulate.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/run/processor_time.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

using Place = dem::Vec<double, 3>;

/// The inside of a box, `cells` by `cells` squares a face, two triangles each; corners inside of a face
/// dented outward by up to `dent` [m].
dem::TriangleSoup box_of_triangles(const dem::Box& box, int cells, double dent) {
  dem::TriangleSoup soup;
  const auto add = [&](const Place& a, const Place& b, const Place& c) {
    const auto first = static_cast<std::int32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {a, b, c});
    soup.triangles.push_back({first, first + 1, first + 2});
  };
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](int i, int j) {
      Place x{};
      x[axis] = face % 2 == 0 ? box.low[axis] : box.high[axis];
      x[u] = box.low[u] + (box.high[u] - box.low[u]) * i / cells;
      x[v] = box.low[v] + (box.high[v] - box.low[v]) * j / cells;
      const bool is_inside = i > 0 && j > 0 && i < cells && j < cells;
      if (is_inside)
        x[axis] += (face % 2 == 0 ? -dent : dent) * (0.5 + 0.5 * std::sin(37.0 * i + 101.0 * j * j));
      return x;
    };
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const Place a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
        face % 2 == 0 ? add(a, b, c) : add(a, c, b);
        face % 2 == 0 ? add(a, c, d) : add(a, d, c);
      }
    }
  }
  return soup;
}

struct Runner {
  MeshTime time;
  dem::Assembly assembly;
  std::vector<double> windows = {};  ///< of the processor: others may use it too [s]
};

Runner runner(const dem::PackingStart& start, const dem::CarriedState& state, std::int64_t steps,
              const std::string& name, std::vector<dem::Wall> walls, std::int64_t triangles) {
  std::vector<dem::FiberGroup> groups;
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    groups.push_back({start.groups[g].chain, state.groups[g].fibers});
  dem::Domain domain = start.domain;
  domain.walls = std::move(walls);
  dem::AssemblyOptions options = start.options;
  options.steps_before = steps;
  Runner own{{name, triangles, 0, 0, 0, 1}, dem::Assembly(std::move(groups), std::move(domain), options)};
  own.assembly.take_over(state);
  own.time.spheres = own.assembly.spheres();
  return own;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

}  // namespace

std::vector<MeshTime> mesh_times(const dem::PackingScene& scene, const BenchOptions& options) {
  const std::int64_t fall = options.quick ? 6000 : 15000, window = options.quick ? 50 : 200;
  const int rounds = options.quick ? 7 : 31;
  const dem::PackingStart start = dem::packing_start(scene, 1);
  dem::CarriedState state;
  {
    dem::PackingStart fallen = dem::packing_start(scene, 2);
    dem::Assembly assembly = dem::make_assembly(std::move(fallen));
    assembly.march(fall);
    state = dem::carried_state(assembly.saved());
  }
  std::vector<std::unique_ptr<Runner>> all;
  const auto add = [&](const std::string& name, std::vector<dem::Wall> walls, std::int64_t triangles) {
    all.push_back(std::make_unique<Runner>(runner(start, state, fall, name, std::move(walls), triangles)));
  };
  add("planes", start.domain.walls, 0);
  const auto add_mesh = [&](const std::string& name, int cells, double dent) {
    auto mesh = std::make_shared<const dem::TriangleMesh>(
        dem::make_mesh(box_of_triangles(scene.scene_box, cells, dent), 1, "box"));
    const std::int64_t triangles = mesh->faces();
    add(name, {{dem::MeshShape{.mesh = std::move(mesh), .sides = dem::MeshSides::one}}}, triangles);
  };
  add_mesh("mesh", 9, 0);
  add_mesh("mesh", 91, 0);
  add_mesh("dented mesh", 91, 1e-5);
  for (auto& one : all) one->assembly.march(window);  // warm
  for (int round = 0; round < rounds; ++round) {
    for (auto& one : all) {
      double& had = one->windows.emplace_back(0);
      const dem::ProcessorTimer timer(had);
      one->assembly.march(window);
    }
  }
  std::vector<MeshTime> times;
  for (const auto& one : all) {
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round)
      ratios.push_back(one->windows[round] / all[0]->windows[round]);
    one->time.ratio = median(ratios);
    one->time.all = 1e9 * median(one->windows) / static_cast<double>(one->time.spheres * window);
    for (const auto& contact : one->assembly.contacts())
      one->time.at_walls += is_facet(contact.key.second) ? 1 : 0;
    times.push_back(one->time);
  }
  return times;
}

dem::Table mesh_time_table(const std::vector<MeshTime>& times) {
  return tabulate(times, [](const MeshTime& t) -> dem::NamedRow {
    return {{"walls", t.walls},        {"triangles", t.triangles},
            {"spheres", t.spheres},    {"wall_contacts", t.at_walls},
            {"sphere_step_ns", t.all}, {"sphere_step_ratio", t.ratio}};
  });
}

}  // namespace fiberchain::compare
