#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(flow_scene_test)

namespace dem = fiberchain::dem;

namespace {

const std::string kScene = R"(scene: flow
dimension: spatial
fiber: {diameter: 3 mm, aspect_ratio: 13, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1.2 g/cm^3}
bond: {model: corrected, damping: 0.7}
fluid: {viscosity: 250 mPa s, flow: shear, rate: -30 1/min, hydrodynamics: stresslets}
start: {direction: [3, 4, 0], bend: 0.01, s_bend: -0.002, bend_direction: [1, 2, 2]}
motion: {method: inertialess, tolerance: 1e-6}
strain: 7.5
samples: 60
shapes: 5
)";

dem::FlowScene parse(const std::string& text) {
  return std::get<dem::FlowScene>(dem::parse_scene({"test.yaml", text}));
}

/// The scene with the rest of the line that begins so replaced.
std::string with(const std::string& begin, const std::string& line) {
  std::string text = kScene;
  const auto at = text.find("\n" + begin);
  BOOST_REQUIRE(at != std::string::npos);
  const auto end = text.find('\n', at + 1);
  return text.replace(at + 1, end - at - 1, line);
}

std::string fluid(const std::string& keys) { return with("fluid:", "fluid: {" + keys + "}"); }
std::string start(const std::string& keys) { return with("start:", "start: {" + keys + "}"); }
std::string motion(const std::string& keys) { return with("motion:", "motion: {" + keys + "}"); }

/// The same in the plane.
std::string planar(const std::string& fluid_keys, const std::string& start_keys) {
  std::string text = kScene.substr(0, kScene.find("fluid:"));
  text.replace(text.find("spatial"), 7, "planar");
  return text + "fluid: {" + fluid_keys + "}\nstart: {" + start_keys + "}\nduration: 2 s\n";
}

struct Fault {
  std::string scene;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.says; }

