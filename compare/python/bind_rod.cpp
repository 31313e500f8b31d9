#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "compare/python/released.hpp"
#include "compare/python/scene_of.hpp"
#include "dem/equilibrium/rod_path.hpp"

// Rods held and loaded in any way: their equilibria and paths.
namespace fiberchain::python {
namespace {

using dem::Poses;
using dem::RodPath;
using dem::RodPoint;
using dem::SingularPoint;

/// A rod of a scene; it never changes.
struct Rod {
  dem::SceneText text;
  dem::RodScene scene;
};

std::unique_ptr<Rod> rod_of_text(const std::string& content, const std::string& name,
                                 const Settings& settings) {
  dem::SceneText text = scene_text(content, name, settings);
  auto scene = scene_of<dem::RodScene>(text);
  return std::make_unique<Rod>(Rod{std::move(text), std::move(scene)});
}

/// `work(options)` with the scene's options, errors with its name.
template <class Work>
auto followed(const Rod& rod, const Work& work) {
  return released([&](const dem::StopRequest& asked) {
    dem::RodPathOptions options = rod.scene.path;
    options.asked_to_stop = asked;
    return dem::located(rod.text, [&] { return work(options); });
  });
}

/// (spheres, 4): quaternions w, x, y, z.
py::array orientations_of(const Poses<3>& poses) {
  py::array_t<double> all({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}});
  auto at = all.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    const auto& q = poses[static_cast<std::size_t>(i)].orientation;
    const std::array<double, 4> parts{q.w, q.v[0], q.v[1], q.v[2]};
    for (py::ssize_t c = 0; c < 4; ++c) at(i, c) = parts[static_cast<std::size_t>(c)];
  }
  return all;
}

/// (n, 6): displacements and rotations, or forces and moments.
py::array sixes_of(const dem::ChainVector<3>& vectors) {
  py::array_t<double> all({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{6}});
  auto at = all.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    for (py::ssize_t c = 0; c < 6; ++c) at(i, c) = vectors[static_cast<std::size_t>(i)][c];
  }
  return all;
}

py::dict equilibrium_of(const Rod& rod, const RodPoint& point) {
  py::dict all;
  all["load_factor"] = point.factor;
  all["positions"] = positions_of(point.poses);
  all["orientations"] = orientations_of(point.poses);
  all["reactions"] = sixes_of(dem::rod_reactions(rod.scene.problem, point.poses, point.factor));
  all["probe_displacement"] = point.probe;
  all["elastic_energy"] = point.elastic_energy;
  all["work"] = point.work;
  all["path_length"] = point.arc;
  all["negative_eigenvalues"] = point.negative;
  all["stability"] = std::string(dem::name(point.stability));
  all["iterations"] = point.iterations;
  return all;
}

py::dict path_of(const Rod& rod, const RodPath& path) {
  py::list points, singular;
  for (const RodPoint& point : path.points) points.append(equilibrium_of(rod, point));
  for (const SingularPoint& found : path.singular) {
    py::dict one;
    one["kind"] = std::string(dem::name(found.kind));
    one["after"] = found.after;
    one["crossing"] = found.crossing;
    one["mode"] = sixes_of(found.mode);
    one["equilibrium"] = equilibrium_of(rod, found.point);
    one["core"] = found;
    singular.append(std::move(one));
  }
  py::dict all;
  all["points"] = points;
  all["singular"] = singular;
  return all;
}

py::dict solve(const Rod& rod, double factor) {
  if (!std::isfinite(factor)) throw dem::InvalidInput("factor is not a finite number");
  return equilibrium_of(rod, followed(rod, [&](const dem::RodPathOptions& options) {
                          return dem::solve_rod(rod.scene.problem, factor, options);
                        }));
}

py::dict trace(const Rod& rod) {
  return path_of(rod, followed(rod, [&](const dem::RodPathOptions& options) {
                   return dem::trace_rod(rod.scene.problem, options);
                 }));
}

py::dict branch(const Rod& rod, const SingularPoint& from, int sign, double amplitude) {
  return path_of(rod, followed(rod, [&](const dem::RodPathOptions& options) {
                   return dem::trace_branch(rod.scene.problem, from, sign, amplitude, options);
                 }));
}

}  // namespace

void bind_rod(py::module_& module) {
  py::class_<SingularPoint>(module, "SingularPoint", "Where a branch begins.");
  py::class_<Rod>(module, "Rod", "A rod of a scene as the engine has it.")
      .def(py::init(&rod_of_text), py::arg("text"), py::arg("name"), py::arg("settings"))
      .def_property_readonly(
          "length", [](const Rod& rod) { return dem::fiber_length(rod.scene.problem.chain.fiber); },
          "Along the rod [m].")
      .def_property_readonly(
          "bending_stiffness",
          [](const Rod& rod) { return dem::bending_stiffness(rod.scene.problem.chain.fiber); },
          "E I [N m^2].")
      .def_property_readonly(
          "bonds", [](const Rod& rod) { return rod.scene.problem.chain.fiber.aspect_ratio; },
          "Number of bonds; the spheres are 0 to this.")
      .def_property_readonly(
          "rest_positions", [](const Rod& rod) { return positions_of(rod.scene.problem.chain.poses); },
          "Of the spheres at rest, float64 (spheres, 3) [m].")
      .def_property_readonly(
          "has_potential", [](const Rod& rod) { return dem::has_potential(rod.scene.problem); },
          "Whether the loads have a potential, so that stability can be told.")
      .def("_solve", &solve, py::arg("factor"))
      .def("_trace", &trace)
      .def("_branch", &branch, py::arg("singular"), py::arg("sign"), py::arg("amplitude"));
}

}  // namespace fiberchain::python
