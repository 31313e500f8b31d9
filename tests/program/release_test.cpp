#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(release_test)

using namespace fiberchain::test;
using nlohmann::json;

namespace {

std::string scene(const std::string& time, const std::string& bond = "damping: 1") {
  return "scene: release\n"
         "fiber: {diameter: 2 mm, aspect_ratio: 10, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: "
         "1000 kg/m^3}\n"
         "bond: {" +
         bond +
         "}\n"
         "load: {reduced: 0.05}\n"
         "periods: 12\n"
         "time: {" +
         time + "}\n";
}

}  // namespace

// xi_f and frequency of the linear chain's first mode, whatever follows it in time.
BOOST_AUTO_TEST_CASE(every_integrator_gives_the_damping_of_the_linear_chain) {
  for (const char* time : {"integrator: auto", "integrator: leapfrog", "integrator: leapfrog-damped",
                           "integrator: leapfrog-stiff", "integrator: implicit", "integrator: cvode"}) {
    const Scratch scratch;
    scratch.file("s.yaml", scene(time));
    const Outcome outcome = run({"run", "s.yaml", "--json"}, {.directory = scratch.path});
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
    const json row = json::parse(outcome.out)["rows"][0];
    BOOST_TEST_CONTEXT(time) {
      BOOST_TEST(std::abs(row["fiber_damping"].get<double>() / row["fiber_damping_modes"].get<double>() - 1) <
                 1e-3);
      BOOST_TEST(row["steps"].get<double>() > 0);
    }
  }
}

// A stiff wire in which the higher modes live long: its damping is the first mode's, or none.
BOOST_AUTO_TEST_CASE(damping_is_the_first_modes_or_missing_with_the_reason) {
  const auto row_of = [](const std::string& periods, const std::string& bond) {
    const Scratch scratch;
    scratch.file("s.yaml",
                 "scene: release\n"
                 "fiber: {diameter: 1.1 mm, aspect_ratio: 17, youngs_modulus: 52 GPa, poisson_ratio: 0.31, "
                 "density: 8.4 g/cm^3}\n"
                 "bond: {" +
                     bond +
                     "}\n"
                     "load: {force: 30 mN}\n"
                     "periods: " +
                     periods +
                     "\n"
                     "time: {integrator: auto, error: 1e-3}\n");
    const Outcome outcome = run({"run", "s.yaml", "--json"}, {.directory = scratch.path});
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
    return json::parse(outcome.out)["rows"][0];
  };
  for (const std::string bond : {"damping: 0.002", "damping: 0.4", "damping: 20"}) {
    const json row = row_of("16", bond);
    BOOST_TEST(
        std::abs(row["fiber_damping"].get<double>() / row["fiber_damping_modes"].get<double>() - 1) < 3e-4,
        bond);
  }
  const json brief = row_of("3", "damping: 0.4"), undamped = row_of("12", "damping: 0");
  BOOST_TEST(brief["fiber_damping"].is_null());
  BOOST_TEST(brief["status"].get<std::string>().find(
                 "no fiber_damping: the first mode is seen alone in 12.7 periods") != std::string::npos,
             brief["status"].dump());
  BOOST_TEST(undamped["fiber_damping"].is_null());
  BOOST_TEST(std::abs(undamped["frequency"].get<double>() /
                          row_of("12", "damping: 0.002")["frequency"].get<double>() -
                      1) < 1e-3);
  BOOST_TEST(undamped["status"].get<std::string>().find("no fiber_damping: nothing damps the fiber") !=
                 std::string::npos,
             undamped["status"].dump());
}

BOOST_AUTO_TEST_CASE(a_run_that_blows_up_fails_and_keeps_what_was_good) {
  const Scratch scratch;
  scratch.file("s.yaml", scene("integrator: leapfrog, step_ratio: 0.25, allow_unstable: true"));
  const Outcome outcome = run({"run", "s.yaml"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(outcome.error.find("the run blew up: fiber 0, sphere ") != std::string::npos, outcome.error);
  BOOST_TEST(outcome.error.find("the step is beyond the stable one") != std::string::npos, outcome.error);
  BOOST_TEST(content(scratch.path / "results/s-history.csv").find("\n0,") != std::string::npos);
  const std::string last = content(scratch.path / "results/s-last.csv");  // 11 spheres, all of them somewhere
  BOOST_TEST(last.find("\n10,") != std::string::npos);
  BOOST_TEST(last.find("nan") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_not_the_one_asked_for_is_said) {
  const auto row_of = [](const std::string& time, const std::string& bond = "damping: 1") {
    const Scratch scratch;
    scratch.file("s.yaml", scene(time, bond));
    const Outcome outcome = run({"run", "s.yaml", "--json"}, {.directory = scratch.path});
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
    return json::parse(outcome.out)["rows"][0];
  };
  const json coarse = row_of("integrator: implicit, step_ratio: 6");
  BOOST_TEST(coarse["step_ratio_asked"] == 6);
  BOOST_TEST(coarse["step_ratio"].get<double>() < 5.9);
  BOOST_TEST(coarse["status"].get<std::string>().starts_with("finished; steps of "), coarse["status"].dump());
  BOOST_TEST(coarse["status"].get<std::string>().find(" t_b in the mean in place of 6: ") !=
             std::string::npos);
  for (const char* time : {"integrator: implicit", "integrator: leapfrog", "integrator: cvode"}) {
    const json plain = row_of(time);
    BOOST_TEST(plain["status"] == "finished");
    BOOST_TEST(plain["step_ratio_asked"].is_null());
  }
}

BOOST_AUTO_TEST_CASE(a_step_of_next_to_nothing_is_refused) {
  const Scratch scratch;
  scratch.file("s.yaml", scene("integrator: leapfrog, step_ratio: 1e-300"));
  const Outcome outcome = run({"run", "s.yaml"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.error.find("s.yaml:6: time.step_ratio: '1e-300' is out of range") != std::string::npos,
             outcome.error);
}

BOOST_AUTO_TEST_CASE(an_unstable_step_is_refused_with_the_limit) {
  const Scratch scratch;
  scratch.file("s.yaml", scene("integrator: leapfrog, step_ratio: 0.25"));
  const Outcome outcome = run({"run", "s.yaml"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.error.find("largest stable step of this chain is 0.2176 t_b") != std::string::npos,
             outcome.error);
  BOOST_TEST(!std::filesystem::exists(scratch.path / "results/s.csv"));
}

BOOST_AUTO_TEST_SUITE_END()