const Fault kFaults[] = {
    {fluid("viscosity: 0 Pa s, flow: shear, rate: 1"),
     "test.yaml:5: fluid.viscosity: '0 Pa s' is out of range; allowed: a number at least 1e-12 and at most "
     "1e+15, in Pa s"},
    {fluid("viscosity: 1 Pa, flow: shear, rate: 1"),
     "test.yaml:5: fluid.viscosity: '1 Pa' has a unit of another dimension"},
    {fluid("flow: shear, rate: 1"), "test.yaml:5: fluid: key 'viscosity' is missing"},
    {fluid("viscosity: 1, flow: vortex, rate: 1"),
     "test.yaml:5: fluid.flow: 'vortex' is not allowed; allowed: shear, planar_extension, "
     "uniaxial_extension, rotation"},
    {fluid("viscosity: 1, flow: shear"), "test.yaml:5: fluid: key 'rate' is missing"},
    {fluid("viscosity: 1, flow: shear, rate: 0"), "test.yaml:5: fluid.rate: must not be zero"},
    {fluid("viscosity: 1, flow: shear, rate: 1 s"),
     "test.yaml:5: fluid.rate: '1 s' has a unit of another dimension"},
    {fluid("viscosity: 1"), "test.yaml:5: fluid: must have exactly one of flow, gradient"},
    {fluid("viscosity: 1, gradient: [[0, 1], [0, 0]]"), "test.yaml:5: fluid.gradient: must be three rows"},
    {fluid("viscosity: 1, gradient: [[0, 1, 0], [0, 0, x], [0, 0, 0]]"),
     "test.yaml:5: fluid.gradient: must be three rows"},
    {fluid("viscosity: 1, gradient: [[0, 0, 0], [0, 0, 0], [0, 0, 0]]"),
     "test.yaml:5: fluid.gradient: must not be zero"},
    {fluid("viscosity: 1, rate: 1, gradient: [[0, 1, 0], [0, 0, 0], [0, 0, 0]]"),
     "test.yaml:5: fluid.rate: is of use only"},
    {fluid("viscosity: 1, gradient: [[1, 0, 0], [0, 0, 0], [0, 0, -0.5]]"),
     "test.yaml:5: fluid: gradient: a trace of 0.5"},
    {fluid("viscosity: 1, flow: shear, rate: 1, course: {start_up: 0 s}"),
     "test.yaml:5: fluid.course.start_up: '0 s'"},
    {fluid("viscosity: 1, flow: shear, rate: 1, course: {start_up: 1 s, oscillation: 1 s}"),
     "test.yaml:5: fluid.course: must have exactly one of start_up, oscillation"},
    {fluid("viscosity: 1, flow: shear, rate: 1, course: {start_up: 1 s, phase: 1}"),
     "test.yaml:5: fluid.course.phase: is of use only with oscillation"},
    {fluid("viscosity: 1, flow: shear, rate: 1, hydrodynamics: slender"),
     "test.yaml:5: fluid.hydrodynamics: 'slender' is not allowed; allowed: free_draining, interactions, "
     "stresslets"},
    {fluid("viscosity: 1, flow: shear, rate: 1, viscocity: 2"),
     "test.yaml:5: unknown key 'fluid.viscocity'; did you mean"},
    {start("direction: [0, 0, 0]"), "test.yaml:6: start.direction: must not be zero"},
    {start("bend: 0.01"), "test.yaml:6: start: key 'direction' is missing"},
    {start("direction: [0, 0, 1], bend: 0.01"), "test.yaml:6: start: key 'bend_direction' is missing"},
    {start("direction: [0, 0, 2], bend: 0.01, bend_direction: [0, 0, -1]"),
     "test.yaml:6: start.bend_direction: must not lie along the fiber"},
    {start("direction: [0, 0, 2], bend: 0.3, bend_direction: [0, 1, 0]"),
     "test.yaml:6: start.bend: '0.3' is out of range"},
    {motion("method: euler"),
     "test.yaml:7: motion.method: 'euler' is not allowed; allowed: inertialess, cvode, leapfrog"},
    {motion("method: cvode"), "test.yaml:5: fluid: hydrodynamics: interactions and stresslets are built for"},
    {motion("method: leapfrog"),
     "test.yaml:5: fluid: hydrodynamics: interactions and stresslets are built for"},
    {motion("method: leapfrog, tolerance: 1e-3"),
     "test.yaml:7: motion.tolerance: is of use only with method: inertialess"},
    {motion("method: cvode, step_ratio: 0.1"),
     "test.yaml:7: motion.step_ratio: is of use only with method: leapfrog"},
    {motion("method: inertialess, allow_unstable: true"),
     "test.yaml:7: motion.allow_unstable: is of use only with"},
    {motion("tolerance: 0"), "test.yaml:7: motion.tolerance: '0' is out of range"},
    {with("bond:", "bond: {form: incremental}"),
     "test.yaml:4: bond: form: incremental is built for method: leapfrog"},
    {with("bond:", "bond: {rolling_friction: 1}"), "test.yaml:4: unknown key 'bond.rolling_friction'"},
    {with("strain:", "strain: 0"), "test.yaml:8: strain: '0' is out of range"},
    {with("strain:", "strain: 1\nduration: 2 s"), "test.yaml:1: must have exactly one of duration, strain"},
    {with("samples:", "samples: 1"), "test.yaml:9: samples: '1' is not allowed"},
    {with("shapes:", "shapes: 0"), "test.yaml:10: shapes: '0' is not allowed"},
    {planar("viscosity: 1, gradient: [[0, 0, 1], [0, 0, 0], [0, 0, 0]]", "direction: [0, 1, 0]"),
     "test.yaml:5: fluid: gradient: a planar fiber needs 0 at xz"},
    {planar("viscosity: 1, flow: shear, rate: 1", "direction: [0, 1, 1]"),
     "test.yaml:6: start.direction: must lie in the x-y plane"},
    {planar("viscosity: 1, flow: shear, rate: 1",
            "direction: [0, 1, 0], bend: 0.1, bend_direction: [1, 0, 1]"),
     "test.yaml:6: start.bend_direction: must lie in the x-y plane"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_arrives) {
  const dem::FlowScene scene = parse(kScene);
  BOOST_TEST((scene.dimension == dem::Dimension::spatial));
  BOOST_TEST((scene.fiber.bond_model == dem::BondModel::corrected));
  BOOST_TEST(scene.fiber.bond_damping == 0.7);
  BOOST_CHECK_CLOSE_FRACTION(scene.fluid.viscosity, 0.25, 1e-15);
  BOOST_CHECK_CLOSE_FRACTION(scene.fluid.flow.gradient[0][1], -0.5, 1e-15);
  BOOST_TEST((scene.fluid.hydrodynamics == dem::Hydrodynamics::stresslets));
  BOOST_TEST(!scene.fluid.compressible);
  BOOST_TEST(scene.shear);
  BOOST_CHECK_CLOSE_FRACTION(scene.rate, 0.5, 1e-15);
  BOOST_CHECK_CLOSE_FRACTION(scene.start.direction[1], 0.8, 1e-15);
  BOOST_TEST(scene.start.bend == 0.01);
  BOOST_TEST(scene.start.s_bend == -0.002);
  // (1, 2, 2)/3 less its part along (3, 4, 0)/5, at unit length
  const double part = 11.0 / 15, length = std::sqrt(1 - part * part);
  BOOST_CHECK_CLOSE_FRACTION(scene.start.bend_direction[0], (1.0 / 3 - 0.6 * part) / length, 1e-13);
  BOOST_CHECK_CLOSE_FRACTION(scene.start.bend_direction[2], 2.0 / 3 / length, 1e-13);
  BOOST_TEST((scene.motion.method == dem::FlowMethod::inertialess));
  BOOST_TEST(scene.motion.tolerance == 1e-6);
  BOOST_CHECK_CLOSE_FRACTION(scene.duration, 15, 1e-14);
  BOOST_TEST(scene.samples == 60);
  BOOST_TEST(scene.shapes == 5);
}

BOOST_AUTO_TEST_CASE(flows_their_course_and_other_methods_arrive) {
  const dem::FlowScene rotating =
      parse(planar("viscosity: 1 Pa s, flow: rotation, rate: 2 1/s, course: {start_up: 3 s}",
                   "direction: [0, -2, 0], bend: 0.01"));
  BOOST_TEST(rotating.duration == 2);
  BOOST_TEST(!rotating.shear);
  BOOST_TEST(rotating.start.bend_direction[0] == 1);
  BOOST_CHECK_CLOSE_FRACTION(dem::gradient_at(rotating.fluid.flow, 1.5)[1][0], 2 * (1 - std::exp(-0.5)),
                             1e-12);
  const dem::FlowScene swinging = parse(
      fluid("viscosity: 1, flow: uniaxial_extension, rate: 2, course: {oscillation: 3 s, phase: 90 degree}"));
  BOOST_CHECK_CLOSE_FRACTION(dem::gradient_at(swinging.fluid.flow, 0.75)[2][2], 1, 1e-12);
  const dem::FlowScene swelling =
      parse(fluid("viscosity: 1, gradient: [[1, 2, 0], [0, 2, 0], [0, 0, -1]], compressible: true"));
  BOOST_TEST(swelling.fluid.compressible);
  BOOST_CHECK_CLOSE_FRACTION(swelling.rate, std::sqrt(10.0), 1e-15);
  std::string marched = fluid("viscosity: 1, flow: planar_extension, rate: 2");
  const auto at = marched.find("inertialess, tolerance: 1e-6");
  marched.replace(at, 28, "leapfrog, step_ratio: 0.1, allow_unstable: true");
  BOOST_TEST((parse(marched).motion.method == dem::FlowMethod::leapfrog));
  BOOST_TEST(parse(marched).motion.step_ratio.value() == 0.1);
  BOOST_TEST(parse(marched).motion.allow_unstable);
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_the_documented_default) {
  const dem::FlowScene scene = parse(
      "scene: flow\n"
      "fiber: {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 1 MPa, shear_modulus: 0.4 MPa, density: "
      "900}\n"
      "fluid: {viscosity: 1 Pa s, flow: shear, rate: 1 1/s}\n"
      "start: {direction: [0, 1, 0]}\n"
      "strain: 10\n");
  BOOST_TEST((scene.dimension == dem::Dimension::planar));
  BOOST_TEST((scene.fluid.hydrodynamics == dem::Hydrodynamics::free_draining));
  BOOST_TEST((scene.motion.method == dem::FlowMethod::inertialess));
  BOOST_TEST((scene.motion.form == dem::BondForm::total));
  BOOST_TEST(scene.motion.tolerance == 1e-8);
  BOOST_TEST(!scene.motion.step_ratio.has_value());
  BOOST_TEST(scene.start.bend == 0);
  BOOST_TEST(scene.samples == 500);
  BOOST_TEST(scene.shapes == 8);
}

BOOST_DATA_TEST_CASE(each_fault_is_named_with_file_line_and_key, boost::unit_test::data::make(kFaults),
                     fault) {
  std::string error = "no error";
  try {
    parse(fault.scene);
  } catch (const dem::SceneError& found) {
    error = found.what();
  }
  BOOST_TEST(error.starts_with(fault.says), error << " should begin with " << fault.says);
}

BOOST_AUTO_TEST_CASE(the_ready_scenes_are_read) {
  for (const char* name : {"flow-shear", "flow-flexible"}) {
    const std::string path = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/" + name + ".yaml";
    BOOST_CHECK_NO_THROW(dem::parse_scene(dem::read_scene_text(path)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
