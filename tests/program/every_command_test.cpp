#define BOOST_TEST_MODULE every_command_test
#include <boost/test/unit_test.hpp>

#include <fmt/format.h>

#include <cmath>

#include "tests/program/packings.hpp"

// Every command once, on the smallest case that goes through all of it: what the sanitizers look at in CI,
// where all program tests would take too long. What the commands answer is tested elsewhere.
BOOST_AUTO_TEST_SUITE(every_command_test)

using namespace fiberchain::test;

namespace {

using Words = std::vector<std::string>;

void check_fine(const Outcome& outcome, const Words& arguments, int status = 0) {
  std::string command;
  for (const std::string& word : arguments) command += word + " ";
  BOOST_TEST(outcome.status == status, command << outcome.status << "\n" << outcome.error);
  for (const char* complaint : {"Sanitizer", "runtime error"})
    BOOST_TEST(outcome.error.find(complaint) == std::string::npos, command << "\n" << outcome.error);
}

const char* const kFiber =
    "fiber: {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 3 MPa, poisson_ratio: 0.17, density: 1100 "
    "kg/m^3}\n";

}  // namespace

BOOST_AUTO_TEST_CASE(scenes_of_one_fiber) {
  const Scratch scratch;
  scratch.file("cantilever.yaml", std::string("scene: cantilever\ndimension: spatial\n") + kFiber +
                                      "load: {reduced: 3, direction: [0.1, 1, 0.3]}\n");
  scratch.file("march.yaml",
               std::string("scene: cantilever\nmethod: march\n") + kFiber + "load: {reduced: 3}\n");
  for (const std::string way : {"leapfrog", "leapfrog-damped", "leapfrog-stiff", "implicit", "cvode"})
    scratch.file(way + ".yaml",
                 std::string("scene: release\n") + kFiber +
                     "bond: {damping: 1}\nload: {reduced: 1}\nperiods: 3\ntime: {integrator: " + way + "}\n");
  scratch.file("flow.yaml", std::string("scene: flow\ndimension: spatial\n") + kFiber +
                                "fluid: {viscosity: 1 Pa s, flow: shear, rate: 0.01 1/s, hydrodynamics: "
                                "interactions}\n"
                                "start: {direction: [0, 1, 1]}\nstrain: 0.5\nsamples: 10\n");
  scratch.file("rod.yaml",
               std::string("scene: rod\ndimension: spatial\n") + kFiber +
                   "shape: {arc: 1}\nsupports: [{sphere: first}]\nloads: [{sphere: last, reduced_force: "
                   "[0, 1, 2], direction: following}]\npath: {points: 4}\n");
  for (const std::string name : {"rod", "cantilever", "march", "leapfrog", "leapfrog-damped",
                                 "leapfrog-stiff", "implicit", "cvode", "flow"}) {
    for (const std::string command : {"check", "run"}) {
      const Words words = {command, name + ".yaml"};
      check_fine(run(words, {.directory = scratch.path}), words);
    }
  }
}

BOOST_AUTO_TEST_CASE(scenes_of_the_project_are_read) {
  const std::filesystem::path scenes = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes";
  for (const auto& file : std::filesystem::directory_iterator(scenes)) {
    if (file.path().extension() != ".yaml") continue;
    const Words words = {"check", file.path().string()};
    check_fine(run(words), words);
  }
  for (const Words& words : {Words{"check", "--keys"}, Words{"columns"}, Words{"--help"}, Words{"--version"}})
    check_fine(run(words), words);
}

