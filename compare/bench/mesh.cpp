#include "compare/bench/mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "compare/bench/turns.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/mesh/mesh_shape.hpp"
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

dem::Assembly taken_over(const dem::PackingStart& start, const dem::CarriedState& state, std::int64_t steps,
                         std::vector<dem::Wall> walls) {
  std::vector<dem::FiberGroup> groups;
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    groups.push_back({start.groups[g].chain, state.groups[g].fibers});
  dem::Domain domain = start.domain;
  domain.walls = std::move(walls);
  dem::AssemblyOptions options = start.options;
  options.steps_before = steps;
  dem::Assembly assembly(std::move(groups), std::move(domain), options);
  assembly.take_over(state);
  return assembly;
}

}  // namespace

std::vector<MeshTime> mesh_times(const dem::PackingScene& scene, const BenchOptions& options) {
  const TurnPlan plan = turn_plan(options);
  const dem::PackingStart start = dem::packing_start(scene, 1);
  dem::CarriedState state;
  {
    dem::PackingStart fallen = dem::packing_start(scene, 2);
    dem::Assembly assembly = dem::make_assembly(std::move(fallen));
    assembly.march(plan.fall);
    state = dem::carried_state(assembly.saved());
  }
  std::vector<MeshTime> times;
  std::vector<std::unique_ptr<dem::Assembly>> packings;
  const auto add = [&](const std::string& name, std::vector<dem::Wall> walls, std::int64_t triangles) {
    packings.push_back(
        std::make_unique<dem::Assembly>(taken_over(start, state, plan.fall, std::move(walls))));
    times.push_back({name, triangles, packings.back()->spheres(), 0, 0, 1});
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
  for (auto& one : packings) one->march(plan.window);  // warm
  const std::vector<TurnTime> turns = march_in_turns(packings, plan);
  for (std::size_t n = 0; n < times.size(); ++n) {
    times[n].all = turns[n].sphere_step, times[n].ratio = turns[n].ratio;
    for (const auto& contact : packings[n]->contacts())
      times[n].at_walls += is_facet(contact.key.second) ? 1 : 0;
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
