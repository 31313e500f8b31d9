#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(bad_input_test)

using namespace fiberchain::test;

namespace {

const std::string kScene =
    "scene: cantilever\n"
    "fiber: {diameter: 2 mm, aspect_ratio: 10, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000 "
    "kg/m^3}\n"
    "load: {reduced: 1}\n";

const std::string kRelease = "scene: release\n" + kScene.substr(kScene.find('\n') + 1);

const std::string kPacking =
    "scene: packing\n"
    "fibers: [{diameter: 2 mm, aspect_ratio: 5, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000, "
    "count: 3}]\n"
    "filling: {region: {x: [0, 3 cm], y: [0, 3 cm], z: [0, 3 cm]}}\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kScene;
  return text.replace(text.find(from), from.size(), to);
}

/// Deterministic bytes without pattern.
std::string noise(std::size_t size) {
  std::string bytes;
  bytes.reserve(size);
  for (std::uint64_t state = 276; bytes.size() < size;
       state = state * 6364136223846793005u + 1442695040888963407u) {
    bytes += static_cast<char>(state >> 56);
  }
  return bytes;
}

struct Fault {
  const char* name;
  std::string scene;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

const Fault kFaults[] = {
    {"tab", with("load: {reduced: 1}", "load:\n\treduced: 1"), ":4: is indented with a tab"},
    {"angle as a number", with("poisson_ratio: 0.3", "poisson_ratio: 17 degrees"), "poisson_ratio"},
    {"wrong key", with("diameter", "diametre"),
     "s.yaml:2: unknown key 'fiber.diametre'; did you mean 'diameter'?"},
    {"wrong unit", with("2 mm", "2 MPa"),
     "s.yaml:2: fiber.diameter: '2 MPa' has a unit of another dimension"},
    {"negative value", with("2.6 MPa", "-2.6 MPa"),
     "s.yaml:2: fiber.youngs_modulus: '-2.6 MPa' is out of range"},
    {"zero", with("1000 kg/m^3", "0 kg/m^3"), "s.yaml:2: fiber.density: '0 kg/m^3' is out of range"},
    {"infinite", with("2 mm", ".inf"), "s.yaml:2: fiber.diameter: '.inf' is out of range"},
    {"no number", with("reduced: 1", "reduced: nan"), "s.yaml:3: load.reduced: 'nan' is out of range"},
    {"a step that would be negative", kRelease + "time: {error: 1e-300}\n",
     "s.yaml:4: time.error: '1e-300' is out of range; allowed: a number at least 1e-09 and below 1"},
    {"density without end", with("1000 kg/m^3", "1e300 kg/m^3"),
     "s.yaml:2: fiber.density: '1e300 kg/m^3' is out of"},
    {"modulus without end", with("2.6 MPa", "1e300"),
     "s.yaml:2: fiber.youngs_modulus: '1e300' is out of range"},
    {"load without end", with("reduced: 1", "reduced: 1e300"),
     "s.yaml:3: load.reduced: '1e300' is out of range"},
    {"load that tears", with("reduced: 1", "reduced: 1601"),
     "s.yaml:3: load.reduced: 1601 is not allowed: it stretches the fiber to more than twice its length; "
     "allowed: at "
     "most 1600"},
    {"damping without end", kRelease + "bond: {damping: 1e300}\n",
     "s.yaml:4: bond.damping: '1e300' is out of range"},
    {"step beyond the stable one", kScene + "method: march\nmarch: {step_ratio: 5}\n",
     "s.yaml:5: march.step_ratio: step_ratio = 5 is not allowed: "},
    {"the same of a release", kRelease + "time: {integrator: leapfrog, step_ratio: 5}\n",
     "s.yaml:4: time.step_ratio: step_ratio = 5 is not allowed: "},
    {"gravity without end", kPacking + "gravity: [0, 0, -1e30]\nsteps: 10\n",
     "s.yaml:4: gravity: '-1e30' is out of range"},
    {"rolling friction without end", kPacking + "contacts: {rolling_friction: 1e30}\nsteps: 10\n",
     "s.yaml:4: contacts.rolling_friction: '1e30' is out of range"},
    {"stiff beyond any run", kPacking + "duration: 1e9 s\nwalls: {youngs_modulus: 1e18}\n",
     "s.yaml:4: duration"},
    {"empty file", "", "s.yaml: holds no scene: it is empty"},
    {"10 MB of noise", noise(10'000'000), "s.yaml: is no scene: more than 262144 bytes"},
    {"noise of a scene's size", noise(5000), "s.yaml:1: "},
};

struct Usage {
  std::vector<std::string> arguments;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Usage& usage) { return out << usage.says; }

const Usage kUsages[] = {
    {{}, "give a command: columns, run"},
    {{"tables"}, "give a command of 'tables': static, damping, friction"},
    {{"nonsense"}, "unknown command 'nonsense': allowed: "},
    {{"run", "x.yaml", "--jobs", "1", "--threads", "1"}, "--jobs,--threads: given twice; give it once"},
    {{"columns", "--nonsense"}, "unknown option '--nonsense' of 'columns'"},
    {{"calbrate", "--aspect-ratio", "10"}, "unknown command 'calbrate': did you mean 'calibrate'?"},
    {{"calibrate", "--aspect-ration", "10"},
     "unknown option '--aspect-ration' of 'calibrate': did you mean '--aspect-ratio'?"},
    {{"tables", "statc"}, "unknown command 'tables statc': did you mean 'static'?"},
    {{"calibrate", "--damping-ratio", "0.02", "--aspect-ratio", "9", "--youngs-modulus", "2e6"},
     "--density, --diameter missing"},
    {{"calibrate", "--damping-ratio", "0.02", "--aspect-ratio", "9", "--dashpots", "retardation_time"},
     "--youngs-modulus, --density, --diameter missing"},
    {{"run"}, "SCENE is required"},
    {{"run", "a.yaml", "b.yaml"}, "not expected: b.yaml"},
    {{"run", "missing.yaml"}, "missing.yaml: cannot read this scene: No such file or directory"},
    {{"run", "/"}, "cannot read this scene: Is a directory"},
    {{"tables", "static", "--load", "1", "--load", "2"}, "--load"},
    {{"tables", "static", "--load", "five"}, "--load: 'five' is no number"},
    {{"tables", "static", "--load", "0"}, "--load: '0' is out of range"},
    {{"tables", "static", "--aspect-ratio", "0"}, "--aspect-ratio: '0' is out of range"},
    {{"tables", "static", "--aspect-ratio", "9.5"}, "--aspect-ratio: '9.5' wants whole numbers"},
    {{"tables", "static", "--poisson-ratio", "0.6"}, "--poisson-ratio: '0.6' is out of range"},
    {{"tables", "static", "--bond", "glue"}, "--bond: 'glue' is not among paper, corrected"},
    {{"tables", "static", "--method", "guess"}, "--method: 'guess' is not among solve, march"},
    {{"tables", "static", "--form", "incremental"}, "--form incremental is not allowed with --method solve"},
    {{"tables", "static", "--jobs", "0"}, "--jobs: '0' is out of range"},
    {{"tables", "static", "--jobs", "1,2"}, "--jobs: '1,2' is no single number"},
    {{"tables", "friction", "--rolling-friction=-1"}, "--rolling-friction: '-1' is out of range"},
    {{"tables", "friction", "--law", "none"}, "--law: 'none' is not among set_valued, explicit_sign"},
    {{"tables", "friction", "--step", "0.3"}, "step_ratio = 0.3 is not allowed"},
    {{"tables", "friction", "--peaks", "4"}, "--peaks: '4' is not allowed"},
    {{"tables", "friction", "--load", "1", "--amplitude", "0.1"}, "--amplitude is not allowed with --load"},
    {{"tables", "shear", "--spheres", "1"}, "--spheres: '1' is out of range"},
    {{"tables", "shear", "--stresslets", "2.5"}, "--stresslets: '2.5' wants whole numbers"},
    {{"tables", "shear", "--part", "guess"},
     "--part: 'guess' is not among period, orbits, stiffness, regimes, buckling"},
    {{"tables", "shear", "--part", "period", "--spheres", "5"}, "--part is not allowed with --spheres"},
    {{"stability", "--scheme", "implicit"}, "--scheme: 'implicit' is not among leapfrog, leapfrog-damped"},
    {{"stability", "--bond-damping=-1"}, "--bond-damping: '-1' is out of range"},
    {{"stability", "--aspect-ratio", "0"}, "--aspect-ratio: '0' is out of range"},
    {{"bench", "--case", "guess"}, "--case: 'guess' is not among static, damping, history, skips, kernels"},
    {{"bench", "--aspect-ratio", "1"}, "--aspect-ratio: '1' is out of range"},
    {{"bench", "--aspect-ratio", "9.5"}, "--aspect-ratio: '9.5' wants whole numbers"},
    {{"validate", "--data", "/nonexistent"}, "no directory 'published'"},
    {{"validate", "--part", "static,pages"}, "pages"},
};

/// Arguments that would succeed, with results in `out`.
std::vector<std::string> good_run(const Scratch& scratch, const std::filesystem::path& out) {
  return {"run", scratch.file("s.yaml", kScene).string(), "--out", out.string()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_scene_the_faults_are_planted_in_is_good) {
  const Scratch scratch;
  const Outcome outcome = run(good_run(scratch, scratch.path / "results"));
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(content(scratch.path / "results/s.csv").find("tip_y") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_byte_order_mark_is_no_fault) {
  const Scratch scratch;
  const auto scene = scratch.file("s.yaml", "\xEF\xBB\xBF" + kScene);
  BOOST_TEST(run({"run", scene.string(), "--out", (scratch.path / "results").string()}).status == 0);
}

BOOST_DATA_TEST_CASE(a_bad_scene_is_one_error_and_overwrites_nothing, boost::unit_test::data::make(kFaults),
                     fault) {
  const Scratch scratch;
  const auto scene = scratch.file("s.yaml", fault.scene);
  scratch.file("results/s.csv", "old results");
  const Outcome outcome = run({"run", scene.string(), "--out", (scratch.path / "results").string()});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.out == "");
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
  BOOST_TEST(outcome.error.find(fault.says) != std::string::npos, outcome.error);
  BOOST_TEST(content(scratch.path / "results/s.csv") == "old results");
  BOOST_TEST(files_under(scratch.path) == 2);
}

BOOST_DATA_TEST_CASE(bad_usage_is_one_error_and_makes_no_file, boost::unit_test::data::make(kUsages), usage) {
  const Scratch scratch;
  const Outcome outcome = run(usage.arguments, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.out == "");
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
  BOOST_TEST(outcome.error.find(usage.says) != std::string::npos, outcome.error);
  BOOST_TEST(files_under(scratch.path) == 0);
}

// Neither place can be written to by anyone, root included.
BOOST_AUTO_TEST_CASE(an_output_directory_that_cannot_be_is_one_error) {
  const Scratch scratch;
  const auto file = scratch.file("file", "kept");
  for (const std::filesystem::path& out : {file, file / "below", std::filesystem::path("/proc/fiberchain")}) {
    const Outcome outcome = run(good_run(scratch, out));
    BOOST_TEST(outcome.status == 3);
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(outcome.error.find("cannot write " + out.string()) != std::string::npos, outcome.error);
    BOOST_TEST(content(file) == "kept");
  }
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_one_error_and_leaves_the_old_results) {
  const Scratch scratch;
  scratch.file("results/s.csv", "old results");
  const auto scene = scratch.file("s.yaml", with("aspect_ratio: 10", "aspect_ratio: 150"));
  for (const std::size_t room : {1000, 5000}) {  // none at all; too little for the shape's table
    const Outcome outcome =
        run({"run", scene.string(), "--out", (scratch.path / "results").string()}, {.largest_file = room});
    BOOST_TEST(outcome.status == 3);
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(content(scratch.path / "results/s.csv") == "old results");
    BOOST_TEST(files_under(scratch.path / "results") == 1);
  }
}

BOOST_AUTO_TEST_CASE(standard_output_that_cannot_be_written_is_one_error) {
  const Outcome outcome = run({"columns"}, {.standard_output = "/dev/full"});
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
}

BOOST_AUTO_TEST_CASE(a_march_that_does_not_come_to_rest_is_one_error) {
  const Scratch scratch;
  const auto scene = scratch.file("s.yaml", kScene + "method: march\nmarch: {max_periods: 0.01}\n");
  const Outcome outcome = run({"run", scene.string()}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(outcome.out == "");
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
}

BOOST_AUTO_TEST_CASE(an_unstable_step_is_refused) {
  const Scratch scratch;
  const auto scene = scratch.file("s.yaml", kScene + "method: march\nmarch: {step_ratio: 5}\n");
  const Outcome outcome = run({"run", scene.string()}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
}

BOOST_AUTO_TEST_SUITE_END()
