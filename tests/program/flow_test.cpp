#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(flow_test)

using namespace fiberchain::test;
using nlohmann::json;

namespace {

std::string scene(const std::string& fluid, const std::string& start, const std::string& rest) {
  return "scene: flow\n"
         "dimension: spatial\n"
         "fiber: {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: "
         "1000 kg/m^3}\n"
         "fluid: {viscosity: 2 Pa s, " +
         fluid +
         "}\n"
         "start: {direction: " +
         start + "}\n" + rest + "\n";
}

Outcome run_scene(const Scratch& scratch, const std::string& text,
                  const std::vector<std::string>& more = {"--json"}) {
  scratch.file("s.yaml", text);
  std::vector<std::string> arguments{"run", "s.yaml"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments, {.directory = scratch.path});
}

json document_of(const std::string& text) {
  const Scratch scratch;
  const Outcome outcome = run_scene(scratch, text);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  return json::parse(outcome.out);
}

}  // namespace

// N = 7: r_e = 5.
BOOST_AUTO_TEST_CASE(a_stiff_fiber_keeps_jefferys_period_and_orbit) {
  const double exact = 2 * std::acos(-1.0) * (5 + 0.2);
  const json document =
      document_of(scene("flow: shear, rate: 0.1 1/s", "[0, 1, 2]", "strain: 40\nsamples: 800"));
  const json row = document["rows"][0];
  BOOST_TEST(std::abs(row["period"].get<double>() / exact - 1) < 1e-5);
  BOOST_TEST(std::abs(row["orbit_constant"].get<double>() - 1.0 / 3) < 1e-9);  // C = 1/2
  BOOST_TEST(std::abs(row["orbit_constant_last"].get<double>() - 1.0 / 3) < 1e-5);
  BOOST_TEST(row["status"] == "finished");
  BOOST_TEST(document["history"].size() == 801u);
  BOOST_TEST(document["shapes"].size() == 7u * 9);
}

// The fluid turns with half the vorticity: a whole turn in 2 pi/rate; the mirrored shear turns it the other
// way at the same pace.
BOOST_AUTO_TEST_CASE(rotation_and_mirrored_shear) {
  const double pi = std::acos(-1.0);
  const json turned =
      document_of(scene("flow: rotation, rate: 0.2 1/s", "[1, 2, 0.5]", "strain: 8"))["rows"][0];
  BOOST_TEST(std::abs(turned["period"].get<double>() - 2 * pi) < 1e-4);
  BOOST_TEST(turned["orbit_constant"].is_null());
  const json mirrored =
      document_of(scene("flow: shear, rate: -0.1 1/s", "[0, 1, 0]", "strain: 40"))["rows"][0];
  BOOST_TEST(std::abs(mirrored["period"].get<double>() / (10.4 * pi) - 1) < 1e-4);
}

BOOST_AUTO_TEST_CASE(every_method_follows_the_same_fiber) {
  std::vector<double> last;
  for (const char* method : {"inertialess", "cvode", "leapfrog"}) {
    const json document = document_of(scene("flow: shear, rate: 5 1/s", "[0, 1, 1]",
                                            std::string("strain: 4\nmotion: {method: ") + method + "}"));
    BOOST_TEST(document["rows"][0]["flow_method"] == method);
    last.push_back(document["history"].back()["direction_x"].get<double>());
  }
  BOOST_TEST(std::abs(last[1] - last[2]) < 1e-5);  // both with the same inertia, Stokes number 6e-4
  BOOST_TEST(std::abs(last[0] - last[2]) < 1e-3);
  BOOST_TEST(std::abs(last[0] - last[2]) > 1e-6);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const Scratch scratch;
  const Outcome unstable = run_scene(
      scratch,
      scene("flow: shear, rate: 5 1/s", "[0, 1, 1]", "strain: 1\nmotion: {method: leapfrog, step_ratio: 3}"),
      {});
  BOOST_TEST(unstable.status == 2);
  BOOST_TEST(unstable.error.find("step_ratio = 3 is not allowed") != std::string::npos, unstable.error);
  const Outcome swelling =
      run_scene(scratch, scene("gradient: [[1, 0, 0], [0, 0, 0], [0, 0, 0]]", "[0, 1, 1]", "strain: 1"), {});
  BOOST_TEST(swelling.status == 2);
  BOOST_TEST(is_one_error(swelling.error), swelling.error);
  BOOST_TEST(swelling.error.find("s.yaml:4: fluid: gradient: a trace of 1 1/s") != std::string::npos,
             swelling.error);
  BOOST_TEST(!std::filesystem::exists(scratch.path / "results/s.csv"));
}

BOOST_AUTO_TEST_CASE(the_table_of_periods_has_what_was_asked) {
  const Outcome outcome = run({"tables", "shear", "--spheres", "7", "--interacting", "5", "--json"});
  BOOST_REQUIRE_EQUAL(outcome.status, 0);
  const json rows = json::parse(outcome.out)["rows"];
  BOOST_REQUIRE_EQUAL(rows.size(), 2u);
  BOOST_TEST(std::abs(rows[0]["period"].get<double>() - 10.4 * std::acos(-1.0)) < 1e-4);
  BOOST_TEST(std::abs(rows[1]["period"].get<double>() - 28.77) < 0.005);
  BOOST_TEST(rows[1]["hydrodynamics"] == "interactions");
}

BOOST_AUTO_TEST_SUITE_END()
