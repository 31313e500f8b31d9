#pragma once

#include <boost/test/unit_test.hpp>
#include <string>

#include "dem/scene/packing_scene.hpp"
#include "dem/scene/scene.hpp"

// A scene in which everything stands, and its changes.
namespace packing_texts {

namespace dem = fiberchain::dem;

inline const std::string kScene = R"(scene: packing
fibers:
  - {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1.2 g/cm^3, count: 11}
  - {diameter: 1.5 mm, aspect_ratio: 12, youngs_modulus: 9 MPa, shear_modulus: 4 MPa, density: 900, bond: {model: corrected, damping: 0.7}, curvature: {radius: 3 cm}, count: 5}
filling: {region: {x: [1 cm, 6 cm], z: [2 cm, 15 cm]}, orientation: near_axis, direction: [0, 3, 4], angle: 0.3, velocity: [0, 0.1 m/s, -20 cm/s], gap: 0.2 mm, seed: 77, attempts: 5000, batches: {number: 3, interval: 40 ms}}
walls: {youngs_modulus: 1 GPa, poisson_ratio: 0.4, box: {x: 7 cm, z: 16 cm}, planes: [{point: [0, 0, 17 cm], normal: [0, 0, -2], velocity: [0, 0, -5 mm/s], from: 0.1 s, until: 0.2 s}], cylinders: [{point: [35 mm, 0, 0], axis: [0, 1, 0], radius: 90 mm}]}
periodic: {y: 5 cm}
gravity: [0, 0, -9.81 m/s^2]
fluid: {viscosity: 30 mPa s, flow: shear, rate: 2 1/s}
contacts: {restitution: 0.6, friction: 0.25, rolling_friction: 0.01, youngs_modulus: 12 MPa, poisson_ratio: 0.43}
motion: {step: 2 us, form: total, orientations: true}
duration: 0.3 s
output: {samples: 17, frames: 6, checkpoints: 4, vtk: true, energy: true}
)";

inline dem::PackingScene parse(const std::string& text, const std::string& name = "test.yaml") {
  return std::get<dem::PackingScene>(dem::parse_scene({name, text}));
}

/// The scene with the line that begins so replaced.
inline std::string with(const std::string& begin, const std::string& line) {
  std::string text = kScene;
  const auto at = text.find("\n" + begin);
  BOOST_REQUIRE(at != std::string::npos);
  const auto end = text.find('\n', at + 1);
  return text.replace(at + 1, end - at - 1, line);
}

/// The scene with a text in it replaced.
inline std::string less(const std::string& what, const std::string& by = "", std::string text = kScene) {
  const auto at = text.find(what);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

inline std::string filling(const std::string& keys) { return with("filling:", "filling: {" + keys + "}"); }
inline std::string walls(const std::string& keys) { return with("walls:", "walls: {" + keys + "}"); }

}  // namespace packing_texts
