// The chain at the edge of stability, from violent kinks, under huge damping and in denormal numbers.
#include <boost/test/unit_test.hpp>
#include <numbers>
#include <utility>

#include "tests/dem/marching_chains.hpp"
#include "tests/dem/stress_chains.hpp"

BOOST_AUTO_TEST_SUITE(stress_limits_test)

namespace dem = fiberchain::dem;
using dem::BondForm;
using marching::fiber_of;
using marching::largest_speed;
using marching::lone_block;
using std::numbers::pi;

namespace {

/// Growth of the largest speed from a tiny start.
template <int Dim>
double growth(const dem::Fiber& fiber, BondForm form, bool solved, double step_ratio, int steps) {
  const dem::Chain<Dim> chain = dem::straight_chain<Dim>(fiber);
  const double limit = solved ? dem::undamped_time_step(fiber) : dem::stable_time_step(fiber);
  auto block = lone_block(chain, step_ratio * limit, form, solved);
  marching::stir(block, {chain}, 3, 1e-9);
  const double start = largest_speed(block, fiber);
  block.march(steps);
  return largest_speed(block, fiber) / start;
}

void check_limit(double nu, double damping, bool solved) {
  const dem::Fiber fiber = fiber_of(11, nu, damping, dem::BondModel::corrected);
  // beyond the limit dashpots that are solved for let it grow by no more than 0.8/xi_b of the excess a step
  const int beyond = solved ? 3000 + static_cast<int>(2500 * damping) : 3000;
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    BOOST_TEST_CONTEXT(dem::name(form) << " xi_b " << damping << " nu " << nu << " solved " << solved) {
      BOOST_TEST(growth<2>(fiber, form, solved, 0.999, 10000) < 100);
      BOOST_TEST(growth<3>(fiber, form, solved, 0.999, 10000) < 100);
      BOOST_TEST(growth<2>(fiber, form, solved, 1.01, beyond) > 1e4);
      BOOST_TEST(growth<3>(fiber, form, solved, 1.01, beyond) > 1e4);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(steps_up_to_the_limit_are_stable_and_beyond_are_not) {
  for (const double nu : {-0.2, 0.43}) {
    for (const double damping : {0.0, 0.25, 10.0}) check_limit(nu, damping, false);
    for (const double damping : {0.25, 10.0}) check_limit(nu, damping, true);
  }
}

namespace {

/// Neighboring bonds at 150 degrees to each other, in the plane a zigzag, in space each about an axis of its
/// own; every sphere looks along the mean of its bonds.
dem::Chain<2> zigzag(const dem::Fiber& fiber) {
  dem::Chain<2> chain = dem::straight_chain<2>(fiber);
  const double half = 75 * pi / 180, l = dem::bond_length(fiber);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    chain.poses[i].position = {i * l * std::cos(half), i % 2 * l * std::sin(half)};
  }
  return chain;
}

dem::Chain<3> crumpled(const dem::Fiber& fiber, unsigned seed) {
  using Vector = dem::Vec<double, 3>;
  dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const Vector x{1, 0, 0};
  Vector direction = x, before = x;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    if (i > 0) chain.poses[i].position = chain.poses[i - 1].position + dem::bond_length(fiber) * before;
    const Vector mean = dem::unit(i < fiber.aspect_ratio ? before + direction : before);
    auto turn = dem::normalized(dem::Quaternion<double>{1 + dem::dot(x, mean), dem::cross(x, mean)});
    if (i > 0 &&
        turn.w * chain.poses[i - 1].orientation.w + dem::dot(turn.v, chain.poses[i - 1].orientation.v) < 0) {
      turn = {-turn.w, -turn.v};
    }
    chain.poses[i].orientation = turn;
    before = direction;
    Vector axis{normal(generator), normal(generator), normal(generator)};
    axis = dem::unit(axis - dem::dot(axis, direction) * direction);
    direction = dem::rotate(dem::rotation((150 * pi / 180) * axis), direction);
  }
  return chain;
}

template <int Dim>
double total_energy(const dem::ChainBatch<Dim>& block, const dem::Chain<Dim>& chain, double dt) {
  return marching::kinetic_energy(block, chain.fiber, dt, 0) +
         marching::elastic_energy(block, chain, BondForm::total, 0);
}

/// Largest |energy / first energy - 1| of an undamped chain in 300 t_b.
double energy_error(const dem::Chain<3>& chain, double step_ratio) {
  const double dt = step_ratio * dem::stable_time_step(chain.fiber);
  auto block = lone_block(chain, dt, BondForm::total);
  const double start = total_energy(block, chain, dt);
  double largest = 0;
  for (double t = 0; t < 300 * dem::bond_time_step(chain.fiber); t += 3 * dt) {
    block.march(3);
    largest = std::max(largest, std::abs(total_energy(block, chain, dt) / start - 1));
  }
  return largest;
}

/// Energy left of a damped chain after `times` t_b, over that at the start, and its angular momentum in m
/// l^2/t_b.
template <int Dim>
std::pair<double, double> settled(const dem::Chain<Dim>& chain, double times) {
  const dem::Fiber& fiber = chain.fiber;
  const double dt = 0.2 * dem::stable_time_step(fiber);
  auto block = lone_block(chain, dt, BondForm::total);
  const double start = total_energy(block, chain, dt), l = dem::bond_length(fiber);
  block.march(static_cast<int>(times * dem::bond_time_step(fiber) / dt));
  const double unit = dem::sphere_mass(fiber) * l * l / dem::bond_time_step(fiber);
  return {total_energy(block, chain, dt) / start, dem::norm(marching::account(block, fiber).angular) / unit};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_crumpled_chain_keeps_its_energy_at_second_order_in_the_step) {
  const dem::Fiber fiber = fiber_of(9, 0.3, 0);
  for (const unsigned seed : {1, 2, 3}) {
    const dem::Chain<3> chain = crumpled(fiber, seed);
    const double stored = dem::elastic_energy(chain, chain.poses);
    BOOST_TEST(stored >
               dem::bond_stiffness(fiber).stretch * std::pow(dem::bond_length(fiber), 2));  // violent
    const double coarse = energy_error(chain, 0.2), fine = energy_error(chain, 0.05);
    BOOST_TEST(coarse < 0.02);
    BOOST_TEST(std::log2(coarse / fine) / 2 > 1.5);
    BOOST_TEST(std::log2(coarse / fine) / 2 < 2.5);
  }
}

BOOST_AUTO_TEST_CASE(a_kinked_chain_comes_to_rest_straight) {
  const dem::Fiber fiber = fiber_of(9, 0.3, 0.5);
  const auto [planar, spin] = settled(zigzag(fiber), 2000);
  BOOST_TEST(planar < 1e-12);
  BOOST_TEST(spin < 1e-12);
  for (const unsigned seed : {1, 2, 3}) {
    const auto [left, turning] = settled(crumpled(fiber, seed), 4000);
    BOOST_TEST(left < 1e-3);
    BOOST_TEST(turning < 1e-12);
  }
}

// xi_b = 1000, at 0.999 of its own limit: all that is slow creeps back as exp(-t K/c), K/c = 1/(sqrt(2) xi_b
// t_b) for stretch, with the inertia's part m K/c^2 = 1/(2 xi_b^2) left out.
BOOST_AUTO_TEST_CASE(huge_damping_creeps_as_springs_and_dashpots_alone_do) {
  const dem::Fiber fiber = fiber_of(3, 0.3, 1000);
  const double dt = 0.999 * dem::stable_time_step(fiber), l = dem::bond_length(fiber);
  dem::Chain<2> chain = dem::straight_chain<2>(fiber);
  for (int i = 0; i <= 3; ++i) chain.poses[i].position[0] *= 1.001;
  auto block = lone_block(chain, dt, BondForm::total);
  const auto stretch = [&] {
    return (block.sphere(0, 3).pose.position[0] - block.sphere(0, 0).pose.position[0]) / (3 * l) - 1;
  };
  block.march(20000);  // the start from rest dies out at once
  const double first = stretch();
  const int steps = 2000000;
  block.march(steps);
  const double rate = 1 / (std::sqrt(2.0) * 1000 * dem::bond_time_step(fiber));
  BOOST_TEST(first > 0.00098);
  BOOST_TEST(first < 0.001);
  BOOST_TEST(std::log(first / stretch()) / (rate * steps * dt) == 1, boost::test_tools::tolerance(1e-4));
}

// Velocities of 1e-310 bond lengths a second are denormal, and so are strains and forces.
BOOST_AUTO_TEST_CASE(denormal_motion_stays_bounded) {
  for (const double damping : {0.0, 0.4}) {
    const dem::Fiber fiber = fiber_of(5, 0.17, damping);
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    auto block = lone_block(chain, 0.5 * dem::stable_time_step(fiber), BondForm::incremental);
    marching::stir(block, {chain}, 7, 1e-310 * dem::bond_time_step(fiber) / dem::bond_length(fiber));
    const double start = largest_speed(block, fiber);
    BOOST_REQUIRE(start > 0);
    BOOST_REQUIRE(start < 100 * std::numeric_limits<double>::min());
    double largest = 0;
    for (int n = 0; n < 100; ++n) {
      block.march(200);
      const double speed = largest_speed(block, fiber);
      BOOST_REQUIRE(std::isfinite(speed));
      largest = std::max(largest, speed);
    }
    BOOST_TEST(largest < 10 * start);
    if (damping > 0) BOOST_TEST(largest_speed(block, fiber) < start);
    for (int i = 1; i <= 5; ++i) {
      // too small to move anything: not a bit of the positions changes
      BOOST_TEST(block.sphere(0, i).pose.position[0] == chain.poses[i].position[0]);
      BOOST_TEST(block.sphere(0, i).pose.orientation.w == 1);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