BOOST_AUTO_TEST_CASE(a_packing_stops_goes_on_and_is_drawn) {
  const FewFibers fibers(400);
  Started first(fibers.arguments(), fibers.here());
  wait_until([&] { return std::filesystem::exists(fibers.out("s.checkpoint")); });
  first.send(SIGTERM);
  check_fine(first.finish(), {"stopped"}, 128 + SIGTERM);
  check_fine(fibers.go({"--resume"}), {"resumed"});
  check_fine(fibers.go({"--resume"}), {"resumed at its end"});
  const Words draw = {"render", "out/s.h5", "--width", "160", "--height", "100"};
  check_fine(run(draw, fibers.here()), draw);
  const Words dump = {"export", "out/s.h5", "--frames", "last"};
  check_fine(run(dump, fibers.here()), dump);
  const Words two = {"run", "s.yaml", "--out", "two", "--jobs", "2"};
  check_fine(run(two, fibers.here()), two);
}

BOOST_AUTO_TEST_CASE(studies_of_few_cases) {
  const Scratch scratch;
  std::string record = "t,y\n";
  for (int i = 0; i < 200; ++i) record += fmt::format("{},{}\n", i, std::exp(-0.01 * i) * std::cos(0.6 * i));
  scratch.file("ring.csv", record);
  for (const Words& words :
       {Words{"tables", "static", "--aspect-ratio", "5", "--load", "1", "--method", "solve,march"},
        {"tables", "damping", "--aspect-ratio", "5", "--peaks", "0..2", "--bond-damping", "3"},
        {"tables", "friction", "--aspect-ratio", "5", "--peaks", "1..2", "--rolling-friction", "1"},
        {"tables", "contact", "--test", "2"},
        {"tables", "materials", "--aspect-ratio", "7", "--diameters", "3", "--fibers", "150", "--duration",
         "2e-4"},
        {"tables", "shear", "--spheres", "5"},
        {"tables", "contact-modulus", "--fibers", "150", "--seeds", "1", "--modulus", "1,0.1", "--duration",
         "2e-4", "--samples", "20"},
        {"tables", "press", "--fibers", "20", "--aspect-ratio", "5", "--seeds", "2", "--speed", "2",
         "--samples", "40"},
        {"tables", "spacing", "--aspect-ratio", "13", "--spacing", "1,2.6", "--load", "1"},
        {"tables", "rod-packing", "--aspect-ratio", "2", "--fibers", "60", "--seeds", "1", "--looks", "4"},
        {"tables", "rods", "--benchmark", "bend,column-hinged", "--aspect-ratio", "10", "--no-figures"},
        {"tables", "capstan", "--surface", "smooth", "--friction", "0.1", "--turning", "0.5", "--drum", "9"},
        {"stability", "--aspect-ratio", "5", "--poisson-ratio", "0.2", "--bond-damping", "0.5"},
        {"fit", "--aspect-ratio", "5..7", "--held-out", "none", "--no-figures"},
        {"materials"},
        {"calibrate", "--material", "carbon-steel", "--diameter", "20 um", "--aspect-ratio", "7"},
        {"calibrate", "--damping-ratio", "0.02", "--aspect-ratio", "7", "--verify"},
        {"identify", "ring.csv", "--diameter", "1 mm", "--aspect-ratio", "9", "--density", "900"},
        {"validate", "--part", "beams"},
        {"report", "--from", "results"},
        {"report", "--no-run"}}) {
    check_fine(run(words, {.directory = scratch.path}), words);
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_said) {
  const Scratch scratch;
  scratch.file("key.yaml", std::string("scene: cantilever\nlaod: 1\n") + kFiber);
  scratch.file("not.yaml", "a: [1, {");
  scratch.file("empty.yaml", "");
  for (const Words& words : {Words{"run", "key.yaml"},
                             {"run", "not.yaml"},
                             {"check", "empty.yaml"},
                             {"run", "none.yaml"},
                             {"render", "key.yaml"},
                             {"tables", "statc"},
                             {"calbrate"},
                             {"report", "--from", "none"},
                             {"fit", "--aspect-ratio", "x"}})
    check_fine(run(words, {.directory = scratch.path}), words, 2);
}

BOOST_AUTO_TEST_SUITE_END()
