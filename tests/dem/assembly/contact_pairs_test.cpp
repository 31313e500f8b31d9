// Contacts that differ by pair of surfaces: friction, restitution and moduli of walls and of kinds of fibers.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "dem/contact/contact_body.hpp"
#include "dem/insertion/placement.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(contact_pairs_test)

using namespace scenes;

namespace {

void near(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

dem::Chain<3> chain_of(int aspect_ratio, double youngs_modulus, double density, int surface) {
  dem::Fiber fiber{dem::isotropic_material(youngs_modulus, 0.17, density), 1.66e-3, aspect_ratio};
  fiber.bond_damping = 0.3;
  dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  chain.surface = surface;
  return chain;
}

/// Hertz's stiffness against another surface; of two spheres of the same radius or of one and a wall
/// [N/m^1.5].
double hertz(double E1, double nu1, double E2, double nu2, double R) {
  return 4.0 / 3 / ((1 - nu1 * nu1) / E1 + (1 - nu2 * nu2) / E2) * std::sqrt(R);
}

V mean_velocity(const dem::Assembly& assembly, int group) {
  const dem::ChainState<3> state = assembly.state(group, 0);
  V sum{};
  for (const V& v : state.velocity) sum = sum + (1.0 / static_cast<double>(state.velocity.size())) * v;
  return sum;
}

}  // namespace

/// A fiber slides along a groove between two walls, each with a friction of its own.
BOOST_AUTO_TEST_CASE(two_walls_of_a_groove_have_their_own_friction) {
  constexpr double g = 9.81, a1 = 0.5, a2 = 0.8, mu1 = 0.21, mu2 = 0.47, speed = 0.5;
  const dem::Chain<3> chain = chain_of(5, 2.6e6, 1130, 0);
  const double m = dem::sphere_mass(chain.fiber), R = dem::sphere_radius(chain.fiber),
               N1 = m * g * std::sin(a2) / std::sin(a1 + a2), N2 = m * g * std::sin(a1) / std::sin(a1 + a2);
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = 0.3, .friction = 0.9};
  const V n1{0, -std::sin(a1), std::cos(a1)}, n2{0, std::sin(a2), std::cos(a2)};
  around.walls = {side({}, n1), side({}, n2)};
  around.walls[0].contacts.friction = mu1;
  around.walls[1].surface = 2;
  around.walls[1].contacts.friction = 0.1;  // what both surfaces have comes first
  around.pairs = {{2, 0, {.friction = mu2}}};
  const double k = hertz(2.6e6, 0.17, 1e300, 0.3, R), d1 = R - std::pow(N1 / k, 2.0 / 3),
               d2 = R - std::pow(N2 / k, 2.0 / 3), s = std::sin(a1 + a2);
  // n1 . x = d1, n2 . x = d2
  const V place{0, (d2 * std::cos(a1) - d1 * std::cos(a2)) / s, (d1 * std::sin(a2) + d2 * std::sin(a1)) / s};
  dem::Assembly assembly({{chain, {dem::placed(chain, {place, {1, 0, 0}, {speed, 0, 0}})}}}, around,
                         {.step = 4e-6});
  assembly.march(5000);
  const double before = mean_velocity(assembly, 0)[0], then = assembly.time();
  assembly.begin_wall_interval();
  assembly.march(2500);
  const auto walls = assembly.wall_samples();
  const auto ratio = [](const V& force, const V& normal) {
    const double pressed = -dot(force, normal);
    return norm(force + pressed * normal) / pressed;
  };
  near(ratio(walls[0].mean.force, n1), mu1, 1e-5, "friction of the first");
  near(ratio(walls[1].mean.force, n2), mu2, 1e-5, "friction of the second");
  near((before - mean_velocity(assembly, 0)[0]) / ((mu1 * N1 + mu2 * N2) / m * (assembly.time() - then)), 1,
       1e-3, "slows down");
}

/// Two kinds of fibers meet a wall and each other, each pair with its restitution.
BOOST_AUTO_TEST_CASE(every_pair_has_its_own_restitution) {
  const dem::Chain<3> one = chain_of(1, 2.6e6, 1130, 1), two = chain_of(1, 5.3e6, 790, 2);
  dem::Domain around;
  around.contacts = {.restitution = 0.9};
  around.walls = {side({}, {0, 0, 1})};
  around.walls[0].contacts.restitution = 0.62;
  around.pairs = {{1, 2, {.restitution = 0.35}}, {2, 2, {.restitution = 0.51}}};
  const auto at = [](const dem::Chain<3>& chain, double x, double z, double v) {
    return dem::FiberGroup{chain, {dem::placed(chain, {{x, 0, z}, {0, 1, 0}, {0, 0, v}})}};
  };
  // at the wall; one on two; two on two; one on one
  const std::vector<dem::FiberGroup> groups = {at(one, 0, 1e-3, -0.3),   at(two, 0.01, 1e-3, -0.3),
                                               at(one, 0.02, 5e-3, 0.2), at(two, 0.02, 7e-3, -0.1),
                                               at(two, 0.03, 5e-3, 0.2), at(two, 0.03, 7e-3, -0.1),
                                               at(one, 0.04, 5e-3, 0.2), at(one, 0.04, 7e-3, -0.1)};
  dem::Assembly assembly(groups, around, {.step = 5e-7});
  assembly.march(5000);
  BOOST_TEST(assembly.touching() == 0);
  const auto v = [&](int group) { return mean_velocity(assembly, group)[2]; };
  near(v(0) / 0.3, 0.62, 1e-3, "wall");
  near(v(1) / 0.3, 0.62, 1e-3, "wall");
  near((v(3) - v(2)) / 0.3, 0.35, 1e-3, "between the kinds");
  near((v(5) - v(4)) / 0.3, 0.51, 1e-3, "second kind");
  near((v(7) - v(6)) / 0.3, 0.9, 1e-3, "first kind");
}

