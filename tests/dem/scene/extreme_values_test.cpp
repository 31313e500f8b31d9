// Every number of every kind of scene, made as large, small or wrong as a number can be: refused with its
// line and key, or taken with numbers that a run can begin with.
#include <yaml-cpp/yaml.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include "dem/scene/build_packing.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(extreme_values_test)

namespace dem = fiberchain::dem;

namespace {

#define FIBER "diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000"
#define STIFF                                                                                              \
  "diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, shear_modulus: 1 MPa, transverse_modulus: 2 " \
  "MPa, density: 900"

#define DAMPED                                                                                            \
  FIBER                                                                                                   \
  ", material_damping: {loss_factor: 0.02, shear_loss_factor: 0.03, band: [10, 10000], branches: 4, "     \
  "modulus_frequency: 100, thermoelastic: {expansion: 2e-5, temperature: 300, heat_capacity: 500, "       \
  "conductivity: 50, highest_frequency: 1e5}, spectrum: {youngs_modulus: [{strength: 0.1, time: 1e-3}], " \
  "shear_modulus: [{strength: 0.1, time: 1e-3}], bending: [{strength: 0.1, time: 1e-3}]}}"

/// All together have every number that a scene can have.
const char* const kScenes[] = {
    "scene: cantilever\nfiber: {" DAMPED "}\nload: {reduced: 1}\n",
    "scene: release\nfiber: {" DAMPED ", spacing: 1.5}\nload: {reduced: 1}\n",
    "scene: packing\nfibers: [{" DAMPED
    ", spacing: 1, count: 4}]\nperiodic: {x: 30 mm, y: 30 mm}\n"
    "filling: {region: {z: [1 mm, 30 mm]}}\nwalls: {planes: [{point: [0, 0, 0], normal: [0, 0, 1]}]}\n"
    "steps: 200\n",
    "scene: cantilever\nfiber: {" FIBER
    ", spacing: 1.5}\nbond: {damping: 0.1}\n"
    "load: {reduced: 1, direction: [0, 1, 0]}\ngravity: [0, -1, 0]\n",
    "scene: cantilever\nfiber: {" STIFF
    "}\nload: {force: 1e-4}\nmethod: march\nmarch: {bond_damping: 1, drag: 0.3, "
    "step_ratio: 0.1, ramp_periods: 1, residual: 1e-3, max_periods: 100}\n",
    "scene: release\nfiber: {" FIBER
    "}\nbond: {damping: 0.1, rolling_friction: 0.1, form: incremental}\n"
    "load: {reduced: 1, direction: [0, 1, 0]}\nperiods: 2\ntime: {error: 0.01, samples_per_period: 50}\n",
    "scene: release\nfiber: {" STIFF
    "}\nload: {force: 1e-4}\ntime: {integrator: leapfrog, step_ratio: 0.1}\n",
    "scene: release\nfiber: {" FIBER "}\nload: {reduced: 1}\ntime: {integrator: cvode, tolerance: 1e-6}\n",
    "scene: flow\nfiber: {" FIBER
    ", spacing: 1}\nbond: {damping: 0.1}\n"
    "fluid: {viscosity: 10, flow: shear, rate: 2, course: {start_up: 1}}\n"
    "start: {direction: [0, 1, 0], bend: 0.01, s_bend: 0.01, bend_direction: [1, 0.1, 0]}\nmotion: "
    "{tolerance: "
    "1e-6}\n"
    "duration: 1\nsamples: 10\nshapes: 2\n",
    "scene: flow\nfiber: {" STIFF
    "}\n"
    "fluid: {viscosity: 10, gradient: [[0, 1, 0], [0.1, 0, 0], [0, 0, 0]], course: {oscillation: 2, phase: "
    "1}}\n"
    "start: {direction: [0, 1, 0]}\nmotion: {method: leapfrog, step_ratio: 0.5}\nstrain: 0.2\n",
    "scene: rod\ndimension: spatial\nfiber: {" FIBER
    ", spacing: 1}\nbond: {damping: 0.1}\nshape: {arc: 0.6, turn: {axis: [0, 0, 1], angle: 0.3}}\n"
    "supports: [{sphere: first, axes: {axis: [0, 0, 1], angle: 0.1}, move: [1 mm, 0, 0], rotate: [0.1, 0, "
    "0]}]\n"
    "loads: [{sphere: last, force: [0, 1e-4, 0], moment: [0, 1e-7, 0], reduced_force: [1, 0, 0], "
    "reduced_moment: [0, 1, 0]}]\n"
    "line_loads: [{spheres: all, force: [0, 1e-3, 0], reduced_force: [0, 0, 1]}]\ngravity: [0, -1, 0]\n"
    "path: {points: 9, most_points: 50, end_factor: 1.5, end_displacement: 1 mm, probe: {direction: [0, 1, "
    "0]}, "
    "largest_step: 0.1, tolerance: 1e-9}\nbranch: {bifurcation: 1, amplitude: 0.03}\nshapes: 4\n",
    "scene: rod\nfiber: {" STIFF "}\nshape: {corner: 3}\nsupports: [{sphere: first}]\n",
    "scene: rod\nfiber: {" FIBER
    "}\nshape: {points: [{at: [0, 0, 0]}, {at: [12 mm, 0, 0]}]}\nsupports: [{sphere: first}]\n",
    "scene: packing\nfibers: [{" FIBER
    ", bond: {damping: 0.1, rolling_friction: 0.1}, count: 4}, "
    "{" STIFF
    ", curvature: {radius: 2 cm}, count: 3}]\n"
    "filling: {region: {x: [1 mm, 25 mm], y: [1 mm, 25 mm], z: [1 mm, 30 mm]}, orientation: near_axis, "
    "direction: [0, 0, 1], angle: 0.5, velocity: [0, 0, -1], gap: 0.1 mm, seed: 1, attempts: 1000, "
    "batches: {number: 2, interval: 2 ms}}\n"
    "walls: {youngs_modulus: 1 MPa, poisson_ratio: 0.3, box: {x: 30 mm, y: 30 mm, z: 40 mm}, "
    "planes: [{point: [0, 0, 39 mm], normal: [0, 0, -1], velocity: [0, 0, -0.1], from: 0, until: 5 ms}], "
    "cylinders: [{point: [15 mm, 15 mm, 0], axis: [0, 0, 1], radius: 30 mm, velocity: [0, 0, 0.1], from: 0, "
    "until: 1}]}\n"
    "gravity: [0, 0, -9.81]\ncontacts: {law: jkr, work_of_adhesion: 0.05, restitution: 0.5, friction: 0.3, "
    "rolling_friction: "
    "0.01, "
    "youngs_modulus: 1 MPa, poisson_ratio: 0.3}\n"
    "motion: {restitution_error: 0.02}\nduration: 5 ms\noutput: {samples: 5, frames: 2, checkpoints: 1}\n",
    "scene: packing\nfibers: [{" FIBER
    ", count: 4}]\nfilling: {region: {x: [1 mm, 25 mm], y: [1 mm, 25 mm], z: [1 mm, 30 mm]}}\n"
    "walls: {planes: [{point: [0, 0, -1 mm], normal: [0, 0, 1], rotation: {point: [0, 0, 0], axis: [0, 0, "
    "1], "
    "angular_velocity: 1}}, {point: [0, 0, 60 mm], normal: [0, 0, -1], oscillation: {axis: [0, 0, 1], "
    "amplitude: "
    "1 mm, frequency: 10, phase: 1, ramp: 1}}, {point: [-5 mm, 0, 0], normal: [1, 0, 0], drive: {axis: [1, "
    "0, 0], "
    "mass: 1, force: 0.1, damping: 1}}, {point: [60 mm, 0, 0], normal: [-1, 0, 0], drive: {axis: [1, 0, 0], "
    "mass: "
    "1, pressure: 0.1, area: 1e-4}}], "
    "spheres: [{center: [0, 0, 200 mm], radius: 20 mm, fibers: outside, velocity: [0, 0, 0.1], from: 0, "
    "until: 1}], "
    "obstacles: [{center: [0, 0, 200 mm], sides: [10 mm, 11 mm, 12 mm], along: [1, 0, 0], across: [0, 1, 0], "
    "velocity: [0, 0, 0.1], from: 0, until: 1}], "
    "cones: [{point: [0, 0, 200 mm], axis: [0, 0, 1], radius: 20 mm, end_radius: 10 mm, length: 30 mm, "
    "thickness: "
    "1 mm, velocity: [0, 0, 0.1], from: 0, until: 1}], "
    "meshes: [{file: " FIBERCHAIN_SOURCE_DIR
    "/tests/dem/mesh/tetrahedron.obj, scale: 1 mm, place: [0, 0, 300 mm], turn: {axis: [1, 0, 0], angle: "
    "0.1}, "
    "velocity: [0, 0, 0.1], from: 0, until: 1}]}\nsteps: 200\n",
    "scene: packing\nfibers: [{" FIBER
    ", count: 4, name: a}]\nfilling: {region: {x: [1 mm, 25 mm], y: [1 mm, 25 mm], z: [1 mm, 30 mm]}}\n"
    "walls: {planes: [{point: [0, 0, -1 mm], normal: [0, 0, 1], name: b, youngs_modulus: 1e7, poisson_ratio: "
    "0.2, contacts: {restitution: 0.5, friction: 0.2, rolling_friction: 0.1}}]}\n"
    "contacts: {restitution: 0.5, pairs: [{between: [a, b], restitution: 0.6, friction: 0.3, "
    "rolling_friction: "
    "0.2, youngs_modulus: 1e6, poisson_ratio: 0.3}]}\n"
    "held: [{fiber: 1, spheres: first, velocity: [0, 0, 0.1], from: 0, until: 1, rotation: {point: [0, 0, "
    "0], "
    "axis: [0, 0, 1], angular_velocity: 1}, oscillation: {axis: [0, 0, 1], amplitude: 1 mm, frequency: 10, "
    "phase: 1, ramp: 1}}]\n"
    "loads: [{fiber: 2, spheres: last, force: [0, 0, 1e-3], moment: [0, 1e-6, 0], ramp: 1 ms, from: 0, "
    "until: "
    "1}]\nsteps: 200\n",
    "scene: packing\nfibers: [{" FIBER
    ", curvature: {angle: 0.05}, count: 4}]\nperiodic: {x: 30 mm, y: 30 mm}\n"
    "filling: {region: {z: [1 mm, 30 mm]}}\nwalls: {planes: [{point: [0, 0, 0], normal: [0, 0, 1]}]}\n"
    "fluid: {viscosity: 1e-3}\nmotion: {step: 10 us}\nsteps: "
    "200\n",
    "scene: packing\nfibers: [{" FIBER
    ", count: 4, bond: {strength: {tension: 1 MPa, compression: 2 MPa, shear: 1 MPa, torsion: 1 MPa, "
    "weibull: "
    "{modulus: 5, reference_length: 1 cm, seed: 3}}, yield: {moment: 1e-5, hardening: 0.1}}}, {" FIBER
    ", count: 4, bond: {yield: {stress: 1 MPa}}}]\nperiodic: {x: 30 mm}\n"
    "filling: {region: {y: [0, 3 cm], z: [0, 3 cm]}}\nsteps: 200\n",
    "scene: packing\nfibers: [{" FIBER
    ", count: 4}]\nperiodic: {x: 30 mm, z: 30 mm}\n"
    "filling: {region: {y: [0, 3 cm]}}\nfluid: {viscosity: 1e-3, gradient: [[0, 1, 0], [0, 0, 0], [0, 2, "
    "0]], course: "
    "{oscillation: 2, phase: 1}}\nsteps: 200\n",
    "scene: packing\nfibers: [{" FIBER
    ", count: 4}]\nperiodic: {x: 30 mm}\n"
    "filling: {region: {y: [0, 3 cm], z: [0, 3 cm]}}\nfluid: {viscosity: 1e-3, flow: shear, rate: 0.1, "
    "course: "
    "{start_up: 1}}\nsteps: 200\n",
};

/// A sanitizer takes several times as long.
#ifdef FIBERCHAIN_SANITIZED
constexpr const char* kValues[] = {"1e300", "nan", "-1"};
#else
constexpr const char* kValues[] = {"1e300", "-1e300", "nan", "inf", "1e30", "1e-300", "-1"};
#endif

bool is_number(const std::string& text) {
  std::istringstream words(text);
  double value = 0;
  return static_cast<bool>(words >> value);
}

/// use(node, path without list numbers) with every number of a document; nodes are set in place.
void each_number(YAML::Node node, const std::string& path,
                 const std::function<void(YAML::Node, const std::string&)>& use) {
  if (node.IsMap()) {
    for (const auto& entry : node) {
      const std::string key = entry.first.Scalar();
      each_number(entry.second, path.empty() ? key : path + "." + key, use);
    }
  } else if (node.IsSequence()) {
    for (const auto& entry : node) each_number(entry, path, use);
  } else if (node.IsScalar() && is_number(node.Scalar())) {
    use(node, path);
  }
}

std::string without_list_numbers(std::string path) {
  for (std::size_t at = 0; (at = path.find('[', at)) != std::string::npos;)
    path.erase(at, path.find(']', at) + 1 - at);
  return path;
}

/// What is said of a scene: "FILE:LINE: KEY: ..."; empty where it is right.
std::string said(const std::string& text) {
  try {
    const dem::Scene scene = dem::parse_scene({"s.yaml", text});
    const auto* packing = std::get_if<dem::PackingScene>(&scene);
    if (!packing) return "";
    const double step = dem::plan_of(*packing).step;
    BOOST_TEST((step > 0 && std::isfinite(step)), step);
    return "";
  } catch (const dem::SceneError& error) {
    return error.what();
  }
}

/// Whether an error is about this key, or about a mapping it stands in.
bool is_about(const std::string& error, const std::string& key) {
  std::size_t at = std::string("s.yaml:").size();
  if (!error.starts_with("s.yaml:") || error.find_first_not_of("0123456789", at) == at) return false;
  at = error.find(": ", at) + 2;
  const std::string own = without_list_numbers(error.substr(at, error.find(": ", at) - at));
  // of two sides in one direction the second is told
  if (key.ends_with(".along") && own == key.substr(0, key.rfind('.')) + ".across") return true;
  return own.starts_with(key) || key.starts_with(own + ".");
}

std::string text_of(const YAML::Node& node) {
  YAML::Emitter out;
  out << node;
  return out.c_str();
}

void collect(const std::vector<dem::KeyDeclaration>& keys, const std::string& path,
             std::set<std::string>& all) {
  for (const dem::KeyDeclaration& key : keys) {
    const std::string own = path + key.name;
    if (!key.unit.empty()) all.insert(own);
    collect(key.keys, own + ".", all);
  }
}

/// Neither a direction, whose length does not matter, nor an angle.
bool has_size(const std::string& key) {
  for (const char* end : {"direction", "normal", "axis", "along", "across"})
    if (key.ends_with(end)) return false;
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_scenes_have_every_number) {
  for (const dem::SceneKind& kind : dem::scene_kinds()) {
    std::set<std::string> declared, there;
    collect(kind.keys(), "", declared);
    for (const char* scene : kScenes) {
      const YAML::Node node = YAML::Load(scene);
      if (node["scene"].Scalar() == kind.name)
        each_number(node, "", [&](const YAML::Node&, const std::string& path) { there.insert(path); });
    }
    // a wall's place in every shape, how it goes at one of them: the same functions declare and read it.
    // Courses are of files (wall_motion_test).
    const auto elsewhere = [](const std::string& key) {
      if (key.find(".course.") != std::string::npos) return true;
      if (!key.starts_with("walls.")) return false;
      for (const char* own : {".rotation.", ".oscillation.", ".drive.", ".contacts."}) {
        if (key.find(own) != std::string::npos) return !key.starts_with("walls.planes.");
      }
      return key.ends_with(".youngs_modulus") || key.ends_with(".poisson_ratio");
    };
    for (const std::string& key : declared) {
      if (elsewhere(key)) continue;
      const bool without = kind.name == std::string("flow") || kind.name == std::string("rod");
      const bool refused = without && key.starts_with("fiber.material_damping");
      BOOST_TEST((refused || there.count(key) == 1u), kind.name << ": " << key);
    }
  }
}

BOOST_DATA_TEST_CASE(each_number_is_refused_at_its_key_or_taken, boost::unit_test::data::make(kScenes),
                     scene) {
  BOOST_TEST_REQUIRE(said(scene) == "");
  const YAML::Node document = YAML::Load(scene);
  each_number(document, "", [](YAML::Node node, const std::string&) { node.SetTag(""); });
  each_number(document, "", [&](YAML::Node node, const std::string& key) {
    const std::string before = node.Scalar();
    for (const char* value : kValues) {
      node = value;
      const std::string error = said(text_of(document));
      const bool must = has_size(key) && std::string(value) != "1e-300" && std::string(value) != "-1";
      const bool no_number = !std::isfinite(std::stod(value));
      if (must || no_number) BOOST_TEST(error != "", key << ": " << value);
      if (error != "") BOOST_TEST(is_about(error, key), key << ": " << value << ": " << error);
    }
    node = before;
  });
  BOOST_TEST(said(text_of(document)) == "");
}

BOOST_AUTO_TEST_SUITE_END()
