// Scenes of one fiber run in memory: beam, ring-down and Jeffery's orbit, in a plane and in space.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/run/run_scene.hpp"

BOOST_AUTO_TEST_SUITE(run_fiber_test)

namespace dem = fiberchain::dem;
using boost::test_tools::tolerance;

namespace {

constexpr double L = 20e-3;

/// A fiber of 11 spheres.
dem::Scene scene(const std::string& kind, const std::string& rest) {
  return dem::parse_scene(
      {"x.yaml", "scene: " + kind +
                     "\nfiber: {diameter: 2 mm, aspect_ratio: 10, youngs_modulus: 2.6 MPa, poisson_ratio: "
                     "0.3, density: 1000 kg/m^3}\n" +
                     rest});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_cantilever_bends_as_a_beam_under_its_load) {
  const auto plane =
      dem::run_scene(std::get<dem::CantileverScene>(scene("cantilever", "load: {reduced: 0.01}\n")));
  const auto space = dem::run_scene(std::get<dem::CantileverScene>(
      scene("cantilever", "dimension: spatial\nload: {reduced: 0.01, direction: [0, 0.6, 0.8]}\n")));
  BOOST_TEST(plane.positions.size() == 11u);
  BOOST_TEST(plane.positions.back()[1] == 0.01 / 3 * L, tolerance(0.03));
  BOOST_TEST(plane.positions.back()[2] == 0);
  BOOST_TEST(space.positions.back()[1] == 0.6 * plane.positions.back()[1], tolerance(1e-4));
  BOOST_TEST(space.positions.back()[2] == 0.8 * plane.positions.back()[1], tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_released_fiber_swings_to_the_other_side) {
  for (const std::string dimension : {"planar", "spatial"}) {
    const auto record = dem::run_scene(std::get<dem::ReleaseScene>(
        scene("release", "dimension: " + dimension +
                             "\nbond: {damping: 0, form: total}\nload: {reduced: 0.1}\nperiods: 1\ntime: "
                             "{integrator: implicit, step_ratio: 0.5}\n")));
    BOOST_TEST(record.failure == "");
    BOOST_TEST(dem::name(record.integrator) == "implicit");
    const dem::FreeEnd &first = record.samples.front(), &half = record.samples[record.samples.size() / 2];
    BOOST_TEST(first.position[1] == 0.1 / 3 * L, tolerance(0.03));
    BOOST_TEST(norm(first.velocity) == 0);
    BOOST_TEST(half.time == record.mode.period / 2, tolerance(0.01));
    BOOST_TEST(half.position[1] == -first.position[1], tolerance(0.1));
    BOOST_TEST(half.energy == first.energy, tolerance(1e-6));
  }
}

/// From across the flow: tan(angle) = r tan(strain / (r + 1 / r)), r of a row of spheres dragged alone.
BOOST_AUTO_TEST_CASE(a_stiff_fiber_turns_as_jeffery) {
  const double r = std::sqrt((11.0 * 11 + 1) / 2), tangent = r * std::tan(0.5 / (r + 1 / r));
  for (const std::string dimension : {"planar", "spatial"}) {
    const auto flow = dem::run_scene(std::get<dem::FlowScene>(
        scene("flow", "dimension: " + dimension +
                          "\nfluid: {viscosity: 1 Pa s, flow: shear, rate: 0.01 1/s, hydrodynamics: "
                          "free_draining}\nstart: {direction: [0, 1, 0]}\nstrain: 0.5\nsamples: 10\n")));
    BOOST_TEST(flow.record.failure == "");
    BOOST_TEST(flow.samples.size() == 11u);
    BOOST_TEST(flow.samples.back().time == 50, tolerance(1e-12));
    const dem::Positions& at = flow.samples.back().positions;
    const auto along = at.back() - at.front();
    BOOST_TEST(along[0] / along[1] == tangent, tolerance(1e-3));
    BOOST_TEST(norm(along) == L, tolerance(1e-3));
    BOOST_TEST(norm(at.back() + at.front()) < 1e-6 * L);
  }
}

/// The tip of the Elastica under P L^2 / (E I) = 1.
BOOST_AUTO_TEST_CASE(a_file_says_what_is_run) {
  const std::string scenes = FIBERCHAIN_SOURCE_DIR "/data/scenes/";
  const auto result = dem::run_scene(scenes + "cantilever.yaml");
  const auto* cantilever = std::get_if<dem::CantileverResult>(&result);
  BOOST_TEST_REQUIRE(cantilever != nullptr);
  BOOST_TEST(cantilever->positions.back()[1] == 0.3017 * L, tolerance(0.05));
  BOOST_CHECK_THROW(dem::run_scene(scenes + "none.yaml"), dem::SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
