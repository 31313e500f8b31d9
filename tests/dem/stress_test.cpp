// The chain driven to its limits: many steps, many turns, many bonds, soft and stiff. The long versions are
// in stress_slow_test.cpp, the edge of stability and violent starts in stress_limits_test.cpp.
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "tests/dem/energy_drift.hpp"
#include "tests/dem/stress_chains.hpp"
#include "tests/dem/tumbling.hpp"

BOOST_AUTO_TEST_SUITE(stress_test)

namespace dem = fiberchain::dem;
using dem::BondForm;
using marching::fiber_of;
using marching::lone_block;
using std::numbers::pi;

// The total form has an energy, and leapfrog is symplectic for it: the energy is off by a constant of order
// dt^2 and does not drift. The slow test has 1e8 steps.
BOOST_AUTO_TEST_CASE(energy_of_the_total_form_is_off_at_second_order_and_does_not_drift) {
  const auto drift = marching::energy_drift<3>(BondForm::total, {0.4, 0.2, 0.1}, 2e5, 0.03);
  for (const marching::EnergyDrift& d : drift) {
    // modes exchange energy slowly: the last tenth of the run is off by 0.10 from the second at most; other
    // starts (12 seeds) by 0.03 at the largest step, 0.10 at the middle one, 0.6 at the smallest
    BOOST_TEST(std::abs(d.mean.back() / d.mean[1] - 1) < 0.12);
    // the offset swings about its mean: 1.72 to 1.88 here, 1.28 to 1.97 from other starts
    BOOST_TEST(d.largest < 2 * d.mean[1]);
    BOOST_TEST(d.largest > 1.6 * d.mean[1]);
    BOOST_TEST(d.momentum < 1e-13);
    BOOST_TEST(d.angular < 1e-13);
  }
  const double order = std::log2(drift[1].mean[5] / drift[2].mean[5]);
  BOOST_TEST(order > 1.85);  // 1.99; from other starts 1.85 to 2.21
  BOOST_TEST(order < 2.2);
}

// The incremental form is no derivative of an energy: what it stores depends on the path, and drifts. It must
// drift slowly at a small step, and only there.
BOOST_AUTO_TEST_CASE(energy_of_the_incremental_form_stays_bounded_at_a_small_step) {
  const auto drift =
      marching::energy_drift<3>(BondForm::incremental, {0.1, 0.05}, 2e5, 0.03, dem::BondModel::corrected);
  for (const marching::EnergyDrift& d : drift) BOOST_TEST(d.angular < 1e-13);
  // 1.6e-3 here, 1.1e-3 to 3.1e-3 from other starts (12 seeds), and of second order in the step: 1.9 to 2.11
  BOOST_TEST(drift[0].largest < 0.0033);
  BOOST_TEST(drift[0].largest > 0.001);
  BOOST_TEST(std::abs(std::log2(drift[0].largest / drift[1].largest) - 2) < 0.15);
}

BOOST_AUTO_TEST_CASE(a_tumbling_fiber_is_stretched_by_its_rotation_and_by_nothing_else) {
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    const double bound =
        form == BondForm::total ? 1e-9 : 5e-5;  // increments drift at second order while it speeds up
    for (const auto& t : {marching::tumble<2>(form, 200, 0.5), marching::tumble<3>(form, 200, 0.5)}) {
      BOOST_TEST(t.turns > 180);
      BOOST_TEST(t.strain > 0.01);
      BOOST_TEST(t.stretch < bound);
      BOOST_TEST(t.slowing < 1e-13);
      BOOST_TEST(t.momentum < 1e-13);
    }
  }
}

// Lowest axial and twisting wave of a free chain of 1001 spheres, velocities A cos(Omega (n - 1/2)
// dt)/cos(Omega dt/2) with sin(Omega dt/2) = omega dt/2: leapfrog's own frequency.
BOOST_AUTO_TEST_CASE(a_thousand_bonds_swing_at_their_frequency) {
  const dem::Fiber fiber = fiber_of(1000, 0.17, 0);
  const double dt = 0.7 * dem::stable_time_step(fiber), wave = pi / (fiber.aspect_ratio + 1);
  const double rate = 1e-6 / dem::bond_time_step(fiber);
  const dem::BondStiffness k = dem::bond_stiffness(fiber);
  for (const bool twist : {false, true}) {
    auto block = lone_block(dem::straight_chain<3>(fiber), dt, BondForm::incremental);
    for (int i = 0; i <= fiber.aspect_ratio; ++i) {
      auto sphere = block.sphere(0, i);
      const double shape = std::cos(wave * (i + 0.5));
      (twist ? sphere.spin[0] : sphere.velocity[0]) = rate * shape * (twist ? 1 : dem::bond_length(fiber));
      block.set_sphere(0, i, sphere);
    }
    const int steps = 20000;
    block.march(steps);
    const double omega =
        2 * std::sin(wave / 2) *
        std::sqrt(twist ? k.twist / dem::sphere_inertia(fiber) : k.stretch / dem::sphere_mass(fiber));
    const double half = std::asin(omega * dt / 2);
    const double expected = std::cos((2 * steps - 1) * half) / std::cos(half);
    for (const int i : {0, 211, 1000}) {
      const auto sphere = block.sphere(0, i);
      const double found =
          twist ? sphere.spin[0] / rate : sphere.velocity[0] / (rate * dem::bond_length(fiber));
      BOOST_TEST(std::abs(found - expected * std::cos(wave * (i + 0.5))) < 1e-5,
                 twist << ' ' << i << ": " << found);
    }
  }
}

namespace {

/// Positions over l after some wild motion, everything in units of l and t_b the same.
template <int Dim>
std::vector<double> wild_positions(double modulus, BondForm form, double damping) {
  dem::Fiber fiber = fiber_of(7, 0.3, damping);
  fiber.material = dem::isotropic_material(modulus, 0.3, 431);
  const dem::Chain<Dim> chain = dem::straight_chain<Dim>(fiber);
  auto block = lone_block(chain, 0.125 * dem::bond_time_step(fiber), form);
  marching::stir(block, {chain}, 5, 0.03);
  block.march(2000);
  std::vector<double> positions;
  for (const auto& pose : block.poses(0)) {
    for (const double x : pose.position.c) positions.push_back(x / dem::bond_length(fiber));
  }
  return positions;
}

template <int Dim>
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

template <int Dim>
void check_moduli() {
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    for (const double damping : {0.0, 0.4}) {
      const auto soft = wild_positions<Dim>(1e3, form, damping);
      BOOST_TEST(largest_difference<Dim>(soft, wild_positions<Dim>(1e3, form, damping + 0.01)) > 1e-4);
      // powers of 4 scale every time and speed by powers of 2: not a bit differs
      BOOST_TEST(largest_difference<Dim>(soft, wild_positions<Dim>(std::ldexp(1e3, 30), form, damping)) == 0);
      for (const double modulus : {2.6e6, 1e9, 1e12}) {
        BOOST_TEST(largest_difference<Dim>(soft, wild_positions<Dim>(modulus, form, damping)) < 1e-9,
                   modulus);
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(modulus_from_kilopascal_to_terapascal_changes_nothing_but_the_units) {
  check_moduli<2>();
  check_moduli<3>();
}

BOOST_AUTO_TEST_SUITE_END()
