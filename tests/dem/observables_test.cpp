// Observables of a packing against closed forms.
#include "dem/analysis/observables.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(observables_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

constexpr double pi = std::numbers::pi;
const V up = (1 / norm(V{0.2, -0.3, 1})) * V{0.2, -0.3, 1};

dem::Chain<3> chain_of(int aspect_ratio) {
  return dem::straight_chain<3>({dem::isotropic_material(2.6e6, 0.3, 1130), 1.7e-3, aspect_ratio});
}

/// Bent evenly by `bend` a bond, twisted by `twist` a bond, somewhere in space.
dem::ChainState<3> bent(const dem::Chain<3>& chain, double bend, double twist) {
  dem::Poses<3> poses = chain.poses;
  const auto somehow = dem::rotation({0.3, 1.1, -2.0});
  V at{0.1, -0.4, 0.2};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double n = static_cast<double>(i);
    poses[i] = {at, somehow * dem::rotation({0, 0, n * bend}) * dem::rotation({n * twist, 0, 0})};
    at = at + rotate(somehow * dem::rotation({0, 0, (n + 0.5) * bend}), V{1.7e-3, 0, 0});
  }
  return dem::at_rest<3>(poses);
}

}  // namespace

BOOST_AUTO_TEST_CASE(bending_is_that_of_the_axes_and_not_the_twist) {
  const auto chain = chain_of(13);
  for (const double bend : {0.0, 1e-9, 0.07, 1.3}) {
    const std::vector<dem::ChainState<3>> fibers{bent(chain, bend, 0.21), bent(chain, 0.5 * bend, -0.4)};
    const dem::Mean axes = dem::bending_angles(chain, fibers), turns = dem::turning_angles(fibers);
    BOOST_TEST(axes.count == 26);
    BOOST_TEST(turns.count == 24);
    BOOST_TEST(std::abs(axes.value() - 0.75 * bend) < 1e-14 + 1e-13 * bend);
    BOOST_TEST(std::abs(turns.value() - 0.75 * bend) < 1e-12);
  }
  // bent at rest: no bending there, and the bond law's own angle elsewhere
  auto curved = chain;
  curved.natural.assign(13, {dem::rotation({0, 0, 0.035}), dem::rotation({0, 0, -0.035})});
  const auto at_rest = bent(chain, 0.07, 0), further = bent(chain, 0.09, 0);
  BOOST_TEST(dem::bending_angle(curved, at_rest.poses, 4) < 1e-14);
  BOOST_TEST(std::abs(dem::bending_angle(curved, further.poses, 4) - 0.02) < 1e-14);
  const auto k = dem::bond_kinematics(curved, further.poses, 4);
  BOOST_TEST(std::abs(std::hypot(k.rotation[1], k.rotation[2]) -
                      dem::bending_angle(curved, further.poses, 4)) < 1e-14);
  BOOST_TEST(dem::Mean{}.value() == 0);
}

