// Crossed fibers of unlike spheres that collide, through the whole engine: every force is Hertz's.
#include <boost/test/unit_test.hpp>

#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(crossed_contact_test)

using namespace transverse;

/// Crossed fibers of other radius, material and mass: at every moment the force is Hertz's of the overlap of
/// both, along the line of centers, at the place between the surfaces, and nothing else moves them.
BOOST_AUTO_TEST_CASE(spheres_of_different_radius_and_material_press_by_hertz) {
  const dem::Fiber thin = fiber_of(2.6e6, 0.31, 1130, 1.1e-3);
  dem::Fiber longer = fiber_of(4.4e6, 0.41, 610, 3.9e-3);
  longer.aspect_ratio = 4;
  const ref::HertzPair pair = ref::hertz_pair(body_of(thin), body_of(longer));
  const dem::Chain<3> one = dem::straight_chain<3>(thin), two = dem::straight_chain<3>(longer);
  const double reach = dem::sphere_radius(thin) + dem::sphere_radius(longer);
  const dem::ChainState<3> a = dem::placed(one, {tilted(0, 0, 0), tilted(0.3, 1, 0.2), tilted(0.8, 0.1, 0)});
  const dem::ChainState<3> b =
      dem::placed(two, {tilted(1.15 * reach, -3.8e-3, 0.4e-3), tilted(0, 1, 0), tilted(-0.3, 0, 0)});
  dem::Domain around;  // no friction, no dashpots: the force is a function of the overlap
  dem::Assembly assembly({{one, {a}}, {two, {b}}}, around, {.step = 2e-7});
  const auto momentum = [&](int g) {
    V sum{};
    for (const V& v : assembly.state(g, 0).velocity)
      sum = sum + dem::sphere_mass(assembly.chain(g).fiber) * v;
    return sum;
  };
  const V start[2]{momentum(0), momentum(1)};
  V impulse{};
  double largest = 0;
  int touches = 0;
  BOOST_TEST(assembly.touching() == 0);
  bool met[2][5]{};
  for (int n = 0; n < 4000; ++n) {
    assembly.march(1);
    const dem::PlacedSpheres placed = assembly.placed();
    for (const dem::ContactState& c : assembly.contacts()) {
      const std::int64_t first = c.key.first.number, second = c.key.second.number;
      BOOST_REQUIRE(first < 2);
      BOOST_REQUIRE((is_sphere(c.key.second) && second >= 2));
      const V x = placed.position[first], y = placed.position[second];
      const double distance = norm(y - x), overlap = reach - distance;
      const double force = ref::hertz_stiffness(pair) * std::pow(overlap, 1.5);
      BOOST_TEST(std::abs(c.overlap - overlap) < 1e-9 * overlap + 1e-17);
      BOOST_TEST(norm(c.force + (force / distance) * (y - x)) < 1e-6 * force + 1e-15);
      BOOST_TEST(norm(c.point - x) == dem::sphere_radius(thin) / reach * distance,
                 boost::test_tools::tolerance(1e-9));
      impulse = impulse + assembly.step() * c.force;
      largest = std::max(largest, overlap);
      met[first][second - 2] = true;
      ++touches;
    }
  }
  BOOST_TEST(assembly.touching() == 0);
  BOOST_TEST(touches > 300);
  BOOST_TEST(largest > 1e-5);
  int pairs = 0;
  for (const auto& row : met) {
    for (const bool one_met : row) pairs += one_met;
  }
  BOOST_TEST(pairs > 1);
  BOOST_TEST(norm(momentum(0) - start[0] - impulse) < 1e-9 * norm(impulse));
  BOOST_TEST(norm(momentum(1) - start[1] + impulse) < 1e-9 * norm(impulse));
}

BOOST_AUTO_TEST_SUITE_END()
