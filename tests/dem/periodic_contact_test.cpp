// Periodic sides, and contacts in a flow: small scenes, also for sanitizers.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/model/invalid_key.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(periodic_contact_test)

using namespace scenes;

namespace {

constexpr double d = 1.66e-3;

dem::Fiber fiber_of(int bonds, double size = 1) {
  dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.31, 1130), d * size, bonds};
  fiber.bond_damping = 0.2;
  return fiber;
}

/// Two kinds of fibers that fly at each other around a place.
std::vector<dem::FiberGroup> colliding(const V& at, const V& image = {}) {
  const dem::Chain<3> one = dem::straight_chain<3>(fiber_of(4)),
                      two = curled(fiber_of(6, 0.7), {0.1, 0.2, -0.1});
  return {
      {one,
       {dem::placed(one, {at + V{-2.1 * d, 0, 0}, {0.3, 1, 0.2}, {0.9, -0.2, 0.1}}),
        dem::placed(one, {at + d * V{-1, 2, 2.6}, {1, 0.2, 0.4}, {0.3, -0.3, -0.9}})}},
      {two,
       {dem::placed(two, {at + image + V{1.4 * d, 0.4 * d, -1.1 * d}, {-0.1, 0.3, 1}, {-1.1, 0.3, 0.2}})}}};
}

dem::Domain rough(const V& period) {
  dem::Domain around;
  around.period = period;
  around.contacts = {0.5, 0.4, 0.03};
  return around;
}

/// Places about `at` after some steps, spheres of the second group moved back by `image`.
std::vector<V> after(const V& at, const V& image, const dem::Domain& around, int steps, std::int64_t* most) {
  dem::Assembly assembly(colliding(at, image), around, {.step = 4e-6});
  for (int n = 0; n < steps; n += 20) {
    assembly.march(20);
    *most = std::max(*most, assembly.touching());
  }
  std::vector<V> positions;
  for (int g = 0; g < 2; ++g) {
    for (int f = 0; f < assembly.fibers(g); ++f) {
      for (const auto& pose : assembly.state(g, f).poses)
        positions.push_back(pose.position - at - (g == 1 ? image : V{}));
    }
  }
  return positions;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_collision_across_the_sides_is_that_in_the_middle) {
  const V period{0.031, 0.027, 0.0293};
  std::int64_t most = 0;
  const auto free = after({}, {}, rough({}), 1200, &most);
  BOOST_TEST(most > 1);
  for (const V& at :
       {0.5 * period, V{}, V{period[0], 0, 0}, V{1e-4, period[1] - 1e-4, -3e-4}, V{0.01, 0.0269, 0.01}}) {
    for (const V& image :
         {V{}, V{period[0], 0, 0}, V{-period[0], 2 * period[1], 0}, V{0, 0, -3 * period[2]}}) {
      const auto positions = after(at, image, rough(period), 1200, &most);
      double off = 0;
      for (std::size_t i = 0; i < positions.size(); ++i)
        off = std::max(off, norm(positions[i] - free[i]) / d);
      BOOST_TEST(off < 1e-9, "off by " << off << " d");
    }
  }
  // the other directions open
  for (int axis = 0; axis < 3; ++axis) {
    V one{};
    one[axis] = period[axis];
    const auto positions = after({}, 2.0 * one, rough(one), 1200, &most);
    for (std::size_t i = 0; i < positions.size(); ++i) BOOST_TEST(norm(positions[i] - free[i]) < 1e-9 * d);
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_flies_through_the_sides_unhindered) {
  const dem::Chain<3> chain = curled(fiber_of(7), {0.1, 0.2, 0.3});
  const V velocity{7, -5, 3}, period{0.02, 0.021, 0.022};
  dem::Assembly assembly({{chain, {dem::placed(chain, {{0.01, 0.01, 0.01}, {1, 2, 3}, velocity})}}},
                         rough(period), {.step = 5e-6});
  const auto start = assembly.state(0, 0);
  assembly.march(3000);
  BOOST_TEST(assembly.touching() == 0);
  for (std::size_t i = 0; i < start.poses.size(); ++i) {
    BOOST_TEST(norm(assembly.state(0, 0).poses[i].position - start.poses[i].position -
                    assembly.time() * velocity) < 1e-11 * d);
  }
}

/// Longer than the cell and tilted, a fiber meets its own image; momentum stays, the force is Hertz's.
BOOST_AUTO_TEST_CASE(a_fiber_longer_than_the_cell_touches_its_image) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber_of(9));
  dem::Domain around;
  around.period = {6.3 * d, 5 * d, 0};
  const V along = (1 / norm(V{1, 0.13, 0.03})) * V{1, 0.13, 0.03};
  dem::Assembly assembly({{chain, {dem::placed(chain, {{}, along})}}}, around, {});
  int expected = 0;
  for (int i = 0; i <= 9; ++i) {
    for (int j = i + 2; j <= 9; ++j) {
      V r = (j - i) * d * along;
      for (int c : {0, 1}) r[c] -= around.period[c] * std::round(r[c] / around.period[c]);
      expected += norm(r) < d;
    }
  }
  BOOST_TEST(expected > 2);
  BOOST_TEST(assembly.touching() == expected);
  const double k = 4.0 / 3 * 2.6e6 / (2 * (1 - 0.31 * 0.31)) * std::sqrt(d / 4);
  for (const auto& c : assembly.contacts()) {
    BOOST_TEST(norm(c.force) == k * std::pow(c.overlap, 1.5), boost::test_tools::tolerance(1e-9));
  }
  assembly.march(2000);
  V momentum{};
  double size = 0;
  for (const V& v : assembly.state(0, 0).velocity) momentum = momentum + v, size += norm(v);
  BOOST_TEST(size > 0.01);
  BOOST_TEST(norm(momentum) < 1e-12 * size);
}

