#include "dem/scene/scene.hpp"

#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(scene_test)

namespace dem = fiberchain::dem;

namespace {

const std::string kScene = R"(# a comment
scene: cantilever
dimension: spatial
fiber:
  diameter: 3 mm
  aspect_ratio: 13
  youngs_modulus: 2.6 MPa
  poisson_ratio: 0.17
  density: 1.2 g/cm^3
bond: {model: corrected, form: incremental, damping: 0.7}
load: {reduced: 1.25, direction: [0, 3, 4]}
method: march
march: {bond_damping: 0.5, drag: 1.5, step_ratio: 0.11, ramp_periods: 3, residual: 1e-9, max_periods: 77}
)";

dem::CantileverScene parse(const std::string& text) {
  return std::get<dem::CantileverScene>(dem::parse_scene({"test.yaml", text}));
}

/// The scene with one text replaced by another.
std::string with(const std::string& from, const std::string& to) {
  std::string text = kScene;
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "no error";
}

struct Fault {
  const char* from;
  const char* to;
  const char* says;  ///< the whole message, or its beginning
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.to; }

const Fault kFaults[] = {
    {"diameter:", "diametre:", "test.yaml:5: unknown key 'fiber.diametre'; did you mean 'diameter'?"},
    {"scene: cantilever", "scene: cantilever\nquux: 1",
     "test.yaml:3: unknown key 'quux'; allowed: scene, dimension"},
    {"method: march", "method: march\nmethod: march", "test.yaml:13: key 'method' comes twice"},
    {"  density: 1.2 g/cm^3\n", "", "test.yaml:4: fiber: key 'density' is missing"},
    {"scene: cantilever\n", "", "test.yaml:2: key 'scene' is missing"},
    {"cantilever", "pudding", "test.yaml:2: scene: 'pudding' is not allowed; allowed: cantilever"},
    {"3 mm", "3 kg", "test.yaml:5: fiber.diameter: '3 kg' has a unit of another dimension; allowed: m"},
    {"3 mm", "-3 mm",
     "test.yaml:5: fiber.diameter: '-3 mm' is out of range; allowed: a number at least 1e-12 and at most "
     "1e+09, in m"},
    {"3 mm", "0", "test.yaml:5: fiber.diameter: '0' is out of range"},
    {"3 mm", ".inf", "test.yaml:5: fiber.diameter: '.inf' is out of range"},
    {"3 mm", "nan", "test.yaml:5: fiber.diameter: 'nan' is out of range"},
    {"3 mm", "1e-320 mm", "test.yaml:5: fiber.diameter: '1e-320 mm' is out of range"},
    {"3 mm", "[3]", "test.yaml:5: fiber.diameter: must be a single value"},
    {"3 mm", "", "test.yaml:5: fiber.diameter: must be a single value"},
    {"13", "13.5",
     "test.yaml:6: fiber.aspect_ratio: '13.5' is not allowed; allowed: a whole number at least 1"},
    {"13", "0", "test.yaml:6: fiber.aspect_ratio: '0' is not allowed"},
    {"13", "99999999999999999999", "test.yaml:6: fiber.aspect_ratio: '99999999999999999999' is not allowed"},
    {"2.6 MPa", "0 Pa", "test.yaml:7: fiber.youngs_modulus: '0 Pa' is out of range"},
    {"0.17", "0.51", "test.yaml:8: fiber.poisson_ratio: '0.51' is out of range; allowed: a number above -1"},
    {"0.17", "-1", "test.yaml:8: fiber.poisson_ratio: '-1' is out of range"},
    {"poisson_ratio: 0.17", "", "test.yaml:4: fiber: needs poisson_ratio or shear_modulus"},
    {"poisson_ratio: 0.17", "shear_modulus: 0 Pa",
     "test.yaml:8: fiber.shear_modulus: '0 Pa' is out of range"},
    {"0.17", "0.17\n  transverse_modulus: 1 MPa",
     "test.yaml:9: fiber.transverse_modulus: is of use only with shear_modulus"},
    {"0.17", "0.17\n  mass: beads",
     "test.yaml:9: fiber.mass: 'beads' is not allowed; allowed: spheres, cylinder"},
    {"damping: 0.7", "damping: -0.7", "test.yaml:10: bond.damping: '-0.7' is out of range"},
    {"model: corrected", "model: better",
     "test.yaml:10: bond.model: 'better' is not allowed; allowed: paper, corrected"},
    {"{reduced: 1.25, direction: [0, 3, 4]}", "7", "test.yaml:11: load: must be a mapping"},
    {"reduced: 1.25", "reduced: 1.25, force: 1 N",
     "test.yaml:11: load: must have exactly one of reduced, force"},
    {"reduced: 1.25", "force: 1e308 N", "test.yaml:11: load.force: "},
    {"[0, 3, 4]", "[0, 0, 0]", "test.yaml:11: load.direction: must not be zero"},
    {"[0, 3, 4]", "[0, x, 4]", "test.yaml:11: load.direction: must be three finite numbers"},
    {"[0, 3, 4]", "[3, 4]", "test.yaml:11: load.direction: must be three finite numbers"},
    {"spatial", "planar", "test.yaml:11: load.direction: must lie in the x-y plane"},
    {"method: march", "method: solve", "test.yaml:13: march: is of use only with 'method: march'"},
    {"step_ratio: 0.11", "step_ratio: 0", "test.yaml:13: march.step_ratio: '0' is out of range"},
    {"ramp_periods: 3", "ramp_periods: 3 s",
     "test.yaml:13: march.ramp_periods: '3 s' has a unit of another dimension"},
    {"bond_damping: 0.5, drag: 1.5", "bond_damping: 0, drag: 0",
     "test.yaml:13: march: needs bond_damping or drag"},
    {"method: march\nmarch: {", "method: solve\n#",
     "test.yaml:12: method: 'solve' finds the equilibrium of the total form"},
    {"method: march", "method: [", "test.yaml:14: is no YAML: "},
    {"scene: cantilever", "--- {a: 1}\n---", "test.yaml: holds more than one document"},
};

