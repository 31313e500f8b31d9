// Keys of bonds that break or yield.
#include <boost/test/unit_test.hpp>
#include <string>

#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(strength_scene_test)

namespace dem = fiberchain::dem;

namespace {

std::string scene_with(const std::string& bond, const std::string& more = "") {
  return "scene: packing\nfibers:\n  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, "
         "poisson_ratio: 0.3, "
         "density: 1000" +
         more + ", count: 4, bond: " + bond +
         "}\nfilling: {region: {x: [0, 3 cm], y: [0, 3 cm], z: [0, 3 cm]}}\nsteps: 20\n";
}

dem::Fiber fiber_of(const std::string& bond, const std::string& more = "") {
  const dem::Scene scene = dem::parse_scene({.name = "s.yaml", .text = scene_with(bond, more)});
  return std::get<dem::PackingScene>(scene).kinds.at(0).fiber;
}

std::string refusal(const std::string& bond, const std::string& more = "") {
  try {
    fiber_of(bond, more);
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(strengths_are_read_in_their_units) {
  const dem::Fiber plain = fiber_of("{damping: 0.1}");
  BOOST_TEST(!dem::fails(plain));
  const dem::Fiber fiber = fiber_of(
      "{strength: {tension: 55 MPa, torsion: 3e7, weibull: {modulus: 9, reference_length: 5 cm, seed: 4}}}");
  BOOST_TEST(dem::fails(fiber));
  BOOST_TEST(*fiber.strength->tension == 55e6);
  BOOST_TEST(!fiber.strength->compression.has_value());
  BOOST_TEST(!fiber.strength->shear.has_value());
  BOOST_TEST(*fiber.strength->torsion == 3e7);
  BOOST_TEST(fiber.strength->weibull->modulus == 9);
  BOOST_TEST(fiber.strength->weibull->reference_length == 0.05);
  BOOST_TEST(fiber.strength->weibull->seed == 4u);
  // of the fiber, where it is left out
  const dem::Fiber usual = fiber_of("{strength: {shear: 1 MPa, weibull: {modulus: 9}}}");
  BOOST_TEST(usual.strength->weibull->reference_length == 0.012, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(yielding_is_read_by_moment_or_stress) {
  BOOST_TEST(fiber_of("{yield: {moment: 2e-5 N m, hardening: 0.2}}").yield->moment == 2e-5);
  BOOST_TEST(fiber_of("{yield: {moment: 2e-5 N m, hardening: 0.2}}").yield->hardening == 0.2);
  const dem::Fiber fiber = fiber_of("{yield: {stress: 3 MPa}}");
  BOOST_TEST(fiber.yield->moment == 4.0 / 3 * 3e6 * 1e-9, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(fiber.yield->hardening == 0);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_by_its_key) {
  BOOST_TEST(holds(refusal("{strength: {weibull: {modulus: 3}}}"), "needs tension or compression"));
  BOOST_TEST(holds(refusal("{strength: {tension: -1 MPa}}"), "tension"));
  BOOST_TEST(holds(refusal("{strength: {tension: 1 MPa, weibull: {seed: 3}}}"), "modulus"));
  BOOST_TEST(holds(refusal("{yield: {moment: 1e-5, stress: 1 MPa}}"), "stress"));
  BOOST_TEST(holds(refusal("{yield: {moment: 1e-5, hardening: 1}}"), "hardening"));
  BOOST_TEST(holds(refusal("{strength: {tension: 1 MPa}, rolling_friction: 0.1}"), "not built together"));
  BOOST_TEST(
      holds(refusal("{yield: {moment: 1e-5}}", ", material_damping: {loss_factor: 0.02, band: [10, 100]}"),
            "not built together"));
}

BOOST_AUTO_TEST_SUITE_END()
