// Fibers that weigh what a cylinder does: their mass, their frequencies, and every integrator's energy.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/chain/residual.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/motion/time_step.hpp"
#include "dem/vibration/first_mode.hpp"
#include "dem/vibration/release.hpp"
#include "reference/chain_modes.hpp"
#include "reference/damped_beam.hpp"
#include "tests/dem/swinging_fiber.hpp"

BOOST_AUTO_TEST_SUITE(cylinder_mass_test)

namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;
using V = dem::Vec<double, 3>;

namespace {

dem::Fiber fiber(int bonds, dem::BondModel model = dem::BondModel::corrected) {
  dem::Fiber fiber{dem::isotropic_material(3.1e6, 0.17, 1300), 1.3e-3, bonds, model};
  fiber.mass = dem::MassModel::cylinder;
  return fiber;
}

double beam_frequency(const dem::Fiber& f) {
  const double R = f.diameter / 2, L = dem::fiber_length(f),
               mu = f.material.density * std::numbers::pi * R * R;
  return std::pow(reference::clamped_free_beta(1) / L, 2) * std::sqrt(dem::bending_stiffness(f) / mu);
}

/// Two thirds of the way out of its rest shape.
template <int Dim>
dem::Release<Dim> bent_release(const dem::Fiber& f) {
  const dem::FirstMode mode = dem::first_mode(f);
  dem::Release<Dim> release{dem::straight_chain<Dim>(f), {}, {}, {}, mode.period, 3};
  dem::Load<Dim> pull{f.aspect_ratio, {}, {}};
  pull.force[1] = dem::load_force(f, 1.3);
  release.start = dem::solve_equilibrium<Dim>(release.chain, {{0}, {pull}}).poses;
  return release;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_weighs_what_its_cylinder_does) {
  const dem::Fiber f = fiber(13);
  const double R = f.diameter / 2;
  BOOST_CHECK_CLOSE_FRACTION(dem::fiber_mass(f), 1300 * std::numbers::pi * R * R * dem::fiber_length(f),
                             1e-14);
  dem::Fiber spheres = f;
  spheres.mass = dem::MassModel::spheres;
  BOOST_CHECK_CLOSE_FRACTION(dem::fiber_mass(spheres), 14 * 1300 * std::numbers::pi * 4 / 3 * R * R * R,
                             1e-14);
}

/// A free fiber's light ends move faster than any wave of the endless chain. Of one corrected bond, w_1 - w_2
/// against the common turn of both spheres: omega^2 = K_t (4 / m + l^2 / J) = 9 E / (rho d^2); of two 5/6 of
/// that; of many by the eigenvalues of the dense matrices (NumPy).
BOOST_AUTO_TEST_CASE(light_ends_bound_its_step) {
  const auto in_units = [](int bonds) {
    const dem::Fiber f = fiber(bonds);
    return dem::stable_time_step(f) /
           (f.diameter * std::sqrt(f.material.density / f.material.youngs_modulus));
  };
  BOOST_CHECK_CLOSE_FRACTION(in_units(1), 2.0 / 3, 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(in_units(2), 2.0 / 3 * std::sqrt(1.2), 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(in_units(20) / in_units(1), 0.91618226 / 0.81649658, 1e-7);
}

BOOST_AUTO_TEST_CASE(its_first_frequency_goes_to_the_beams_at_second_order) {
  std::vector<double> errors;
  for (const int bonds : {10, 20, 40}) {
    const dem::Fiber f = fiber(bonds);
    const double chain = dem::first_mode(f).frequency;
    auto linear = reference::with_cylinder_mass(reference::linear_chain({bonds, 0.65e-3, 3.1e6, 0.17, 1300}));
    linear.stiffness.shear = 0.75 * linear.stiffness.stretch;
    BOOST_CHECK_CLOSE_FRACTION(chain, reference::first_bending_mode(linear).frequency, 1e-9);
    const auto modes =
        reference::chain_modes(linear, reference::ChainMotion::bending, reference::ChainEnds::clamped_free);
    double slowest = 1e300;
    for (const auto& mode : modes) slowest = std::min(slowest, mode.frequency);
    BOOST_CHECK_CLOSE_FRACTION(chain, slowest, 1e-7);
    errors.push_back(std::abs(chain / beam_frequency(f) - 1));
  }
  BOOST_TEST(errors[0] < 0.02);
  for (std::size_t i = 0; i + 1 < errors.size(); ++i)
    BOOST_TEST(std::abs(std::log2(errors[i] / errors[i + 1]) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(every_integrator_keeps_its_energy_and_finds_the_same_motion) {
  swinging::check_schemes(bent_release<3>(fiber(11)),
                          {{dem::Integrator::leapfrog, dem::BondForm::total},
                           {dem::Integrator::leapfrog, dem::BondForm::incremental},
                           {dem::Integrator::leapfrog_damped, dem::BondForm::total},
                           {dem::Integrator::implicit, dem::BondForm::total},
                           {dem::Integrator::cvode, dem::BondForm::total}},
                          1e-4, 2e-3);
}

BOOST_AUTO_TEST_CASE(a_packing_lets_it_fall_and_swing_as_it_should) {
  const auto chain = dem::straight_chain<3>(fiber(13));
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental})
    swinging::check_fall(chain, 2, {.step = 2e-6, .form = form}, 1e-12);
}

BOOST_AUTO_TEST_CASE(it_settles_in_a_fluid_with_its_weight_over_its_drag) {
  const dem::Fiber f = fiber(13);
  dem::Domain around;
  around.gravity = {0, 0, -9.81};
  around.fluid = dem::Fluid{0.8, {}};
  const auto chain = dem::straight_chain<3>(f);
  dem::Assembly assembly({{chain, {dem::placed(chain, {{0, 0, 0}, {1, 0, 0}})}}}, around,
                         {.form = dem::BondForm::total});
  const double speed = dem::fiber_mass(f) * 9.81 / (14 * dem::stokes_drag(*around.fluid, f).translation);
  assembly.march(static_cast<std::int64_t>(0.05 / assembly.step()));
  const auto now = assembly.state(0, 0);
  double mean = 0;
  for (const V& v : now.velocity) mean -= v[2] / 14;
  BOOST_TEST(std::abs(mean / speed - 1) < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