struct Noise {
  const char* name;
  std::string text;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Noise& noise) { return out << noise.name; }

std::string repeated(const std::string& text, std::size_t size) {
  std::string all;
  while (all.size() < size) all += text;
  return all;
}

/// Deterministic bytes without pattern (Knuth's linear congruential generator, high byte).
std::string noise(std::size_t size) {
  std::string bytes;
  for (std::uint64_t state = 2015; bytes.size() < size;
       state = state * 6364136223846793005u + 1442695040888963407u) {
    bytes += static_cast<char>(state >> 56);
  }
  return bytes;
}

std::string alias_bomb() {
  std::string text = "a0: &a0 [1, 1]\n";
  for (int i = 1; i < 60; ++i) {
    const std::string last = std::to_string(i - 1), next = std::to_string(i);
    text += "a" + next + ": &a" + next + " [*a" + last + ", *a" + last + "]\n";
  }
  return text + "scene: cantilever\n";
}

const Noise kNoise[] = {
    {"empty", "", "it is empty"},
    {"only comments", "# nothing\n\n# here\n", "it is empty"},
    {"a word", "hello", "must be a mapping"},
    {"an empty list item", "-", "must be a mapping"},
    {"noise", noise(dem::kLargestScene), "test.yaml:1: "},
    {"deep flow", repeated("[", dem::kLargestScene), "nested too deeply"},
    {"deep block", repeated("- ", dem::kLargestScene), "nested too deeply"},
    {"deep mapping", repeated("{a: ", dem::kLargestScene), "nested too deeply"},
    {"many keys", repeated("a: b\n", dem::kLargestScene), "key 'scene' is missing"},
    {"alias bomb", alias_bomb(), "unknown key 'a0'"},
    {"alias to itself", "scene: cantilever\nfiber: &f {fiber: *f}\n", "unknown key 'fiber.fiber'"},
    {"a text that yaml-cpp reads as documents without end", ", fiber: &f {<<: *f}}", "test.yaml"},
    {"text after the scene", "{scene: cantilever}\nand more", "test.yaml"},
    {"odd bytes", "scene: cantilever\n\"a\\x07\\n\xff\": 1\n", "unknown key 'a?"},
    {"a key that is a list", "scene: cantilever\n? [a, b]\n: 1\n", "a key must be a word"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_arrives_in_si_units) {
  const dem::CantileverScene scene = parse(kScene);
  BOOST_TEST((scene.dimension == dem::Dimension::spatial));
  BOOST_TEST(scene.fiber.diameter == 3e-3);
  BOOST_TEST(scene.fiber.aspect_ratio == 13);
  BOOST_CHECK_CLOSE_FRACTION(scene.fiber.material.youngs_modulus, 2.6e6, 1e-15);
  BOOST_CHECK_CLOSE_FRACTION(scene.fiber.material.shear_modulus, 2.6e6 / 2.34, 1e-15);
  BOOST_CHECK_CLOSE_FRACTION(scene.fiber.material.density, 1200., 1e-15);
  BOOST_TEST((scene.fiber.bond_model == fiberchain::dem::BondModel::corrected));
  BOOST_TEST((scene.march.form == fiberchain::dem::BondForm::incremental));
  BOOST_TEST(scene.fiber.bond_damping == 0.7);
  BOOST_TEST(scene.load == 1.25);
  BOOST_CHECK_CLOSE_FRACTION(scene.direction[1], 0.6, 1e-15);
  BOOST_CHECK_CLOSE_FRACTION(scene.direction[2], 0.8, 1e-15);
  BOOST_TEST((scene.method == dem::Method::march));
  BOOST_TEST(scene.march.bond_damping == 0.5);
  BOOST_TEST(scene.march.drag == 1.5);
  BOOST_TEST(scene.march.step_ratio.value() == 0.11);
  BOOST_TEST(scene.march.ramp_periods == 3);
  BOOST_TEST(scene.march.residual == 1e-9);
  BOOST_TEST(scene.march.max_periods == 77);
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_the_documented_default) {
  const dem::CantileverScene scene = parse(
      "scene: cantilever\n"
      "fiber: {diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 1 MPa, shear_modulus: 0.4 MPa, density: "
      "900}\n"
      "load: {reduced: 0.5}\n");
  BOOST_TEST((scene.dimension == dem::Dimension::planar));
  BOOST_TEST((scene.fiber.bond_model == fiberchain::dem::BondModel::paper));
  BOOST_TEST((scene.march.form == fiberchain::dem::BondForm::total));
  BOOST_TEST((scene.method == dem::Method::solve));
  BOOST_TEST(scene.fiber.bond_damping == 0.0);
  BOOST_TEST(scene.fiber.material.shear_modulus == 4e5);
  BOOST_TEST(scene.direction[1] == 1.0);
}

// P L^2/(E I) with L = 13 x 3 mm, I = pi d^4/64.
BOOST_AUTO_TEST_CASE(a_load_in_newtons_is_the_same_as_a_reduced_one) {
  const dem::CantileverScene scene = parse(with("reduced: 1.25", "force: 4 mN"));
  const double second_moment = std::acos(-1.) * std::pow(3e-3, 4) / 64;
  BOOST_CHECK_CLOSE_FRACTION(scene.load, 4e-3 * std::pow(13 * 3e-3, 2) / (2.6e6 * second_moment), 1e-13);
}

BOOST_DATA_TEST_CASE(each_fault_is_named_with_file_line_and_key, boost::unit_test::data::make(kFaults),
                     fault) {
  const std::string error = error_of(with(fault.from, fault.to));
  BOOST_TEST(error.starts_with(fault.says), error << " should begin with " << fault.says);
  BOOST_TEST(error.find('\n') == std::string::npos);
}

BOOST_DATA_TEST_CASE(what_is_no_scene_at_all_is_refused_at_once, boost::unit_test::data::make(kNoise),
                     sample) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string error = error_of(sample.text);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  BOOST_TEST(error.find(sample.says) != std::string::npos, error << " should say " << sample.says);
  const auto is_plain = [](unsigned char c) { return c >= 0x20 && c < 0x7f; };
  BOOST_TEST(std::ranges::all_of(error, is_plain));
  BOOST_TEST(error.size() < 300);
  BOOST_TEST(took.count() < 5.0);  // a quarter of a second as built for release
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read_are_refused) {
  BOOST_CHECK_THROW(dem::read_scene_text("no/such/file.yaml"), dem::SceneError);
  BOOST_CHECK_THROW(dem::read_scene_text("/"), dem::SceneError);
  BOOST_CHECK_THROW(dem::read_scene_text("/dev/zero"), dem::SceneError);
}

