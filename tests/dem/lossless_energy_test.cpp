#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "dem/scene/build_packing.hpp"
#include "dem/scene/scene.hpp"

// Fibers that lose nothing fly about in a closed box. Leapfrog keeps the energy of a Hamiltonian beside the
// true one, so that the total departs by an offset that goes with the square of the step and swings with the
// contacts; at the step that stability alone sets it wanders besides.
BOOST_AUTO_TEST_SUITE(lossless_energy_test)

namespace dem = fiberchain::dem;

namespace {

struct Departure {
  double step, mean, least, most;  ///< [s]; of the total energy, in parts of that at the start
};

/// Six fibers for 3 s; `motion` stands behind the form of the bonds.
Departure departure(const std::string& motion, int seed) {
  const std::string text =
      "scene: packing\n"
      "fibers: [{diameter: 2 mm, aspect_ratio: 5, youngs_modulus: 2 MPa, poisson_ratio: 0.3, density: 1000, "
      "count: 6}]\n"
      "filling: {seed: " +
      std::to_string(seed) +
      ", velocity: [1, 0.7, 0.3]}\n"
      "walls: {youngs_modulus: 2 MPa, poisson_ratio: 0.3, box: {x: 25 mm, y: 25 mm, z: 25 mm}}\n"
      "contacts: {restitution: 1}\n"
      "motion: {form: total" +
      motion + "}\nduration: 3 s\n";
  dem::PackingStart start =
      dem::packing_start(std::get<dem::PackingScene>(dem::parse_scene({"s.yaml", text})), 1);
  const std::int64_t steps = start.steps;
  dem::Assembly assembly = dem::make_assembly(std::move(start));
  constexpr int samples = 600;
  const double at_start = total(assembly.energy());
  Departure found{assembly.step(), 0, 1, -1};
  for (int n = 1; n <= samples; ++n) {
    assembly.march(steps * n / samples - assembly.steps());
    const double part = total(assembly.energy()) / at_start - 1;
    found.mean += part / samples;
    found.least = std::min(found.least, part), found.most = std::max(found.most, part);
  }
  return found;
}

}  // namespace

// Motions part after some collisions: the ratio of one seed is 2.9 to 4.5, that of the sums of three 3.5
// to 4.4.
BOOST_AUTO_TEST_CASE(the_offset_goes_with_the_square_of_the_step) {
  double coarse = 0, fine = 0;
  for (const int seed : {1, 2, 3}) {
    coarse += departure(", step: 7.64e-6", seed).mean;
    fine += departure(", step: 3.82e-6", seed).mean;
  }
  BOOST_TEST_MESSAGE(coarse / 3 << " and " << fine / 3);
  BOOST_TEST(std::abs(coarse / fine - 4) < 0.8);
}

BOOST_AUTO_TEST_CASE(the_restitution_wanted_bounds_the_wander) {
  for (const int seed : {1, 2}) {
    const Departure chosen = departure("", seed), finer = departure(", restitution_error: 1e-3", seed),
                    finest = departure(", restitution_error: 3e-4", seed);
    BOOST_TEST_MESSAGE("seed " << seed << ": " << chosen.least << " to " << chosen.most << " at "
                               << chosen.step << " s, " << finer.least << " to " << finer.most << " at "
                               << finer.step << " s, " << finest.least << " to " << finest.most << " at "
                               << finest.step << " s");
    const auto farthest = [](const Departure& found) { return std::max(-found.least, found.most); };
    BOOST_TEST((farthest(chosen) > 0.015 && farthest(chosen) < 0.075));
    BOOST_TEST((farthest(finer) > 0.007 && farthest(finer) < 0.018));
    BOOST_TEST((farthest(finest) > 0.002 && farthest(finest) < 0.006));
  }
}

BOOST_AUTO_TEST_SUITE_END()
