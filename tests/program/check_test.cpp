#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(check_test)

using namespace fiberchain::test;
using nlohmann::json;

namespace {

const std::string kScenes = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/";

json row_of(const std::string& scene) {
  const Scratch scratch;
  const Outcome outcome = run({"check", scene, "--json", "--jobs", "1"}, {.directory = scratch.path});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(files_under(scratch.path) == 0);
  return json::parse(outcome.out)["rows"][0];
}

const char* const kAll[] = {
    "cantilever",      "cantilever-march", "cantilever-spatial",  "release",
    "release-rolling", "release-steel",    "flow-shear",          "flow-flexible",
    "packing",         "packing-small",    "crossed-layers",      "compression",
    "uniaxial-press",  "pull-out",         "three-point-bending", "three-point-bending-bundle",
    "spaghetti"};

}  // namespace

BOOST_DATA_TEST_CASE(every_ready_scene_is_sized, boost::unit_test::data::make(kAll), name) {
  const json row = row_of(kScenes + name + ".yaml");
  BOOST_TEST(row["bonds"].get<int>() == row["spheres"].get<int>() - row["fibers"].get<int>());
  BOOST_TEST(row["memory"].get<double>() > 0);
  BOOST_TEST(row["memory"].get<double>() < row["memory_free"].get<double>());
}

BOOST_AUTO_TEST_CASE(a_packing_is_told_its_steps_time_and_files) {
  const json row = row_of(kScenes + "packing-small.yaml");
  BOOST_TEST(row["scene_kind"] == "packing");
  BOOST_TEST((row["fibers"] == 200 && row["spheres"] == 4200));
  const double step = row["time_step"].get<double>(), steps = row["steps"].get<double>();
  BOOST_TEST(std::abs(steps * step - 0.1) <= step);
  BOOST_TEST(row["step_from"].get<std::string>().find("bond damping") != std::string::npos);
  const double cost = row["step_cost"].get<double>();
  BOOST_TEST((cost > 1e-10 && cost < 1e-4));
  BOOST_TEST(row["expected_time"].get<double>() == cost * steps * 4200, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((row["trajectory_size"].get<double>() > 0 && row["checkpoint_size"].get<double>() > 0));
}

/// Two kinds of fibers that fall 50 mm, with the speed that this gives, upon a rigid floor; contacts of this
/// modulus.
std::string softened(const std::string& modulus) {
  return "scene: packing\n"
         "fibers:\n"
         "  - {diameter: 0.2 mm, aspect_ratio: 6, youngs_modulus: 70 GPa, poisson_ratio: 0.22, density: "
         "2450, "
         "count: 4}\n"
         "  - {diameter: 0.3 mm, aspect_ratio: 6, youngs_modulus: 200 GPa, poisson_ratio: 0.22, density: "
         "7850, count: 4}\n"
         "filling: {region: {z: [1 mm, 50 mm]}}\n"
         "walls: {box: {x: 9 mm, y: 9 mm, lid: open}}\n"
         "gravity: [0, 0, -9.81]\n"
         "contacts: {youngs_modulus: " +
         modulus + "}\nduration: 0.3 s\n";
}

BOOST_AUTO_TEST_CASE(a_packing_is_told_how_deep_impacts_of_its_contacts_are) {
  const Scratch scratch;
  const std::string name = scratch.file("s.yaml", softened("10 MPa")).string();
  const json row = row_of(name);
  const double v = row["impact_speed"].get<double>();
  BOOST_TEST(v == std::sqrt(2 * 9.81 * 0.05), boost::test_tools::tolerance(0.01));
  // Hertz: two of the heavier spheres are pressed in most, delta^(5/2) = 15/16 m* v^2 / (E* sqrt(R*))
  const double R = 0.15e-3, m = 4.0 / 3 * std::acos(-1.0) * R * R * R * 7850, E = 10e6 / (1 - 0.22 * 0.22);
  const double overlap = std::pow(15.0 / 16 * (m / 2) * v * v / (E / 2 * std::sqrt(R / 2)), 0.4) / R;
  BOOST_TEST(row["impact_overlap"].get<double>() == overlap, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(overlap > 0.1);
  const Outcome warned = run({"check", name, "--jobs", "1"});
  BOOST_TEST(warned.error.find(" of the smaller radius; warning: beyond 0.1 ") != std::string::npos,
             warned.error);
  const std::string stiff = scratch.file("t.yaml", softened("70 GPa")).string();
  BOOST_TEST(run({"check", stiff, "--jobs", "1"}).error == "");
}

// The run says what the check has said.
BOOST_AUTO_TEST_CASE(a_release_takes_the_steps_it_was_told) {
  const Scratch scratch;
  const json told = row_of(kScenes + "release-rolling.yaml");
  const Outcome outcome =
      run({"run", kScenes + "release-rolling.yaml", "--json"}, {.directory = scratch.path});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const json taken = json::parse(outcome.out)["rows"][0];
  BOOST_TEST(told["steps"].get<double>() == taken["steps"].get<double>());
  BOOST_TEST(told["time_step"].get<double>() == taken["time_step"].get<double>(),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(no_fiber_is_inserted) {
  const Scratch scratch;
  std::string text = content(kScenes + "packing-small.yaml");
  const auto at = text.find("count: 200");
  BOOST_REQUIRE(at != std::string::npos);
  const auto scene =
      scratch.file("s.yaml", text.replace(at, 10, "count: 9000000"));  // far more than the box holds
  const Outcome outcome = run({"check", scene.string(), "--jobs", "1"});
  BOOST_TEST(outcome.status == 0, outcome.error);
  BOOST_TEST(outcome.out.find("fibers           9000000\n") != std::string::npos, outcome.out);
}

BOOST_AUTO_TEST_CASE(wrong_scenes_are_refused_as_by_a_run) {
  const Scratch scratch;
  const auto scene = scratch.file("s.yaml", "scene: packing\nfibres: 3\n");
  const Outcome checked = run({"check", scene.string()}),
                ran = run({"run", scene.string()}, {.directory = scratch.path});
  BOOST_TEST(checked.status == 2);
  BOOST_TEST(is_one_error(checked.error));
  BOOST_TEST(checked.error == ran.error);
  BOOST_TEST(checked.out == "");
  BOOST_TEST(run({"check"}).status == 2);
  BOOST_TEST(run({"check", "--keys", scene.string()}).status == 2);
}

BOOST_AUTO_TEST_CASE(keys_are_those_of_the_page) {
  const Outcome keys = run({"check", "--keys"});
  BOOST_TEST(keys.status == 0);
  BOOST_TEST(content(kScenes + "README.md").find(keys.out) != std::string::npos);
  BOOST_TEST(keys.out.find("| `fibers[].diameter` | m | at least 1e-12 and at most 1e+09 | required |") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
