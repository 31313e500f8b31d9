// Key spacing of fibers: whole bonds, and where it is refused.
#include <boost/test/unit_test.hpp>
#include <string>

#include "dem/model/errors.hpp"
#include "dem/scene/check_starts.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(spacing_scene_test)

namespace dem = fiberchain::dem;

namespace {

std::string keys_of(const std::string& spacing, int aspect_ratio = 13) {
  return "diameter: 2 mm, aspect_ratio: " + std::to_string(aspect_ratio) +
         ", youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1100" +
         (spacing.empty() ? "" : ", spacing: " + spacing);
}

std::string release(const std::string& spacing, int aspect_ratio = 13) {
  return "scene: release\nfiber: {" + keys_of(spacing, aspect_ratio) + "}\nload: {reduced: 0.1}\n";
}

std::string packing(const std::string& fibers, const std::string& more = "") {
  return "scene: packing\nfibers:\n" + fibers +
         "filling: {region: {x: [0, 6 cm], y: [0, 6 cm], z: [0, 6 cm]}}\nsteps: 20\n" + more;
}

dem::Fiber fiber_of(const std::string& text) {
  return std::get<dem::ReleaseScene>(dem::parse_scene({"s.yaml", text})).fiber;
}

std::string refusal(const std::string& text) {
  try {
    dem::parse_scene({"s.yaml", text});
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "";
}

void check_refused(const std::string& text, const std::string& says) {
  BOOST_TEST(refusal(text).find(says) != std::string::npos, refusal(text));
}

}  // namespace

BOOST_AUTO_TEST_CASE(bonds_are_whole_and_make_up_the_length) {
  const dem::Fiber usual = fiber_of(release(""));
  BOOST_TEST(usual.spacing == 1);
  BOOST_TEST(usual.aspect_ratio == 13);
  const dem::Fiber five = fiber_of(release("2.6")), many = fiber_of(release("0.5")),
                   seven = fiber_of(release("1.857143"));
  BOOST_TEST(five.aspect_ratio == 5);
  BOOST_TEST(many.aspect_ratio == 26);
  BOOST_TEST(seven.aspect_ratio == 7);
  BOOST_TEST(seven.spacing == 13.0 / 7);
  for (const dem::Fiber& fiber : {five, many, seven})
    BOOST_TEST(dem::fiber_length(fiber) == 0.026, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(lengths_that_do_not_fit_are_refused_with_those_that_do) {
  check_refused(release("1.7"),
                "s.yaml:2: fiber.spacing: 1.7 is not allowed: 13 diameters are 7.64706 bonds of that length, "
                "which must be a whole number, at most 1e+06; next to it: 1.857143 (7 bonds), 1.625 (8)");
  check_refused(release("40"), "next to it: 13 (1 bonds), 6.5 (2)");
  check_refused(release("0"), "s.yaml:2: fiber.spacing");
  check_refused(release("0.01", 100000), "s.yaml:2: fiber.spacing: 0.01 is not allowed");
}

BOOST_AUTO_TEST_CASE(in_fluids_and_among_fibers_it_is_refused_by_its_key) {
  check_refused("scene: flow\nfiber: {" + keys_of("2.6") +
                    "}\nfluid: {viscosity: 10, flow: shear, rate: 2}\nstart: {direction: [0, 1, 0]}\n"
                    "duration: 1\n",
                "s.yaml:2: fiber.spacing: 2.6 is not allowed in a fluid");
  const std::string one = "  - {" + keys_of("2.6") + ", count: 1}\n",
                    two = "  - {" + keys_of("2.6") + ", count: 2}\n",
                    other = "  - {" + keys_of("") + ", count: 1}\n",
                    shorter = "  - {" + keys_of("0.5") + ", count: 1}\n";
  const auto smooth = [&](const std::string& spacing) {
    return "  - {" + keys_of(spacing) + ", surface: smooth, count: 2}\n";
  };
  BOOST_TEST(refusal(packing(one)) == "");
  BOOST_TEST(refusal(packing(smooth("2.6") + smooth("0.5"))) == "");
  check_refused(packing(smooth("2.6"), "fluid: {viscosity: 1e-3}\n"),
                "spacing: 2.6 is not allowed in a fluid");
  check_refused(packing(two), "s.yaml:3: fibers[0].spacing: 2.6 is not allowed where fibers may touch");
  check_refused(packing(other + one),
                "s.yaml:4: fibers[1].spacing: 2.6 is not allowed where fibers may touch");
  check_refused(packing(shorter), "s.yaml:3: fibers[0].spacing: 0.5 is not allowed here");
  check_refused(packing(one, "fluid: {viscosity: 1e-3}\n"),
                "s.yaml:3: fibers[0].spacing: 2.6 is not allowed in a fluid");
  BOOST_TEST(refusal(packing("  - {" + keys_of("1") + ", count: 2}\n")) == "");
}

/// Two that cross in the middle of bonds, far from all spheres.
BOOST_AUTO_TEST_CASE(smooth_fibers_from_files_start_apart_between_their_spheres) {
  const auto starts_at = [](double height) {
    const auto text = packing("  - {" + keys_of("2.6") + ", surface: smooth, count: 2}\n");
    auto scene = std::get<dem::PackingScene>(dem::parse_scene({"s.yaml", text}));
    scene.kinds[0].count = 0;
    scene.kinds[0].starts = {{{0.01, 0.03, 0.03}, {1, 0, 0}}, {{0.0126, 0.0274, 0.03 + height}, {0, 1, 0}}};
    dem::check_starts(scene);
  };
  BOOST_CHECK_NO_THROW(starts_at(1.55e-3));
  BOOST_CHECK_THROW(starts_at(1.4e-3), dem::InvalidInput);
  BOOST_CHECK_THROW(starts_at(-0.5e-3), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(an_arcs_radius_is_that_of_its_bonds) {
  const auto of = [](const std::string& curvature) {
    return refusal(packing("  - {" + keys_of("2.6") + ", curvature: {" + curvature + "}, count: 1}\n"));
  };
  BOOST_TEST(of("radius: 2 cm") == "");
  BOOST_TEST(of("radius: 5 mm").find("fibers[0].curvature.radius") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
