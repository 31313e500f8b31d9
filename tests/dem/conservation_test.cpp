// Free chains in wild motion: what bonds and dashpots do to a chain as a whole is nothing, in every sphere's
// account.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/dem/free_motion.hpp"
#include "tests/dem/marching_chains.hpp"

BOOST_AUTO_TEST_SUITE(conservation_test)

namespace dem = fiberchain::dem;

namespace {

using marching::account;
using marching::Account;

template <int Dim>
void conserves(const dem::Physics& physics, double damping, dem::MassModel mass) {
  std::vector<dem::Chain<Dim>> chains{marching::odd_chain<Dim>(21, damping, physics.curved)};
  chains[0].fiber.mass = mass;
  const dem::Fiber& fiber = chains[0].fiber;
  auto block = marching::block_of(chains, {false, false}, physics, dem::InstructionSet::scalar);
  marching::stir(block, chains, 9, 0.05);
  const Account<Dim> before = account(block, fiber);
  block.march(1);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const auto sphere = block.sphere(0, i);
    BOOST_TEST(dem::norm(sphere.force) > 0);
    BOOST_TEST(dem::norm(sphere.moment) > 0);
  }
  block.march(1999);
  const Account<Dim> after = account(block, fiber);
  BOOST_TEST(dem::norm(after.momentum - before.momentum) / before.momentum_scale < 1e-13);
  BOOST_TEST(dem::norm(after.angular - before.angular) / before.angular_scale < 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_CASE(momentum_and_angular_momentum_are_conserved_to_round_off) {
  for (const dem::Physics& physics : dem::built_physics) {
    if (physics.settling_damping || physics.fluid) continue;
    BOOST_TEST_CONTEXT(physics.dimension << "D " << dem::name(physics.form) << " damped " << physics.damped) {
      const double damping = physics.damped ? 0.4 : 0.0;
      for (const auto mass : {dem::MassModel::spheres, dem::MassModel::cylinder})
        physics.dimension == 2 ? conserves<2>(physics, damping, mass) : conserves<3>(physics, damping, mass);
    }
  }
}

namespace {

constexpr double turns = 20;

/// Drift of the stored strain of a bent, twisted bond carried around rigidly, relative to its size.
double spatial_drift(int steps_per_turn) {
  const double omega = 2 * std::numbers::pi, dt = 1.0 / steps_per_turn;
  const dem::Vec<double, 3> axis{0.48, 0.6, 0.64}, separation{0.03, -0.01, 0.02};
  const dem::BondHistory<double, 3> start{{1e-4, 3e-4, -2e-4}, {0.02, -0.05, 0.07}};
  dem::BondHistory<double, 3> history = start;
  const int steps = static_cast<int>(turns * steps_per_turn);
  const auto at = [&](int n) { return dem::rotate(dem::rotation((omega * n * dt) * axis), separation); };
  for (int n = 0; n < steps; ++n) {
    const dem::RelativeMotion<double, 3> motion{(1 / dt) * (at(n + 1) - at(n)), omega * axis, {0, 0, 0}};
    dem::advance(history, dem::bond_vector(at(n + 1), 1 / dem::norm(at(0))), motion, dt);
  }
  return std::max(dem::norm(history.displacement - start.displacement) / dem::norm(start.displacement),
                  dem::norm(history.rotation - start.rotation) / dem::norm(start.rotation));
}

double planar_drift(int steps_per_turn) {
  const double omega = 2 * std::numbers::pi, dt = 1.0 / steps_per_turn;
  const auto at = [&](int n) {
    return dem::Vec<double, 2>{0.03 * std::cos(omega * n * dt), 0.03 * std::sin(omega * n * dt)};
  };
  const dem::BondHistory<double, 2> start{1e-4, 3e-4, {0.05}};
  dem::BondHistory<double, 2> history = start;
  for (int n = 0; n < static_cast<int>(turns * steps_per_turn); ++n) {
    const dem::RelativeMotion<double, 2> motion{(1 / dt) * (at(n + 1) - at(n)), {omega}, {0}};
    dem::advance(history, dem::bond_vector(at(n + 1), 1 / dem::norm(at(0))), motion, dt);
  }
  return std::max(std::abs(history.shear - start.shear), std::abs(history.stretch - start.stretch)) / 0.03;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stored_strain_of_a_rigidly_turning_fiber_drifts_at_second_order_in_the_step) {
  for (const auto drift : {spatial_drift, planar_drift}) {
    const double coarse = drift(200), fine = drift(400);
    BOOST_TEST_MESSAGE("drift over 20 turns at 200 steps a turn: " << coarse);
    BOOST_TEST(std::log2(coarse / fine) > 1.9);
    BOOST_TEST(std::log2(coarse / fine) < 2.1);
  }
}

BOOST_AUTO_TEST_CASE(total_form_forces_of_a_rigidly_turned_fiber_do_not_change) {
  const dem::Fiber fiber = marching::odd_fiber(21, 0);
  const auto bond = dem::bond_parameters(fiber);
  const double l = dem::bond_length(fiber);
  const dem::Pose<double, 3> first{{0, 0, 0}, dem::rotation({0.1, -0.2, 0.05})};
  const dem::Pose<double, 3> second{{0.98 * l, 0.05 * l, -0.1 * l}, dem::rotation({0.4, 0.1, -0.3})};
  const auto loads = [&](const dem::Quaternion<double>& turn) {
    const auto k = dem::bond_kinematics(
        dem::Pose<double, 3>{dem::rotate(turn, first.position), turn * first.orientation},
        dem::Pose<double, 3>{dem::rotate(turn, second.position), turn * second.orientation});
    return dem::bond_loads(k, dem::bond_stress<double, 3>(bond, k.separation, k.rotation));
  };
  const auto still = loads({1, {0, 0, 0}});
  dem::Quaternion<double> turn{1, {0, 0, 0}};
  const dem::Quaternion<double> step = dem::rotation({0.3, -0.17, 0.21});
  for (int n = 0; n < 500; ++n) {
    turn = dem::normalized(step * turn);
    const auto now = loads(turn);
    const auto back = [&](const dem::Vec<double, 3>& u) { return dem::rotate(dem::conjugate(turn), u); };
    BOOST_TEST(dem::norm(back(now.force_on_first) - still.force_on_first) < 1e-13 * bond.stretch * l);
    BOOST_TEST(dem::norm(back(now.moment_on_first) - still.moment_on_first) < 1e-13 * bond.stretch * l * l);
    BOOST_TEST(dem::norm(back(now.moment_on_second) - still.moment_on_second) < 1e-13 * bond.stretch * l * l);
  }
}

BOOST_AUTO_TEST_SUITE_END()
