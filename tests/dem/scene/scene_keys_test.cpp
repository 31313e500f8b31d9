#include "dem/scene/scene_keys.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "dem/scene/scene.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(scene_keys_test)

namespace dem = fiberchain::dem;

namespace {

const std::string kPacking = R"(scene: packing
fibers:
  - {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1000, count: 11}
filling: {region: {z: [1 mm, 50 mm]}, seed: 3}
walls: {box: {x: 24 mm, y: 22 mm, lid: open}}
gravity: [0, 0, -9.81]
contacts: {friction: 0.3}
duration: 20 ms
output: {samples: 10}
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kPacking;
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

dem::SceneKeys keys(const std::string& text) { return dem::scene_keys({"s.yaml", text}); }

/// "path: after, was before" of what differs in physics.
std::vector<std::string> differences(const std::string& text) {
  std::vector<std::string> words;
  for (const auto& change : dem::physical(dem::changes_between(keys(kPacking), keys(text))))
    words.push_back(dem::in_words(change));
  return words;
}

void check(const std::string& text, const std::vector<std::string>& says) {
  const std::vector<std::string> found = differences(text);
  BOOST_CHECK_EQUAL_COLLECTIONS(found.begin(), found.end(), says.begin(), says.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(how_a_scene_says_it_does_not_matter) {
  check(with("scene: packing\n", "# a comment\nscene: packing   # another\n"), {});
  check(with("diameter: 2 mm", "diameter: 0.002"), {});
  check(with("youngs_modulus: 2.6 MPa", "youngs_modulus: 2600 kPa"), {});
  check(with("z: [1 mm, 50 mm]", "z: [0.001, 5 cm]"), {});
  check(with("count: 11", "mass: spheres, count: 11"), {});  // the default
  check(with("contacts: {friction: 0.3}", "contacts:\n  friction: 3e-1"), {});
  check(with("contacts: {", "contacts: {rolling_friction: 0, "), {});
  check(with("gravity: [0, 0, -9.81]\n", "") + "gravity: [0, 0, -9.81]\n", {});
  check(with("seed: 3", "seed: 3, batches: {number: 1, interval: 1}"),
        {"filling.batches.number: 1, was not given", "filling.batches.interval: 1, was not given",
         "filling.batches.no_room: end, was not given", "filling.batches: not given, was all at the start"});
}

BOOST_AUTO_TEST_CASE(output_and_duration_are_no_physics) {
  check(with("duration: 20 ms", "duration: 30 ms"), {});
  check(with("duration: 20 ms", "steps: 123"), {});
  check(with("output: {samples: 10}", "output: {samples: 11, frames: 0, vtk: true}"), {});
  check(with("output: {samples: 10}", "output: {samples: 10, energy: true}"),
        {"output.energy: true, was false"});
}

BOOST_AUTO_TEST_CASE(what_differs_is_named) {
  check(with("friction: 0.3", "friction: 0.31"), {"contacts.friction: 0.31, was 0.3"});
  check(with("diameter: 2 mm", "diameter: 2.1 mm"), {"fibers[0].diameter: 0.0021000000000000003, was 0.002"});
  check(with("seed: 3", "seed: 4"), {"filling.seed: 4, was 3"});
  check(with("gravity: [0, 0, -9.81]", "gravity: [0, 1, -9.81]"),
        {"gravity: [0, 1, -9.81], was [0, 0, -9.81]"});
}

BOOST_AUTO_TEST_CASE(files_count_by_their_content) {
  const fiberchain::test::Scratch scratch;
  const auto write = [&](const char* name, const std::string& lines) {
    std::ofstream(scratch.path / name) << "x,y,z,ux,uy,uz\n" << lines;
  };
  const auto of = [&](const std::string& file) {
    return dem::scene_keys({(scratch.path / "s.yaml").string(), with("count: 11", "starts: " + file)});
  };
  write("a.csv", "0.01,0.01,0.02,1,0,0\n");
  write("b.csv", "0.01,0.01,0.02,1,0,0\n");
  write("c.csv", "0.01,0.01,0.03,1,0,0\n");
  BOOST_TEST((of("a.csv") == of("b.csv")));
  const auto changes = dem::changes_between(of("a.csv"), of("c.csv"));
  BOOST_REQUIRE_EQUAL(changes.size(), 1u);
  BOOST_TEST(changes[0].path == "fibers[0].starts");
}

BOOST_AUTO_TEST_CASE(materials_count_by_their_content) {
  const fiberchain::test::Scratch scratch;
  const auto of = [&](const std::string& modulus) {
    std::ofstream(scratch.path / "m.yaml")
        << "name: m\ndescription: of a test\nyoungs_modulus: {value: " << modulus << ", source: own}\n";
    return dem::scene_keys(
        {(scratch.path / "s.yaml").string(), with("count: 11", "count: 11, material: m.yaml")});
  };
  const dem::SceneKeys before = of("1 GPa");
  BOOST_TEST((before == of("1 GPa")));
  const auto changes = dem::changes_between(before, of("2 GPa"));
  BOOST_REQUIRE_EQUAL(changes.size(), 1u);
  BOOST_TEST(changes[0].path == "fibers[0].material");
}

BOOST_AUTO_TEST_CASE(they_come_back_from_text) {
  const dem::SceneKeys all = keys(kPacking);
  BOOST_TEST(all.size() > 40);
  BOOST_TEST((dem::scene_keys_in(dem::to_text(all)) == all));
  BOOST_TEST(dem::value_in(all, "fibers[0].youngs_modulus").value() == "2600000");
  BOOST_TEST(dem::value_in(all, "contacts.restitution").value() == "1");
  BOOST_TEST(!dem::value_in(all, "contacts.restitutio").has_value());
}

BOOST_AUTO_TEST_CASE(settings_take_the_place_of_the_text) {
  const auto set = [](const std::string& key, const std::string& value) {
    return std::get<dem::PackingScene>(dem::parse_scene({"s.yaml", kPacking, {{key, value}}}));
  };
  BOOST_TEST(set("contacts.friction", "0.45").domain.contacts.friction == 0.45);
  BOOST_TEST(set("fibers[0].youngs_modulus", "3 MPa").kinds[0].fiber.material.youngs_modulus == 3e6);
  BOOST_TEST(set("gravity", "[1, 0, 2 m/s^2]").domain.gravity[2] == 2);
  BOOST_TEST(set("motion.restitution_error", "0.02").restitution_error ==
             0.02);  // a mapping that was not there
  BOOST_TEST(set("filling.region.z", "[2 mm, 60 mm]").filling.region.high[2] == 0.06);
  const dem::SceneText scene{"s.yaml", kPacking, {{"filling.seed", "9"}}};
  check(with("seed: 3", "seed: 9"), {"filling.seed: 9, was 3"});
  BOOST_TEST((dem::scene_keys(scene) == keys(with("seed: 3", "seed: 9"))));
}

BOOST_AUTO_TEST_CASE(settings_that_cannot_be_say_why) {
  const std::pair<dem::SceneSetting, const char*> faults[] = {
      {{"contacts.frictoin", "0.4"}, "unknown key 'contacts.frictoin'; did you mean 'friction'?"},
      {{"contact.friction", "0.4"}, "unknown key 'contact'; did you mean 'contacts'?"},
      {{"fibers.count", "4"}, "'fibers' is a list of 1: say of which, as fibers[0]"},
      {{"fibers[1].count", "4"}, "'fibers' has 1 entries, from [0] on"},
      {{"fibers[x].count", "4"}, "is no entry of a list, such as fibers[0]"},
      {{"fibers[0]", "4"}, "'fibers' is a list: set a key of an entry"},
      {{"gravity[0]", "4"}, "'gravity' is no list"},
      {{"gravity.x", "4"}, "'gravity' is no mapping there"},
      {{"scene", "flow"}, "the kind of the scene stays as it is"},
      {{"contacts.friction", ""}, "has no value"},
      {{"contacts.friction", "[1"}, "is no YAML"},
      {{"contacts.friction", "-1"}, "contacts.friction: '-1' is out of range; allowed: a number at least 0"},
      {{"", "1"}, "unknown key ''"},
  };
  for (const auto& [setting, says] : faults) {
    BOOST_CHECK_EXCEPTION(dem::parse_scene({"s.yaml", kPacking, {setting}}), dem::SceneError,
                          [&](const dem::SceneError& error) {
                            const std::string message = error.what();
                            BOOST_TEST_MESSAGE(message);
                            return message.find(says) != std::string::npos && message.starts_with("s.yaml:");
                          });
  }
}

BOOST_AUTO_TEST_CASE(start_from_is_short_for_a_mapping) {
  const auto start = [](const std::string& typed) {
    return *std::get<dem::PackingScene>(
                dem::parse_scene({"here/s.yaml", kPacking + "start_from: " + typed + "\n"}))
                .start_from;
  };
  BOOST_TEST(start("fill.checkpoint").path == "here/fill.checkpoint");
  BOOST_TEST(!start("fill.checkpoint").is_trajectory());
  const dem::StartFile frame = start("{file: /a/fill.h5, frame: 3, clock: zero}");
  BOOST_TEST(frame.path == "/a/fill.h5");
  BOOST_TEST(frame.frame.value() == 3);
  BOOST_TEST((frame.clock == dem::StartClock::zero && frame.is_trajectory()));
  for (const char* wrong :
       {"{file: a.h5, frame: -1}", "{file: a.h5, frame: x}", "{file: a.checkpoint, frame: 1}", "{frame: 1}",
        "{file: a.h5, clock: now}", "[1, 2]", "{file: a.h5, time: 0}"}) {
    BOOST_CHECK_THROW(start(wrong), dem::SceneError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
