// Scenes of rods: what is read and run, and what is refused where.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/run/run_fiber.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(rod_scene_test)

namespace dem = fiberchain::dem;

namespace {

const std::string kRod =
    "scene: rod\ndimension: planar\nfiber: {diameter: 1.3 mm, aspect_ratio: 12, youngs_modulus: 3.1 MPa, "
    "poisson_ratio: 0.17, density: 1370}\nbond: {model: corrected}\n";
const std::string kHinges = "supports: [{sphere: first, turn: xy}, {sphere: last, place: yz, turn: xy}]\n";

dem::RodScene parse_rod(const std::string& text) {
  return std::get<dem::RodScene>(dem::parse_scene({"rod.yaml", text}));
}

std::string refused(const std::string& text) {
  try {
    parse_rod(text);
    return "taken";
  } catch (const dem::SceneError& error) {
    return error.what();
  }
}

void check_said(const std::string& text, const std::string& part) {
  const std::string said = refused(text);
  BOOST_TEST(said.find(part) != std::string::npos, said);
}

}  // namespace

BOOST_AUTO_TEST_CASE(keys_are_the_problem) {
  const dem::RodScene scene = parse_rod(
      kRod +
      "shape: {corner: 5, turn: {axis: [0, 0, 1], angle: 90 degree}}\n"
      "supports: [{sphere: 0, rotate: [0, 0, 0.3]}, {sphere: 12, place: y, turn: xy, move: [0, 2 mm, 0]}]\n"
      "loads: [{sphere: 7, reduced_force: [2, 0, 0], steady: true}, {sphere: last, moment: [0, 0, 1e-6]}]\n"
      "line_loads: [{spheres: 5..12, force: [0, 1e-3, 0], direction: following}]\n"
      "line_load_rule: lumped\ngravity: [0, -9.81, 0]\n"
      "path: {control: load, points: 7, end_factor: 2, probe: {sphere: 6, direction: [3, 4, 0]}}\n");
  const dem::RodProblem& problem = scene.problem;
  BOOST_TEST(problem.planar);
  BOOST_TEST(problem.chain.poses[5].position[1] == 5 * 0.0013, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(problem.chain.poses[12].position[0] == -7 * 0.0013, boost::test_tools::tolerance(1e-12));
  BOOST_REQUIRE(problem.supports.size() == 2u);
  BOOST_TEST(problem.supports[0].turned[2] == 0.3);
  BOOST_TEST((problem.supports[1].hold_displacement == std::array<bool, 3>{false, true, false}));
  BOOST_TEST(problem.supports[1].moved[1] == 0.002);
  BOOST_TEST(problem.point_loads[0].force[0] == 2 * dem::load_force(scene.fiber, 1));
  BOOST_TEST(problem.point_loads[0].steady);
  BOOST_TEST(problem.line_loads[0].first == 5);
  BOOST_TEST((problem.line_loads[0].direction == dem::LoadDirection::following));
  BOOST_TEST((problem.line_load_rule == dem::LineLoads::lumped));
  BOOST_TEST((scene.path.control == dem::RodControl::load));
  BOOST_TEST(scene.path.probe.sphere == 6);
  BOOST_TEST(scene.path.probe.direction[1] == 0.8, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_branch_is_followed_and_missed_where_there_is_none) {
  const std::string column = kRod + kHinges + "path: {control: load, points: 5}\nbranch: {bifurcation: 1}\n";
  const dem::RodScene loaded = parse_rod(column + "loads: [{sphere: last, reduced_force: [-12, 0, 0]}]\n");
  const dem::RodResult run = dem::run_scene(loaded);
  BOOST_REQUIRE(run.branch.has_value());
  BOOST_TEST(run.branch->points.back().factor == 1.0);
  BOOST_TEST(run.branch->points.back().probe > -1);
  BOOST_TEST(std::abs(run.path.singular.at(0).point.factor * 12 - 9.87) < 0.1);
  const dem::RodScene light = parse_rod(column + "loads: [{sphere: last, reduced_force: [-7, 0, 0]}]\n");
  BOOST_CHECK_THROW(dem::run_scene(light), dem::NoConvergence);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_at_its_key) {
  check_said(kRod, "key 'supports' is missing");
  check_said(kRod + "supports: [{sphere: 13}]\n", "sphere: '13' is not allowed");
  check_said(kRod + "supports: [{sphere: first, turn: xy}]\n", "supports are not enough");
  check_said(kRod + "supports: [{sphere: first, place: none, turn: none}]\n", "holds nothing");
  check_said(kRod + "supports: [{sphere: first}, {sphere: 0, turn: xy}]\n", "two supports at sphere 0");
  check_said(kRod + "supports: [{sphere: first, turn: xy, rotate: [0, 0, 1]}]\n",
             "all its turns must be held");
  check_said(kRod + kHinges + "loads: [{sphere: last, force: [0, 0, 1]}]\n", "a force along z at sphere 12");
  check_said(kRod + kHinges + "loads: [{sphere: last}]\n", "needs force or moment");
  check_said(kRod + kHinges + "line_loads: [{spheres: 4..4, force: [0, 1, 0]}]\n", "N < M");
  check_said(kRod + kHinges + "path: {control: displacement}\n", "end_displacement");
  check_said(kRod + kHinges + "path: {end_factor: 0}\n", "rod.yaml:6: path.end_factor: must not be 0");
  check_said(kRod + "shape: {points: [{at: [0, 0, 0]}, {at: [2 mm, 0, 0]}]}\n" + kHinges, "whole number");
  check_said(kRod + "shape: {corner: 12}\n" + kHinges, "corner = 12 is not allowed");
  check_said(kRod + "shape: {arc: 1, corner: 2}\n" + kHinges, "shape");
}

BOOST_AUTO_TEST_SUITE_END()