/// At rest on walls of their own modulus, with a surface of the fibers that differs by pair.
BOOST_AUTO_TEST_CASE(every_pair_has_its_own_modulus) {
  constexpr double g = 9.81;
  const dem::Chain<3> one = chain_of(2, 2.6e6, 1130, 0), two = chain_of(2, 5.3e6, 790, 4);
  const double R = dem::sphere_radius(one.fiber);
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = 0.5};
  around.wall_youngs_modulus = 8e6, around.wall_poisson_ratio = 0.4;
  around.walls = {side({}, {0, 0, 1}),
                  {dem::BoxObstacle{{0.1, 0, -0.01}, {0.02, 0.02, 0.01}, {1, 0, 0}, {0, 1, 0}}}};
  around.walls[0].active_until = 1e9;
  around.walls[1].youngs_modulus = 1.3e6, around.walls[1].surface = 3;
  around.pairs = {{3, 4, {.youngs_modulus = 4.4e5, .poisson_ratio = 0.31}}};
  // beside the obstacle the plane is in the way of nothing else: both begin at z = 0
  struct Case {
    const dem::Chain<3>& chain;
    int wall;
    double stiffness;
  };
  const Case cases[] = {{one, 0, hertz(2.6e6, 0.17, 8e6, 0.4, R)},
                        {two, 0, hertz(5.3e6, 0.17, 8e6, 0.4, R)},
                        {one, 1, hertz(2.6e6, 0.17, 1.3e6, 0.4, R)},
                        {two, 1, hertz(4.4e5, 0.31, 1.3e6, 0.4, R)}};
  for (const Case& c : cases) {
    dem::Domain own = around;
    own.walls = {around.walls[c.wall]};
    const double overlap = std::pow(dem::sphere_mass(c.chain.fiber) * g / c.stiffness, 2.0 / 3),
                 z = R - overlap;
    dem::Assembly assembly({{c.chain, {dem::placed(c.chain, {{c.wall == 0 ? 0 : 0.1, 0, z}, {1, 0, 0}})}}},
                           own, {.step = 2e-6});
    assembly.march(2000);
    near((assembly.state(0, 0).poses[1].position[2] - z) / overlap, 0, 1e-9, "rests");
    near(assembly.contacts().front().overlap / overlap, 1, 1e-9, "overlap");
  }
}

/// Pairs that say what all contacts have are those contacts.
BOOST_AUTO_TEST_CASE(named_contacts_of_all_are_the_contacts_of_all) {
  std::vector<double> places[2];
  for (const bool named : {false, true}) {
    SmallPacking packing = packing_in_a_box(8, 6);
    if (named) {
      for (std::size_t n = 0; n < packing.groups.size(); ++n)
        packing.groups[n].chain.surface = 5 + static_cast<int>(n);
      for (dem::Wall& wall : packing.around.walls) wall.surface = 9, wall.youngs_modulus = 3e6;
      const dem::ContactProperties& all = packing.around.contacts;
      const dem::ContactChoices same{all.restitution, all.friction, all.rolling_friction, {}, {}};
      packing.around.pairs = {{5, 6, same}, {9, 5, same}, {6, 6, same}};
      packing.around.contacts = {0.4, 0.6, 0.02};
    }
    dem::Assembly assembly = packing.assembly({.step = 6e-6});
    assembly.march(2500);
    BOOST_TEST(assembly.touching() > 3);
    for (const V& x : assembly.placed().position) places[named].insert(places[named].end(), x.c, x.c + 3);
  }
  BOOST_TEST(places[0] == places[1]);
}

/// What a chosen step and the expected overlap count with.
BOOST_AUTO_TEST_CASE(every_pair_of_bodies_is_listed_with_its_properties) {
  dem::Domain around;
  around.contacts = {0.8, 0.4, 0};
  around.walls = {side({}, {0, 0, 1}), side({}, {0, 0, 1}), side({}, {0, 0, 1})};
  around.walls[2].contacts.rolling_friction = 0.1;
  BOOST_TEST(dem::rolls(around));
  around.walls[2].contacts = {.friction = 0.7};
  BOOST_TEST(!dem::rolls(around));
  around.pairs = {{7, 7, {.youngs_modulus = 1e5}}};
  const std::vector<dem::ContactBody> spheres = {sphere_body(chain_of(2, 2.6e6, 1130, 0), around),
                                                 sphere_body(chain_of(2, 2.6e6, 1130, 7), around)};
  const auto pairs = dem::contact_pairs(around, spheres);
  BOOST_TEST_REQUIRE(pairs.size() == 3u + 2 * 2);  // two of the walls are one kind
  const auto count = [&](const auto& is) { return std::ranges::count_if(pairs, is); };
  BOOST_TEST(count([](const auto& pair) { return pair.properties.friction == 0.7; }) == 2);
  BOOST_TEST(count([](const auto& pair) { return pair.first.youngs_modulus == 1e5; }) == 1);
  BOOST_TEST(count([](const auto& pair) { return pair.first.youngs_modulus == 2.6e6; }) == 6);
}

BOOST_AUTO_TEST_SUITE_END()