BOOST_AUTO_TEST_CASE(momentum_of_a_periodic_packing_is_kept) {
  SmallPacking packing = packing_in_a_periodic_box(14, 9);
  packing.around.walls.clear();
  packing.around.gravity = {};
  packing.around.period = {0.0213, 0.0257, 0.029};
  for (std::size_t f = 0; f < 14; ++f) {
    for (V& v : packing.groups[0].fibers[f].velocity)
      v = V{2.0 * std::cos(double(f)), 2.0 * std::sin(double(f)), 1.5};
  }
  dem::Assembly assembly = packing.assembly({});
  const auto momentum = [&](double* size) {
    V sum{};
    for (int g = 0; g < 2; ++g) {
      const double m = dem::sphere_mass(assembly.chain(g).fiber);
      for (int f = 0; f < assembly.fibers(g); ++f) {
        for (const V& v : assembly.state(g, f).velocity) sum = sum + m * v, *size += m * norm(v);
      }
    }
    return sum;
  };
  double size = 0, unused = 0;
  const V before = momentum(&size);
  std::int64_t most = 0;
  for (int n = 0; n < 30; ++n) {
    assembly.march(30);
    most = std::max(most, assembly.touching());
  }
  BOOST_TEST(most > 10);
  BOOST_TEST(norm(momentum(&unused) - before) < 1e-13 * size);
}

/// It would be another wall at every image.
BOOST_AUTO_TEST_CASE(a_wall_across_or_askew_to_a_periodic_side_is_refused) {
  const auto with = [](const V& normal) {
    dem::Domain around = rough({0.031, 0, 0});
    around.walls = {{dem::Plane{{-0.01, -0.01, -0.01}, normal}}};
    return dem::Assembly(colliding({}), around, {.step = 4e-6}).steps();
  };
  const auto names_walls = [](const dem::InvalidKey& error) { return error.key == "walls"; };
  BOOST_CHECK_EXCEPTION(with({1, 0, 0}), dem::InvalidKey, names_walls);
  BOOST_CHECK_EXCEPTION(with({0.6, 0.8, 0}), dem::InvalidKey, names_walls);
  BOOST_TEST(with({0, 0.6, 0.8}) == 0);
}

/// Planar extension presses two fibers across it together: each sphere's drag is carried by its contact.
BOOST_AUTO_TEST_CASE(a_flow_presses_fibers_together_by_its_drag) {
  const dem::Fiber fiber = fiber_of(1);
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double rate = 83, m = dem::sphere_mass(fiber);
  dem::Domain around = rough({});
  const double viscosity = m / 1.9e-3 / dem::stokes_drag({1, {}}, fiber).translation;
  around.fluid = dem::Fluid{viscosity, {dem::planar_extension(-rate)}};
  dem::FiberGroup group{
      chain,
      {dem::placed(chain, {{-0.6 * d, 0, 0}, {0, 0, 1}}), dem::placed(chain, {{0.6 * d, 0, 0}, {0, 0, 1}})}};
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    dem::Assembly assembly({group}, around, {.step = 6e-6, .form = form});
    assembly.march(12000);
    const auto contacts = assembly.contacts();
    BOOST_TEST(contacts.size() == 2u);
    for (const auto& c : contacts) {
      const double x = (d - c.overlap) / 2,
                   drag = dem::stokes_drag(*around.fluid, fiber).translation * rate * x;
      BOOST_TEST(norm(c.force) == drag, boost::test_tools::tolerance(1e-6));
      const double k = 4.0 / 3 * 2.6e6 / (2 * (1 - 0.31 * 0.31)) * std::sqrt(d / 4);
      BOOST_TEST(c.overlap == std::pow(drag / k, 2.0 / 3), boost::test_tools::tolerance(1e-6));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
