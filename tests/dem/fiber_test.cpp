#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem/model/errors.hpp"
#include "dem/model/fiber.hpp"

BOOST_AUTO_TEST_SUITE(fiber_test)

namespace dem = fiberchain::dem;
using std::numbers::pi;

namespace {

dem::Fiber odd_fiber() {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 13, dem::BondModel::paper, 0.7};
}

template <class Change>
void refuses(Change change, const std::string& named) {
  dem::Fiber fiber = odd_fiber();
  change(fiber);
  BOOST_CHECK_EXCEPTION(dem::check(fiber), dem::InvalidInput, [&](const dem::InvalidInput& error) {
    return std::string(error.what()).find(named) != std::string::npos;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(stiffnesses_are_those_of_a_solid_cylinder_cut_into_bonds) {
  const dem::Fiber fiber = odd_fiber();
  const double E = 3.7e5, G = 3.7e5 / 2.34, R = 0.0131, l = 0.0262;
  const double A = pi * R * R, I = pi * R * R * R * R / 4;
  const dem::BondStiffness K = dem::bond_stiffness(fiber);
  BOOST_TEST(K.stretch == E * A / l, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(K.shear == G * A / l, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(K.twist == G * 2 * I / l, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(K.bend == E * I / l, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(spheres_carry_two_thirds_of_the_cylinders_mass) {
  const dem::Fiber fiber = odd_fiber();
  const double R = 0.0131, cylinder = 431.0 * pi * R * R * 2 * R;
  BOOST_TEST(dem::sphere_mass(fiber) / cylinder == 2.0 / 3.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(dem::sphere_inertia(fiber) == 0.4 * dem::sphere_mass(fiber) * R * R,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(bond_time_step_is_equation_11) {
  const dem::Fiber fiber = odd_fiber();
  // 0.8165 is sqrt(2/3) to four digits
  BOOST_TEST(dem::bond_time_step(fiber) / (0.0262 * std::sqrt(431.0 / 3.7e5)) == std::sqrt(2.0 / 3.0),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(dashpots_are_equations_7_to_10) {
  const dem::Fiber fiber = odd_fiber();
  const dem::BondStiffness K = dem::bond_stiffness(fiber);
  const dem::BondDashpot c = dem::bond_dashpot(fiber);
  const double m = dem::sphere_mass(fiber), J = dem::sphere_inertia(fiber);
  BOOST_TEST(c.stretch == 0.7 * std::sqrt(2 * m * K.stretch), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.shear == 0.7 * std::sqrt(2 * m * K.shear), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.twist == 0.7 * std::sqrt(2 * J * K.twist), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.bend == 0.7 * std::sqrt(2 * J * K.bend), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(damping_is_zero_unless_set) {
  const dem::Fiber fiber{dem::isotropic_material(1e6, 0.3, 1000), 2e-3, 10};
  BOOST_TEST(dem::bond_dashpot(fiber).stretch == 0.0);
  BOOST_TEST(dem::bond_dashpot(fiber).bend == 0.0);
}

BOOST_AUTO_TEST_CASE(corrected_bond_changes_only_the_shear_stiffness) {
  dem::Fiber fiber = odd_fiber();
  const dem::BondStiffness paper = dem::bond_stiffness(fiber);
  fiber.bond_model = dem::BondModel::corrected;
  const dem::BondStiffness corrected = dem::bond_stiffness(fiber);
  BOOST_TEST(corrected.shear == 0.75 * paper.stretch);
  BOOST_TEST(corrected.stretch == paper.stretch);
  BOOST_TEST(corrected.bend == paper.bend);
  BOOST_TEST(corrected.twist == paper.twist);
}

BOOST_AUTO_TEST_CASE(load_is_P_L_squared_over_EI) {
  const dem::Fiber fiber = odd_fiber();
  const double L = 13 * 0.0262;
  BOOST_TEST(dem::load_force(fiber, 1.7) * L * L / dem::bending_stiffness(fiber) == 1.7,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(accepts_what_makes_sense) {
  dem::check(odd_fiber());
  dem::check({dem::isotropic_material(1e6, 0.5, 1000), 2e-3, 1});
  dem::check({dem::isotropic_material(1e6, -0.2, 1000), 2e-3, 500});
}

BOOST_AUTO_TEST_CASE(refuses_what_makes_no_physical_sense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    refuses([&](dem::Fiber& f) { f.material.youngs_modulus = bad; }, "youngs_modulus");
    refuses([&](dem::Fiber& f) { f.material.shear_modulus = bad; }, "shear_modulus");
    refuses([&](dem::Fiber& f) { f.material.density = bad; }, "density");
    refuses([&](dem::Fiber& f) { f.diameter = bad; }, "diameter");
  }
  refuses([&](dem::Fiber& f) { f.aspect_ratio = 0; }, "aspect_ratio");
  refuses([&](dem::Fiber& f) { f.bond_damping = -0.1; }, "bond_damping");
  refuses([&](dem::Fiber& f) { f.bond_damping = nan; }, "bond_damping");
  refuses([&](dem::Fiber& f) { f.material.across = {1e6, 0.51}; }, "poisson_ratio");
  refuses([&](dem::Fiber& f) { f.material.across = {0, 0.3}; }, "transverse_modulus");
  refuses([&](dem::Fiber& f) { f.rest_angle = 2.1; }, "rest_angle");
  refuses([&](dem::Fiber& f) { f.rest_angle = nan; }, "rest_angle");
  for (const double nu : {-1.0, 0.51, nan})
    BOOST_CHECK_THROW(dem::isotropic_material(1e6, nu, 1e3), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(poissons_ratio_is_that_of_isotropic_materials_only) {
  const dem::Material wood{11e9, 0.7e9, 500}, rubber = dem::isotropic_material(1e6, 0.5, 900);
  BOOST_TEST(std::isnan(dem::poisson_ratio(wood)));
  BOOST_CHECK_CLOSE_FRACTION(dem::poisson_ratio(rubber), 0.5, 1e-12);
  BOOST_TEST(dem::contact_elasticity(wood).poisson_ratio == dem::usual_poisson_ratio);
  dem::Fiber fiber = odd_fiber();
  fiber.material = wood;
  BOOST_CHECK_NO_THROW(dem::check(fiber));
}

BOOST_AUTO_TEST_SUITE_END()