BOOST_AUTO_TEST_CASE(the_ready_scenes_are_read) {
  for (const char* name : {"cantilever", "cantilever-march", "cantilever-spatial"}) {
    const std::string path = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/" + name + ".yaml";
    BOOST_CHECK_NO_THROW(dem::parse_scene(dem::read_scene_text(path)));
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_may_be_stiffer_along_than_across_and_weigh_what_it_weighs) {
  // wood along the grain: E and G are all that bonds need
  const dem::Fiber wood = parse(with("youngs_modulus: 2.6 MPa\n  poisson_ratio: 0.17",
                                     "youngs_modulus: 11 GPa\n  shear_modulus: 0.7 GPa\n  mass: cylinder"))
                              .fiber;
  BOOST_TEST(wood.material.youngs_modulus == 11e9);
  BOOST_TEST(wood.material.shear_modulus == 0.7e9);
  BOOST_TEST(dem::contact_elasticity(wood.material).poisson_ratio == dem::usual_poisson_ratio);
  BOOST_TEST(dem::contact_elasticity(wood.material).youngs_modulus == 11e9);
  BOOST_TEST((wood.mass == dem::MassModel::cylinder));
  const dem::Fiber across =
      parse(with("poisson_ratio: 0.17",
                 "poisson_ratio: 0.43\n  shear_modulus: 0.1 MPa\n  transverse_modulus: 0.4 MPa"))
          .fiber;
  BOOST_TEST(across.material.shear_modulus == 0.1e6);
  BOOST_TEST(dem::contact_elasticity(across.material).poisson_ratio == 0.43);
  BOOST_TEST(dem::contact_elasticity(across.material).youngs_modulus == 0.4e6);
  // an isotropic one by E and G
  const dem::Fiber same = parse(with("poisson_ratio: 0.17", "shear_modulus: 1.0 MPa")).fiber;
  BOOST_CHECK_CLOSE_FRACTION(dem::contact_elasticity(same.material).poisson_ratio, 0.3, 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
