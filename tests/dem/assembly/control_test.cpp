// Gravity and walls that are changed between steps.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(control_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

/// Fibers across each other between a floor and a plate, at rest, none touches.
std::vector<dem::FiberGroup> layers(int count) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber_with(7));
  const double d = chain.fiber.diameter;
  dem::FiberGroup group{chain, {}};
  for (int n = 0; n < count; ++n) {
    const double z = d * (0.8 + 1.2 * n);
    group.fibers.push_back(n % 2 == 0 ? dem::placed(chain, {{-3.5 * d, 0.13 * d * n, z}, {1, 0, 0}, {}})
                                      : dem::placed(chain, {{0.2 * d, -3.5 * d, z}, {0, 1, 0}, {}}));
  }
  return {group};
}

dem::Wall floor_wall() { return {.shape = dem::Plane{{0, 0, 0}, {0, 0, 1}}}; }

dem::Wall plate(double height, double speed) {
  return {.shape = dem::Plane{{0, 0, height}, {0, 0, -1}}, .velocity = {0, 0, speed}, .name = "plate"};
}

dem::Domain between(const dem::Wall& plate) {
  dem::Domain domain;
  domain.walls = {floor_wall(), plate};
  domain.contacts.friction = 0.3;
  domain.contacts.restitution = 0.4;
  return domain;
}

V middle(const dem::Assembly& assembly) {
  V sum{};
  const auto all = assembly.placed().position;
  for (const V& at : all) sum = sum + (1.0 / static_cast<double>(all.size())) * at;
  return sum;
}

void check_equal(const dem::Assembly& one, const dem::Assembly& other, double tolerance) {
  const auto a = one.placed().position, b = other.placed().position;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a[i] - b[i]));
  BOOST_TEST(most <= tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(fibers_fall_as_gravity_is_changed) {
  const V first{0.7, 0, -1.3}, second{0, 2.9, 0};
  dem::Domain domain;
  domain.gravity = first;
  dem::Assembly assembly(layers(1), domain, {.account_energy = true});
  const V start = middle(assembly);
  const double dt = assembly.step();
  constexpr int N = 300, M = 170;
  assembly.march(N);
  const double before = total(assembly.energy());
  assembly.set_gravity(second);
  BOOST_TEST(std::abs(total(assembly.energy()) - before) <= 1e-9 * assembly.energy().kinetic);
  assembly.march(M);
  // the leapfrog's own sums: half a kick at the begin, whole ones from then on
  const V moved = middle(assembly) - start;
  for (int c = 0; c < 3; ++c) {
    const double expected =
        dt * dt * (first[c] * (0.5 * N * N + (N - 0.5) * M) + second[c] * 0.5 * M * (M + 1.0));
    within(moved[c], expected, 1e-8 * dt * dt * N * N, "moved");
  }
  BOOST_CHECK_THROW(assembly.set_gravity({0, 0, std::nan("")}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(a_wall_set_going_at_the_start_is_one_that_goes) {
  const double d = 1.66e-3, height = 8 * d, step = 2e-6;
  dem::Assembly one(layers(5), between(plate(height, -1.1)), {.step = step}),
      other(layers(5), between(plate(height, 0)), {.step = step});
  other.set_wall_velocity(1, {0, 0, -1.1});
  one.march(3000), other.march(3000);
  BOOST_TEST(one.wall_samples()[1].force_peak > 0);
  check_equal(one, other, 0);
}

BOOST_AUTO_TEST_CASE(a_wall_goes_on_from_where_it_is) {
  const double d = 1.66e-3, height = 8 * d, step = 2e-6;
  dem::Assembly assembly(layers(5), between(plate(height, 0)), {.step = step});
  double expected = height;
  // it stops, returns, and rests for long: the neighbor list must know where
  for (const double speed : {-1.5, 0.0, 0.9, -2.0, 0.0}) {
    assembly.set_wall_velocity(1, {0, 0, speed});
    assembly.march(700);
    expected += speed * 700 * step;
    const V center = assembly.wall_samples()[1].center;
    within(center[2], expected, 1e-12, "place");
  }
  // fibers are between the walls, none has gone through
  for (const V& at : assembly.placed().position) BOOST_TEST((at[2] > 0 && at[2] < expected));
  BOOST_TEST(assembly.wall_samples()[1].force_peak > 0);
}

BOOST_AUTO_TEST_CASE(forces_after_a_change_are_those_of_a_wall_that_was_there) {
  // without friction and history: a plate that presses at rest, put there in two ways
  const double d = 1.66e-3, height = 8 * d, step = 2e-6, down = -3 * d;
  auto domain = between(plate(height, 0));
  domain.contacts.friction = 0;
  auto lower = between(plate(height + down, 0));
  lower.contacts.friction = 0;
  dem::Assembly moved(layers(4), domain, {.step = step}), there(layers(4), lower, {.step = step});
  moved.shift_wall(1, {0, 0, down});
  for (dem::Assembly* each : {&moved, &there}) {
    each->set_gravity({0, 0, 200});
    each->march(4000);
  }
  BOOST_TEST(there.wall_samples()[1].force_peak > 0);
  check_equal(moved, there, 1e-12);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const double d = 1.66e-3;
  dem::Assembly assembly(layers(3), between(plate(8 * d, 0)), {}),
      accounted(layers(3), between(plate(8 * d, 0)), {.account_energy = true});
  BOOST_CHECK_THROW(assembly.set_wall_velocity(2, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(assembly.set_wall_velocity(-1, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(assembly.set_wall_velocity(1, {0, std::numeric_limits<double>::infinity(), 0}),
                    dem::InvalidInput);
  BOOST_CHECK_EXCEPTION(assembly.shift_wall(1, {0, 0, -7 * d}), dem::InvalidInput, [](const auto& error) {
    return std::string(error.what()).find("would be behind it") != std::string::npos;
  });
  within(assembly.wall_samples()[1].center[2], 8 * d, 1e-15, "place after a refusal");
  BOOST_CHECK_THROW(accounted.shift_wall(1, {0, 0, -d}), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
