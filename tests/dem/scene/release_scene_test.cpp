#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(release_scene_test)

namespace dem = fiberchain::dem;

namespace {

const std::string kScene = R"(scene: release
dimension: spatial
fiber: {diameter: 3 mm, aspect_ratio: 13, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1.2 g/cm^3}
bond: {model: corrected, form: total, damping: 0.7}
load: {reduced: 1.25, direction: [0, 3, 4]}
periods: 7.5
time: {integrator: leapfrog-damped, step_ratio: 0.11, allow_unstable: true, samples_per_period: 60}
)";

dem::ReleaseScene parse(const std::string& text) {
  return std::get<dem::ReleaseScene>(dem::parse_scene({"test.yaml", text}));
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = kScene;
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// With another section "time".
std::string timed(const std::string& time) {
  return kScene.substr(0, kScene.find("time:")) + "time: {" + time + "}\n";
}

struct Fault {
  std::string scene;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.says; }

const Fault kFaults[] = {
    {timed("integrator: leapfrogs"), "test.yaml:7: time.integrator: 'leapfrogs'"},
    {timed("integrator: auto, step_ratio: 0.1"),
     "test.yaml:7: time.step_ratio: is of use only with integrator: leapfrog"},
    {timed("integrator: cvode, tolerance: 0"), "test.yaml:7: time.tolerance: '0' is out of range"},
    {timed("integrator: implicit, tolerance: 1e-3"),
     "test.yaml:7: time.tolerance: is of use only with integrator: cvode"},
    {timed("integrator: leapfrog, error: 1e-3"),
     "test.yaml:7: time.error: is of use only with integrator: auto"},
    {timed("integrator: cvode, allow_unstable: true"),
     "test.yaml:7: time.allow_unstable: is of use only with"},
    {timed("integrator: leapfrog, samples_per_period: 3"),
     "test.yaml:7: time.samples_per_period: '3' is not allowed"},
    {with("periods: 7.5", "periods: 0"), "test.yaml:6: periods: '0' is out of range"},
    {with("reduced: 1.25", "reduced: 0"), "test.yaml:5: load: must not be zero"},
    {with("[0, 3, 4]", "[0, 0, 4]"), "test.yaml:5: load: needs a direction with a part along y"},
    {with("damping: 0.7", "rolling: set_valued"),
     "test.yaml:4: bond.rolling: is of use only with rolling_friction"},
    {with("damping: 0.7", "rolling_friction: -1"),
     "test.yaml:4: bond.rolling_friction: '-1' is out of range"},
    {with("damping: 0.7", "rolling_friction: 1"),
     "test.yaml:7: time: rolling friction is built for integrator: leapfrog"},
    {kScene.substr(0, kScene.find("bond:")) +
         "bond: {form: incremental}\nload: {reduced: 1}\ntime: {integrator: cvode}\n",
     "test.yaml:4: bond: form: incremental is built for the leapfrogs"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_arrives) {
  const dem::ReleaseScene scene = parse(kScene);
  BOOST_TEST((scene.dimension == dem::Dimension::spatial));
  BOOST_TEST((scene.fiber.bond_model == dem::BondModel::corrected));
  BOOST_TEST(scene.fiber.bond_damping == 0.7);
  BOOST_TEST(scene.pull.load == 1.25);
  BOOST_CHECK_CLOSE_FRACTION(scene.pull.direction[2], 0.8, 1e-15);
  BOOST_TEST(scene.periods == 7.5);
  BOOST_TEST((scene.motion.form == dem::BondForm::total));
  BOOST_TEST((scene.motion.integrator == dem::Integrator::leapfrog_damped));
  BOOST_TEST(scene.motion.step_ratio.value() == 0.11);
  BOOST_TEST(scene.motion.allow_unstable);
  BOOST_TEST(scene.motion.samples_per_period == 60);
  BOOST_TEST(parse(timed("integrator: cvode, tolerance: 1e-4")).motion.tolerance == 1e-4);
  BOOST_TEST(parse(timed("integrator: auto, error: 2e-4")).motion.error == 2e-4);
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_the_documented_default) {
  const dem::ReleaseScene scene = parse(
      "scene: release\n"
      "fiber: {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 1 MPa, shear_modulus: 0.4 MPa, density: "
      "900}\n"
      "bond: {damping: 1, rolling_friction: 0.5}\n"
      "load: {reduced: 0.5}\n");
  BOOST_TEST((scene.dimension == dem::Dimension::planar));
  BOOST_TEST((scene.motion.integrator == dem::Integrator::automatic));
  BOOST_TEST((scene.motion.form == dem::BondForm::incremental));
  BOOST_TEST((scene.motion.rolling == dem::Rolling::set_valued));
  BOOST_TEST(scene.fiber.rolling_friction == 0.5);
  BOOST_TEST(scene.periods == 10);
  BOOST_TEST(scene.motion.error == 1e-3);
  BOOST_TEST(!scene.motion.step_ratio.has_value());
  BOOST_TEST(!scene.motion.allow_unstable);
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
  for (const char* name : {"release", "release-rolling"}) {
    const std::string path = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/" + name + ".yaml";
    BOOST_CHECK_NO_THROW(dem::parse_scene(dem::read_scene_text(path)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
