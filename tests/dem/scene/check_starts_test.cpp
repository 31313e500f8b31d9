// Fibers of files that lie in walls or in each other are refused before a run begins.
#include <fmt/format.h>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>

#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/check_starts.hpp"
#include "dem/scene/fiber_csv.hpp"
#include "dem/scene/scene.hpp"
#include "tests/dem/extensions/sphere_wall.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(check_starts_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

constexpr double kRadius = 0.85e-3;

dem::PackingScene parse(const fiberchain::test::Scratch& scratch, const std::string& around,
                        const std::string& start) {
  std::ofstream(scratch.path / "two.csv") << "# far off\nx,y,z,ux,uy,uz\n0.02,0.02,0.03,0,0.6,0.8\n"
                                          << start << "\n";
  const std::string text =
      "scene: packing\nfibers:\n  - {diameter: 1.7 mm, aspect_ratio: 5, youngs_modulus: 2.6 MPa, "
      "poisson_ratio: 0.3, density: 1000, starts: two.csv}\n" +
      around + "\nsteps: 10\n";
  return std::get<dem::PackingScene>(dem::parse_scene({(scratch.path / "s.yaml").string(), text}));
}

/// What is said of the scene s.yaml with two fibers of 6 spheres from two.csv, of which the second starts at
/// each of `starts`; "none" where it is right; `clear` is right. A file is read once: what is said is the
/// same of its values.
std::vector<std::string> said(const std::string& around, const std::vector<std::string>& starts,
                              const std::string& clear) {
  const fiberchain::test::Scratch scratch;
  dem::PackingScene scene = parse(scratch, around, clear);
  std::vector<std::string> all;
  for (const std::string& start : starts) {
    std::istringstream text("x,y,z,ux,uy,uz\n" + start + "\n");
    scene.kinds[0].starts[1] = dem::read_fiber_starts(text, "two.csv").front();
    try {
      dem::check_starts(scene);
      all.emplace_back("none");
    } catch (const dem::InvalidInput& error) {
      all.emplace_back(error.what());
    }
  }
  return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A wall, the point of it that the second fiber's third sphere is near, the way from there to the fibers'
/// side, and the fiber's direction, along the wall.
struct Place {
  const char* name;
  std::string walls;
  V at, inward, along;
  const char* wall;
};
std::ostream& operator<<(std::ostream& out, const Place& place) { return out << place.name; }

const Place kPlaces[] = {
    {"floor",
     "planes: [{point: [0, 0, 0], normal: [0, 0, 1]}]",
     {0.02, 0.01, 0},
     {0, 0, 1},
     {1, 0, 0},
     "wall 1"},
    {"askew",
     "planes: [{point: [1 cm, 0, 0], normal: [3, 0, 4]}]",
     {0.01, 0.01, 0},
     {0.6, 0, 0.8},
     {0.8, 0, -0.6},
     "wall 1"},
    {"moving",
     "planes: [{point: [0, 0, 5 cm], normal: [0, 0, -1], velocity: [0, 0, -1 m/s]}]",
     {0.02, 0.01, 0.05},
     {0, 0, -1},
     {0, 1, 0},
     "wall 1"},
    {"side of the box",
     "box: {x: 5 cm, y: 5 cm, z: 5 cm}",
     {0.02, 0.05, 0.02},
     {0, -1, 0},
     {1, 0, 0},
     "wall 4"},
    {"tube",
     "cylinders: [{point: [2 cm, 2 cm, 0], axis: [0, 0, 1], radius: 15 mm}]",
     {0.035, 0.02, 0.01},
     {-1, 0, 0},
     {0, 0, 1},
     "wall 1"},
    {"end of a tube",
     "planes: [{point: [0, 0, 0], normal: [0, 0, 1]}], cylinders: [{point: [2 cm, 2 cm, 0], "
     "axis: [0, 0, 2], radius: 15 mm}]",
     {0.02, 0.01, 0},
     {0, 0, 1},
     {0, 1, 0},
     "wall 1"},
};

/// CSV line of the fiber whose spheres lie so deep in the wall, over their radius.
std::string start_in(const Place& place, double deep) {
  const V third = place.at + kRadius * (1 - deep) * place.inward, first = third - 4 * kRadius * place.along;
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", first[0], first[1], first[2],
                     place.along[0], place.along[1], place.along[2]);
}

}  // namespace