BOOST_AUTO_TEST_CASE(heights_are_order_statistics) {
  dem::PlacedSpheres s;
  for (int i = 0; i <= 40; ++i) {
    const double h = 0.25 * ((i * 17) % 41);  // 0, 0.25, ... 10 in some order
    s.position.push_back(h * up + 0.3 * i * cross(up, V{1, 0, 0}));
    s.radius.push_back(0.1);
  }
  const auto h = dem::heights(s, up);
  BOOST_TEST(std::abs(h.highest - 10) < 1e-12);
  BOOST_TEST(std::abs(h.quantile - 9.5) < 1e-12);
  BOOST_TEST(std::abs(h.mean - 5) < 1e-12);
  BOOST_TEST(std::abs(dem::heights(s, up, 0.333).quantile - 3.33) < 1e-12);
  BOOST_TEST(std::abs(dem::heights(s, up, 0).quantile) < 1e-12);
  BOOST_CHECK_THROW(dem::heights({}, up), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::heights(s, up, 1.1), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(slabs_hold_exact_parts_of_spheres) {
  const double R = 0.37;
  BOOST_TEST(std::abs(dem::volume_below(R, 0) - 2.0 / 3 * pi * R * R * R) < 1e-15);
  BOOST_TEST(dem::volume_below(R, -2 * R) == 0);
  BOOST_TEST(std::abs(dem::volume_below(R, 5) - 4.0 / 3 * pi * R * R * R) < 1e-15);
  const double h = 0.11;  // a cap of height c: pi c^2 (3 R - c) / 3
  BOOST_TEST(std::abs(dem::volume_below(R, h - R) - pi * h * h * (3 * R - h) / 3) < 1e-15);

  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 3);
  dem::PlacedSpheres s;
  double total = 0;
  for (int i = 0; i < 50; ++i) {
    s.radius.push_back(0.02 + 0.1 * std::abs(uniform(generator)));
    s.position.push_back(uniform(generator) * up + uniform(generator) * cross(up, V{0, 1, 0}));
    total += 4.0 / 3 * pi * std::pow(s.radius.back(), 3);
  }
  std::vector<double> edges;
  for (double z = -1.5; z < 3.6; z += 0.083 + 0.01 * std::sin(9 * z)) edges.push_back(z);
  const auto fractions = dem::solid_fractions(s, up, 2.9, edges);
  double sum = 0;
  for (std::size_t k = 0; k < fractions.size(); ++k) sum += 2.9 * fractions[k] * (edges[k + 1] - edges[k]);
  BOOST_TEST(std::abs(sum / total - 1) < 1e-13);
  // coarser slabs are sums of finer ones
  const auto whole = dem::solid_fractions(s, up, 2.9, {edges[20], edges[31]});
  double part = 0;
  for (std::size_t k = 20; k < 31; ++k) part += fractions[k] * (edges[k + 1] - edges[k]);
  BOOST_TEST(std::abs(whole[0] * (edges[31] - edges[20]) - part) < 1e-14);
  // a thin slab is a disk
  const auto disk = dem::solid_fractions({{0.5 * up}, {R}}, up, 1, {0.6, 0.6 + 1e-6});
  BOOST_TEST(std::abs(disk[0] / (pi * (R * R - 0.01)) - 1) < 1e-5);
  BOOST_CHECK_THROW(dem::solid_fractions(s, up, 1, {0, 1, 1}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::solid_fractions(s, up, 1, {0}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::solid_fractions(s, up, 0, {0, 1}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(coordination_counts_each_contact_for_both) {
  // fibers 0: spheres 0-2, 1: 3-5, 2: 6, 7
  const std::vector<std::int32_t> fiber_of{0, 0, 0, 1, 1, 1, 2, 2};
  const auto touch = [](std::int64_t a, std::int64_t b) {
    return dem::ContactState{{dem::primitive_of(a), dem::primitive_of(b)}, 1e-6, {}, {}};
  };
  const std::vector<dem::ContactState> contacts{touch(0, 4), touch(4, 1),  touch(2, 0),
                                                touch(5, 7), touch(3, -1), touch(6, -2)};
  const auto c = dem::coordination(contacts, fiber_of);
  BOOST_TEST(c.between_fibers == 3);
  BOOST_TEST(c.within_fibers == 1);
  BOOST_TEST(c.with_walls == 2);
  BOOST_TEST(c.per_sphere == 1.0);
  BOOST_TEST(c.per_fiber == 2.0);
  BOOST_TEST(c.neighbors_per_fiber == 4.0 / 3);
  BOOST_TEST(c.touching_spheres == 6.0 / 8);
  BOOST_CHECK_THROW(dem::coordination(std::vector{touch(0, 8)}, fiber_of), dem::InvalidInput);
  BOOST_TEST(dem::coordination({}, {}).per_sphere == 0);
  const auto chain = chain_of(2);
  const std::vector<dem::FiberGroup> groups{{chain, {bent(chain, 0, 0), bent(chain, 0, 0)}},
                                            {chain_of(1), {bent(chain_of(1), 0, 0)}}};
  BOOST_TEST((dem::fiber_numbers(groups) == fiber_of));
}

BOOST_AUTO_TEST_CASE(orientations_are_moments_and_classes) {
  const auto chain = chain_of(1);
  const auto along = [&](const V& u) { return placed(chain, dem::FiberStart{{0.3, 0.1, -1}, u, {}}); };
  const V side = (1 / norm(cross(up, V{0, 1, 0}))) * cross(up, V{0, 1, 0}), other = cross(up, side);
  dem::Orientations one(up, 9);
  const std::vector<dem::ChainState<3>> up_and_down{along(up), along(-up)};
  one.add(up_and_down);
  BOOST_TEST(std::abs(one.order() - 1) < 1e-12);
  BOOST_TEST(std::abs(one.order_along_up() - 1) < 1e-12);
  BOOST_TEST(one.mean_polar_angle() < 1e-7);
  BOOST_TEST(std::abs(one.against_isotropic()[0] - 1 / (1 - std::cos(pi / 18))) < 1e-9);

  const double theta = 0.83;  // on a cone: <cos^2>
  std::vector<dem::ChainState<3>> cone;
  for (int i = 0; i < 12; ++i) {
    const double phi = 2 * pi * i / 12;
    cone.push_back(
        along(std::cos(theta) * up + std::sin(theta) * (std::cos(phi) * side + std::sin(phi) * other)));
  }
  dem::Orientations two(up, 9);
  two.add(cone);
  BOOST_TEST(two.bonds() == 12);
  const auto a = two.second_moment();
  BOOST_TEST(std::abs(a[0][0] + a[1][1] + a[2][2] - 1) < 1e-13);
  BOOST_TEST(std::abs(two.order_along_up() - (3 * std::pow(std::cos(theta), 2) - 1) / 2) < 1e-12);
  BOOST_TEST(std::abs(two.mean_polar_angle() - theta) < 1e-12);
  const double c2 = std::pow(std::cos(theta), 2);
  const auto principal = two.principal();
  BOOST_TEST(std::abs(principal[0] - std::max(c2, (1 - c2) / 2)) < 1e-12);
  BOOST_TEST(std::abs(principal[2] - std::min(c2, (1 - c2) / 2)) < 1e-12);
  BOOST_TEST(two.against_isotropic()[3] == 0);
  BOOST_TEST(two.against_isotropic()[4] > 5);  // 0.83 rad is 47.6 degrees
}

BOOST_AUTO_TEST_CASE(kinetic_energy_is_of_both_kinds) {
  const auto chain = chain_of(6);
  auto state = bent(chain, 0.1, 0);
  state.velocity.assign(7, {0.1, -0.2, 0.2});
  state.spin.assign(7, {3, 0, -4});
  const std::vector<dem::ChainState<3>> fibers{state, bent(chain, 0.2, 0)};
  const auto energy = dem::kinetic_energy(chain.fiber, fibers);
  const double R = 0.85e-3, m = 4.0 / 3 * pi * R * R * R * 1130;
  BOOST_TEST(std::abs(energy.translation / (7 * 0.5 * m * 0.09) - 1) < 1e-13);
  BOOST_TEST(std::abs(energy.rotation / (7 * 0.2 * m * R * R * 25) - 1) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
