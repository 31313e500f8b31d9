#define BOOST_TEST_MODULE maxwell_bond
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <complex>

#include "dem/assembly/packing_law.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/extensions/maxwell_bond.hpp"
#include "tests/dem/small_packing.hpp"

// A bond law from outside of the library: one Maxwell branch beside each spring.
namespace dem = fiberchain::dem;
using scenes::V;

namespace {

constexpr double g = 0.7, tau_over_t_b = 3.1;

/// g and tau, by the bond's own time.
dem::Fiber viscoelastic(dem::Fiber fiber) {
  fiber.law_parameters = {g, tau_over_t_b * dem::bond_time_step(fiber), 0};
  return fiber;
}

dem::AssemblyOptions maxwell(dem::InstructionSet set = dem::best_instruction_set()) {
  return {.law = &dem::outside_law<dem::maxwell_form>, .instruction_set = set};
}

/// Two spheres that part along their axis, as fast as the bond stretches by about a thousandth.
dem::FiberGroup parting(const dem::Fiber& fiber, int count) {
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  const double speed = 1e-3 * fiber.diameter / dem::bond_time_step(fiber);
  for (int f = 0; f < count; ++f) {
    dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
    scenes::move(state, {0, 5.0 * f * fiber.diameter, 0});
    state.velocity[0] = {-speed, 0, 0}, state.velocity[1] = {speed, 0, 0};
    group.fibers.push_back(state);
  }
  return group;
}

/// Stretch after a time of x'' = -2 K/m (x + g z), z' = x' - z / tau from x = z = 0, by the eigenvalues of
/// the linear system.
double exact_stretch(const dem::Fiber& fiber, double speed_apart, double time) {
  const double omega_squared = 2 * dem::bond_stiffness(fiber).stretch / dem::sphere_mass(fiber);
  Eigen::Matrix3d A;
  A << 0, 1, 0, -omega_squared, 0, -g * omega_squared, 0, 1, -1 / fiber.law_parameters[1];
  const Eigen::EigenSolver<Eigen::Matrix3d> modes(A);
  const Eigen::Vector3cd start = Eigen::Vector3d(0, speed_apart, 0).cast<std::complex<double>>();
  const Eigen::Vector3cd part = modes.eigenvectors().partialPivLu().solve(start);
  std::complex<double> x = 0;
  for (int k = 0; k < 3; ++k)
    x += modes.eigenvectors()(0, k) * part[k] * std::exp(modes.eigenvalues()[k] * time);
  return x.real();
}

/// Largest error of the stretch over a few periods, over the largest stretch.
double stretch_error(double step_ratio) {
  const dem::Fiber fiber = viscoelastic(scenes::odd_fiber(1));
  const dem::FiberGroup group = parting(fiber, 3);
  dem::AssemblyOptions options = maxwell();
  options.step = step_ratio * dem::bond_time_step(fiber);
  dem::Assembly assembly({group}, {}, options);
  const double speed = 2 * group.fibers[0].velocity[1][0];
  double worst = 0, largest = 0;
  for (const int end = static_cast<int>(20 / step_ratio); assembly.steps() < end;) {
    assembly.march(std::max(1, end / 40));
    const double exact = exact_stretch(fiber, speed, assembly.time());
    const dem::ChainState<3> state = assembly.state(0, 2);
    const double stretch = norm(state.poses[1].position - state.poses[0].position) - dem::bond_length(fiber);
    worst = std::max(worst, std::abs(stretch - exact)), largest = std::max(largest, std::abs(exact));
  }
  return worst / largest;
}

}  // namespace

// Bent at a constant rate for a time T, then held: Boltzmann's integral of G gives K (1 + g (1 - exp(-T/tau))
// tau/T exp(-t/tau)).
BOOST_AUTO_TEST_CASE(held_bend_relaxes_as_the_standard_linear_solid) {
  const dem::Fiber fiber = viscoelastic(scenes::odd_fiber(1));
  const dem::BondParameters<double> bond = dem::bond_parameters(fiber);
  const double tau = fiber.law_parameters[1], angle = 1e-3, T = 0.2 * tau, l = dem::bond_length(fiber);
  const double bent = -std::expm1(-T / tau) * tau / T;
  for (const double dt : {0.03 * tau, 0.7 * tau}) {
    dem::MaxwellBond::History<double, 3> history{};
    const dem::Vec<double, 3> along{l, 0, 0};
    const dem::Pose<double, 3> unused{};
    const auto line = dem::bond_vector(along, 1 / l);
    dem::RelativeMotion<double, 3> motion{{}, {}, {0, 0, angle / T}};
    const dem::BondConfiguration<double, 3> now{unused, unused, line, motion};
    dem::MaxwellBond::advance(bond, history, now, T);
    motion = {};
    for (int n = 0; n <= 5; ++n) {
      const double moment = dem::MaxwellBond::action<false>(bond, history, now).moment[2];
      BOOST_TEST(moment == bond.bend * angle * (1 + g * bent * std::exp(-n * dt / tau)),
                 boost::test_tools::tolerance(1e-11));
      dem::MaxwellBond::advance(bond, history, now, dt);
    }
  }
}

BOOST_AUTO_TEST_CASE(two_spheres_ring_down_as_the_linear_system_second_order_in_the_step) {
  const double coarse = stretch_error(0.1), fine = stretch_error(0.05);
  BOOST_TEST(fine < 5e-3);
  BOOST_TEST(coarse / fine > 3.0);
}

BOOST_AUTO_TEST_CASE(energy_of_a_ring_down_goes_where_the_law_says) {
  const dem::Fiber fiber = viscoelastic(scenes::odd_fiber(4));
  const dem::FiberGroup group = scenes::scattered(dem::straight_chain<3>(fiber), 9, 1e-3, 3);
  dem::AssemblyOptions options = maxwell();
  options.account_energy = true;
  options.step = 0.05 * dem::bond_time_step(fiber);
  dem::Assembly assembly({group}, {}, options);
  const double before = total(assembly.energy());
  assembly.march(400);
  const dem::EnergyBalance after = assembly.energy();
  BOOST_TEST(after.bond_damping > 0.2 * before);
  BOOST_TEST(std::abs(total(after) - before) < 2e-3 * before);
}

BOOST_AUTO_TEST_CASE(packing_with_contacts_goes_on_from_its_saved_state_to_the_bit) {
  scenes::SmallPacking packing = scenes::packing_in_a_box(12, 9);
  for (dem::FiberGroup& group : packing.groups) group.chain.fiber = viscoelastic(group.chain.fiber);
  dem::Assembly through = packing.assembly(maxwell()), again = packing.assembly(maxwell());
  through.march(300);
  const dem::SavedState saved = through.saved();
  through.march(300);
  BOOST_TEST(through.touching() > 0);
  again.restore(saved);
  again.march(300);
  BOOST_TEST(scenes::numbers(again) == scenes::numbers(through), boost::test_tools::per_element());
  dem::Assembly elastic = packing.assembly({});
  elastic.march(600);
  BOOST_TEST((scenes::numbers(elastic) != scenes::numbers(through)));
}

BOOST_AUTO_TEST_CASE(stable_step_is_that_of_the_stiffer_bonds) {
  const dem::FiberGroup group = parting(viscoelastic(scenes::odd_fiber(1)), 1);
  const double plain = dem::assembly_time_step({group}, {}).bonds,
               stiffer = dem::assembly_time_step({group}, {}, maxwell()).bonds;
  BOOST_TEST(stiffer * std::sqrt(1 + g) == plain, boost::test_tools::tolerance(1e-12));
}
