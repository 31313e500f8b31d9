// Keys of walls: shapes, how they move, courses from files, what is refused.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "dem/mesh/mesh_shape.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/wall_course_csv.hpp"

BOOST_AUTO_TEST_SUITE(wall_scene_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

dem::PackingScene scene_with(const std::string& walls, const std::string& more = "") {
  return std::get<dem::PackingScene>(dem::parse_scene(
      {"s.yaml",
       "scene: packing\nfibers:\n  - {diameter: 2 mm, aspect_ratio: 3, youngs_modulus: 2.6 MPa, "
       "poisson_ratio: 0.17, density: 1130, count: 4}\n"
       "filling: {region: {x: [0, 30 mm], y: [0, 30 mm], z: [0, 30 mm]}" +
           more + "}\ncontacts: {restitution: 0.5}\nsteps: 10\nwalls:\n" + walls}));
}

std::string refusal(const std::string& walls, const std::string& more = "") {
  try {
    scene_with(walls, more);
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "";
}

void refuses(const std::string& walls, const std::string& words, const std::string& more = "") {
  const std::string said = refusal(walls, more);
  BOOST_TEST(said.find(words) != std::string::npos, walls << " says: " << said);
}

std::string course_refusal(const std::string& text) {
  std::istringstream lines(text);
  try {
    dem::read_wall_course(lines, "c.csv");
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(shapes_and_motions_are_read) {
  const dem::PackingScene scene = scene_with(
      "  cylinders: [{point: [0, 0, 0], axis: [0, 0, 2], radius: 5 mm, fibers: outside}]\n"
      "  spheres: [{center: [15 mm, 15 mm, 15 mm], radius: 40 mm, rotation: {point: [0, 0, 1 mm], axis: [0, "
      "3, 0], "
      "angular_velocity: 30 rpm}}]\n"
      "  obstacles: [{center: [0, 0, -9 mm], sides: [2 mm, 4 mm, 6 mm], along: [1, 1, 0], across: [0, 1, "
      "0],\n"
      "    oscillation: {axis: [0, 0, 1], amplitude: 1 mm, frequency: 20, ramp: 0.1 s}}]\n"
      "  cones: [{point: [0, 0, -20 mm], axis: [0, 0, -1], length: 3 mm, radius: 4 mm, end_radius: 0, "
      "thickness: 1 mm,\n"
      "    drive: {axis: [0, 0, 1], mass: 0.1, pressure: 20 kPa, area: 2 cm^2, damping: 3}}]\n");
  const auto& walls = scene.domain.walls;
  BOOST_REQUIRE(walls.size() == 4u);
  BOOST_TEST(walls[0].shape.get_if<dem::Cylinder>()->side == -1);
  BOOST_TEST(walls[1].shape.get_if<dem::Sphere>()->side == 1);
  BOOST_TEST(std::abs(walls[1].motion.angular_velocity - std::numbers::pi) < 1e-12);
  BOOST_TEST(walls[1].motion.about->axis[1] == 1);
  const auto* box = walls[2].shape.get_if<dem::BoxObstacle>();
  BOOST_TEST(box->half[2] == 3e-3);
  BOOST_TEST(std::abs(dot(box->along, box->across)) < 1e-15);
  BOOST_TEST(std::abs(walls[2].motion.oscillation->phase - 0.5 * std::numbers::pi) < 1e-15);
  BOOST_TEST(walls[3].shape.get_if<dem::Cone>()->half == 0.5e-3);
  BOOST_TEST(std::abs(walls[3].motion.drive->force - 4) < 1e-12);
}

BOOST_AUTO_TEST_CASE(meshes_are_read) {
  const std::string hopper = FIBERCHAIN_SOURCE_DIR "/data/meshes/hopper.stl";
  const dem::PackingScene scene = scene_with(
      "  meshes: [{file: " + hopper +
      ", scale: 1 mm, place: [15 mm, 15 mm, -0.2], turn: {axis: [0, 0, 1], "
      "angle: 90 degrees},\n    rotation: {point: [0, 0, 0], axis: [0, 0, 1], angular_velocity: 2}}]\n");
  const dem::Wall& wall = scene.domain.walls.back();
  const dem::MeshShape* shape = mesh_in(wall);
  BOOST_REQUIRE(shape != nullptr);
  BOOST_TEST((shape->sides == dem::MeshSides::both));
  BOOST_TEST(shape->mesh->faces() == 192);
  BOOST_TEST(wall.motion.angular_velocity == 2.0);
  // the first corner of the file, 25 mm along x
  const dem::TriangleMesh& mesh = *shape->mesh;
  const V corner = shape->point + shape->to_space(mesh.vertices[mesh.triangles[0][0]]);
  BOOST_TEST(norm(corner - V{15e-3, 40e-3, -0.08}) < 1e-12);
  BOOST_TEST(std::abs(gap_to(wall, {15e-3, 15e-3, -0.1}, 0) - 25e-3 * std::cos(std::numbers::pi / 32)) <
             1e-8);
}

BOOST_AUTO_TEST_CASE(bad_meshes_are_refused_with_their_key) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "fiberchain-bad.obj";
  const auto with = [&](const std::string& text) { std::ofstream(file) << text; };
  const std::string mesh = "  meshes: [{file: " + file.string();
  with("");
  refuses(mesh + "}]\n", "file: " + file.string() + ": is empty");
  refuses("  meshes: [{file: nothing.stl}]\n", "nothing.stl: cannot be read: ");
  refuses("  meshes: [{scale: 1 mm}]\n", "file");
  refuses(mesh + ", scale: 0}]\n", "scale");
  refuses(mesh + ", sides: three}]\n", "sides");
  refuses(mesh + ", twist: 3}]\n", "twist");
  refuses(mesh + ", turn: {axis: [0, 0, 0], angle: 1}}]\n", "axis");
  with("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 3 1 4\n");
  refuses(mesh + ", sides: one, place: [0, 0, -1]}]\n", "sides: one is not allowed: triangles 1 and 2 of");
  BOOST_TEST(refusal(mesh + ", place: [0, 0, -1]}]\n") == "");
  with("v 0 0 0\nv 9 0 0\nv 9 9 0\nf 1 2 3\n");
  refuses(mesh + ", scale: 1e6}]\n", "scale: ");
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(a_pressure_acts_on_the_cross_section_of_the_room) {
  const std::string plate =
      "  planes: [{point: [0, 0, 35 mm], normal: [0, 0, -1], drive: {axis: [0, 0, -1], mass: 1 g, pressure: "
      "3 kPa";
  const auto force = [&](const std::string& walls) {
    return scene_with(walls).domain.walls.back().motion.drive->force;
  };
  const std::string box = "  box: {x: 40 mm, y: 31 mm, lid: open}\n";
  BOOST_TEST(std::abs(force(box + plate + "}}]\n") - 3e3 * 0.04 * 0.031) < 1e-12);
  BOOST_TEST(std::abs(force(box + plate + ", area: 2 cm^2}}]\n") - 0.6) < 1e-12);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_with_its_key) {
  refuses("  spheres: [{center: [0, 0, 0], radius: 0.9 mm}]\n", "narrower than the fibers");
  refuses("  cylinders: [{point: [0, 0, 0], axis: [0, 0, 1], radius: 9 mm, fibers: beside}]\n", "fibers");
  refuses("  obstacles: [{center: [0, 0, 0], sides: [1 mm, 0, 1 mm]}]\n", "above 0");
  refuses("  obstacles: [{center: [0, 0, 0], sides: [1 mm, 1 mm, 1 mm], along: [0, 1, 0]}]\n",
          "another direction");
  refuses("  cones: [{point: [0, 0, 0], axis: [0, 0, 1], length: 0, radius: 1 mm, end_radius: 1 mm}]\n",
          "length");
  refuses("  cones: [{point: [0, 0, 0], axis: [0, 0, 1], length: 1 mm, radius: 0, end_radius: 0}]\n",
          "end_radius");
  const std::string plane = "  planes: [{point: [0, 0, -1 mm], normal: [0, 0, 1], ";
  refuses(plane + "rotation: {point: [0, 0, 0], axis: [0, 0, 0], angular_velocity: 1}}]\n", "axis");
  refuses(plane + "rotation: {point: [0, 0, 0], axis: [0, 0, 1]}}]\n", "angular_velocity");
  refuses(plane + "oscillation: {axis: [0, 0, 1], amplitude: -1 mm, frequency: 3}}]\n", "amplitude");
  refuses(plane + "course: {file: nowhere.csv, direction: [0, 0, 1]}}]\n", "nowhere.csv");
  refuses(plane + "drive: {axis: [0, 0, 1], mass: 1, force: 1, pressure: 1, area: 1}}]\n", "pressure");
  refuses(plane + "drive: {axis: [0, 0, 1], mass: 1, pressure: 1}}]\n",
          "planes[0].drive.pressure: needs area");
  refuses("  box: {x: 40 mm, y: 30 mm, lid: open}\n" + plane +
              "drive: {axis: [0, 1, 1], mass: 1, pressure: 1}}]\n",
          "needs area");
  refuses(plane + "drive: {axis: [0, 0, 1], mass: 0, force: 1}}]\n", "mass");
  refuses(plane + "swing: 3}]\n", "swing");
}

BOOST_AUTO_TEST_CASE(courses_are_read_strictly) {
  std::istringstream good("# a comment\nangle, time\n0,0\n1.5,0.1\n1,0.3\n");
  const dem::WallCourse course = dem::read_wall_course(good, "c.csv");
  BOOST_TEST(course.angle.at(0.1) == 1.5);
  BOOST_TEST(course.place.at(0.1) == 0);
  const std::pair<const char*, const char*> wrong[] = {{"", "no line"},
                                                       {"time\n0\n1\n", "missing"},
                                                       {"place\n0\n1\n", "'time' is missing"},
                                                       {"time,place,speed\n0,0,0\n", "unknown"},
                                                       {"time,place,place\n0,0,0\n", "twice"},
                                                       {"time,place\n0,0\n", "fewer than two"},
                                                       {"time,place\n0,0\n0,1\n", "c.csv:3"},
                                                       {"time,place\n0,0\n1,nan\n", "nan"},
                                                       {"time,place\n0,0\n1,1e300\n", "1e300"},
                                                       {"time,place\n0,0\n1\n", "fields"}};
  for (const auto& [text, words] : wrong)
    BOOST_TEST(course_refusal(text).find(words) != std::string::npos,
               text << " says: " << course_refusal(text));
}

BOOST_AUTO_TEST_SUITE_END()