BOOST_DATA_TEST_CASE(half_a_radius_in_a_wall_is_too_deep, boost::unit_test::data::make(kPlaces), place) {
  std::vector<std::string> starts;
  const std::vector<double> depths = {-0.3, 0.0, 0.2, 0.49, 0.5, 0.51, 0.9, 1.3};
  for (const double deep : depths) starts.push_back(start_in(place, deep));
  const std::vector<std::string> messages =
      said("walls: {" + place.walls + "}", starts, start_in(place, -0.4));
  for (std::size_t n = 0; n < depths.size(); ++n) {
    if (depths[n] < 0.495) {
      BOOST_TEST(messages[n] == "none", depths[n]);
      continue;
    }
    BOOST_TEST(has(messages[n], "two.csv:4: sphere 0 of fiber 1 is not allowed there: "), messages[n]);
    BOOST_TEST(has(messages[n], place.wall), messages[n]);
  }
}

BOOST_AUTO_TEST_CASE(files_of_scene_and_starts_are_named_with_their_lines) {
  const fiberchain::test::Scratch scratch;
  BOOST_CHECK_EXCEPTION(parse(scratch, "walls: {" + kPlaces[0].walls + "}", start_in(kPlaces[0], 0.5)),
                        dem::SceneError, [](const dem::SceneError& error) {
                          return has(error.what(), "s.yaml:2: fibers: ") && has(error.what(), "two.csv:4: ");
                        });
}

BOOST_AUTO_TEST_CASE(a_wall_that_comes_later_is_not_looked_at) {
  const std::string line = start_in(kPlaces[0], 0.9);
  const auto floor = [&](const std::string& when) {
    return said("walls: {planes: [{point: [0, 0, 0], normal: [0, 0, 1], " + when + "}]}", {line},
                start_in(kPlaces[0], -0.4))
        .front();
  };
  BOOST_TEST(floor("from: 1 s") == "none");
  BOOST_TEST(floor("until: 1 s") != "none");
}

BOOST_AUTO_TEST_CASE(half_a_radius_in_another_fiber_is_too_deep) {
  const auto above = [](double deep) {  // the first fiber's first sphere
    return fmt::format("0.02,0.02,{:.17g},1,0,0", 0.03 - kRadius * (2 - deep));
  };
  for (const std::string& message : said("", {above(0), above(0.3), above(0.49)}, above(-1)))
    BOOST_TEST(message == "none");
  for (const std::string& message : said("", {above(0.5), above(0.6), above(1.5)}, above(-1))) {
    BOOST_TEST(has(message, "two.csv:4: sphere 0 of fiber 1 is not allowed there: it lies in another one"),
               message);
  }
  // through a periodic side
  BOOST_TEST(said("periodic: {z: 4 cm}", {"0.02,0.02,-0.0099,1,0,0"}, above(-1)).front() != "none");
}

/// Shapes from outside of the library, scenes that no file describes.
BOOST_AUTO_TEST_CASE(walls_of_any_shape_are_looked_at_and_random_fibers_keep_clear_of_them) {
  dem::PackingScene scene{
      .kinds = {{.fiber = {dem::isotropic_material(2.6e6, 0.3, 1000), 2 * kRadius, 5}, .starts = {{}}}}};
  scene.domain.walls.push_back({extensions::SphereWall{{0, 0, 0}, 0.02}});
  scene.steps = 10;
  const auto start_at = [&](double deep) {
    scene.kinds[0].starts[0] = {{0, 0, 0.02 + kRadius * (1 - deep)}, {0, 0, 1}};
  };
  start_at(0.45);
  BOOST_CHECK_NO_THROW(dem::check_starts(scene));
  start_at(0.5);
  BOOST_CHECK_THROW(dem::check_starts(scene), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::packing_start(scene, 1), dem::InvalidInput);
  scene.kinds[0].starts.clear();
  scene.kinds[0].count = 200;
  scene.filling.region = {{-0.04, -0.04, 0.0}, {0.04, 0.04, 0.04}};
  const std::vector<dem::FiberGroup> placed = dem::packing_batch(scene, 0, 0, {});
  for (const auto& fiber : placed.at(0).fibers) {
    for (const auto& pose : fiber.poses) BOOST_TEST(norm(pose.position) >= 0.02 + kRadius);
  }
}

BOOST_AUTO_TEST_SUITE_END()
