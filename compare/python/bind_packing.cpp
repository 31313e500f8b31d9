#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "compare/python/live_packing.hpp"
#include "compare/python/released.hpp"
#include "compare/python/scene_of.hpp"
#include "dem/analysis/observables.hpp"

// Packings step by step.
namespace fiberchain::python {
namespace {

V vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::unique_ptr<LivePacking> begun(const std::string& content, const std::string& name,
                                   const Settings& settings, int threads) {
  return released([&](const dem::StopRequest& asked) {
    return std::make_unique<LivePacking>(scene_text(content, name, settings), threads, asked);
  });
}

/// What the program's log has of this moment.
py::dict measured(const LivePacking& packing) {
  const dem::PackingScene& scene = packing.scene();
  const dem::RunMoment moment = packing.measure();
  py::dict all;
  all["step"] = moment.step;
  all["simulated_time"] = moment.time;
  all["contacts"] = moment.contacts;
  all["height"] = moment.height;
  all["bending_mean"] = moment.bending_mean;
  all["overlap_mean"] = moment.overlap_mean;
  all["overlap_peak"] = moment.overlap_peak;
  for (const auto& [column, cell] : dem::energy_cells(moment.energy, scene.account_energy))
    all[py::str(std::string(column))] = std::get<double>(cell);
  return all;
}

py::dict structure(const LivePacking& packing) {
  const dem::Assembly& assembly = packing.assembly();
  dem::Orientations orientations(dem::upward(packing.scene()));
  std::vector<std::int32_t> fiber_of;
  std::int32_t number = 0;
  for (int g = 0; g < assembly.groups(); ++g) {
    orientations.add(assembly.states(g));
    for (int f = 0; f < assembly.fibers(g); ++f, ++number)
      fiber_of.insert(fiber_of.end(), static_cast<std::size_t>(assembly.chain(g).fiber.aspect_ratio) + 1,
                      number);
  }
  const dem::Coordination touching = dem::coordination(assembly.contacts(), fiber_of);
  py::dict all;
  all["contacts_per_sphere"] = touching.per_sphere;
  all["contacts_per_fiber"] = touching.per_fiber;
  all["neighbors_per_fiber"] = touching.neighbors_per_fiber;
  all["touching_spheres"] = touching.touching_spheres;
  all["order"] = orientations.order();
  all["order_along_up"] = orientations.order_along_up();
  all["mean_polar_angle"] = orientations.mean_polar_angle();
  return all;
}

py::dict wall_now(const LivePacking& packing, int number) {
  const dem::Assembly& assembly = packing.assembly();
  const auto& walls = assembly.walls();
  if (number < 0 || number >= static_cast<int>(walls.size())) throw py::index_error("no such wall");
  const dem::Wall& wall = walls[static_cast<std::size_t>(number)];
  const dem::WallSample sample = assembly.wall_samples()[static_cast<std::size_t>(number)];
  py::dict all;
  all["name"] = wall.name;
  all["shape"] = std::string(wall.shape.type().name);
  all["force"] = tuple_of(sample.mean.force);
  all["moment"] = tuple_of(sample.mean.moment);
  all["force_peak"] = sample.force_peak;
  all["work"] = sample.work;
  all["place"] = tuple_of(sample.center);
  all["velocity"] = tuple_of(wall.velocity);
  all["active"] = dem::is_active(wall, assembly.time());
  return all;
}

void bind_motion(py::class_<LivePacking>& packing) {
  packing
      .def(
          "march",
          [](LivePacking& p, std::int64_t steps, bool kept) {
            const LivePacking::Working working(p);
            released([&](const dem::StopRequest& asked) { p.march(steps, kept, asked); });
          },
          py::arg("steps"), py::arg("keep_forces"))
      .def_property(
          "gravity", [](const LivePacking& p) { return tuple_of(p.assembly().gravity()); },
          [](LivePacking& p, const std::array<double, 3>& g) { p.assembly().set_gravity(vector_of(g)); })
      .def(
          "set_wall_velocity",
          [](LivePacking& p, int wall, const std::array<double, 3>& v) {
            p.assembly().set_wall_velocity(wall, vector_of(v));
          },
          py::arg("wall"), py::arg("velocity"))
      .def(
          "shift_wall",
          [](LivePacking& p, int wall, const std::array<double, 3>& by) {
            p.assembly().shift_wall(wall, vector_of(by));
          },
          py::arg("wall"), py::arg("by"));
}

}  // namespace

void bind_packing(py::module_& module) {
  py::class_<LivePacking> packing(module, "Packing", "Many fibers that meet, marched a piece at a time.");
  packing.def(py::init(&begun), py::arg("text"), py::arg("name"), py::arg("settings"), py::arg("threads"))
      .def_property_readonly("time", [](const LivePacking& p) { return p.assembly().time(); })
      .def_property_readonly("steps", [](const LivePacking& p) { return p.assembly().steps(); })
      .def_property_readonly("time_step", [](const LivePacking& p) { return p.assembly().step(); })
      .def_property_readonly("step_set_by",
                             [](const LivePacking& p) { return std::string(p.choice().set_by); })
      .def_property_readonly("total_steps", &LivePacking::total_steps)
      .def_property_readonly("spheres", [](const LivePacking& p) { return p.assembly().spheres(); })
      .def_property_readonly("wall_count", [](const LivePacking& p) { return p.assembly().walls().size(); })
      .def_property_readonly("messages", &LivePacking::messages)
      .def_property_readonly("positions",
                             [](const LivePacking& p) { return array_of(p.assembly().placed().position); })
      .def(
          "frame",
          [](const LivePacking& p, bool contacts) {
            return std::make_shared<dem::TrajectoryFrame>(p.frame(contacts));
          },
          py::arg("contacts"))
      .def("wall", &wall_now, py::arg("number"))
      .def("measure", &measured)
      .def("structure", &structure);
  bind_motion(packing);
}

}  // namespace fiberchain::python
