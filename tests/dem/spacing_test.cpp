// Fibers whose spheres do not touch: bonds of any length have the stiffnesses, masses and steps of that
// length, and everything of one chain works with them as with touching spheres.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/fluid.hpp"
#include "dem/vibration/first_mode.hpp"
#include "dem/vibration/release.hpp"
#include "reference/chain_modes.hpp"
#include "reference/elastica.hpp"
#include "reference/reissner.hpp"
#include "tests/dem/swinging_fiber.hpp"

BOOST_AUTO_TEST_SUITE(spacing_test)

namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;
using dem::BondModel;
using dem::MassModel;
using std::numbers::pi;
using V = dem::Vec<double, 3>;

namespace {

constexpr double E = 3.1e6, nu = 0.17, rho = 1300, d = 1.3e-3;

dem::Fiber spaced(int bonds, double spacing, BondModel model, MassModel mass = MassModel::spheres) {
  dem::Fiber fiber{dem::isotropic_material(E, nu, rho), d, bonds, model};
  fiber.mass = mass, fiber.spacing = spacing;
  return fiber;
}

/// The same by the reference, which knows nothing of the engine.
reference::LinearChain linear(int bonds, double spacing, BondModel model, MassModel mass, double xi_b = 0) {
  auto chain = reference::linear_chain({bonds, d / 2, E, nu, rho, spacing});
  if (mass == MassModel::cylinder) chain = reference::with_cylinder_mass(chain);
  if (model == BondModel::corrected) chain = reference::with_slender_shear(chain);
  return reference::with_bond_damping(chain, xi_b);
}

dem::Boundary<2> pulled(const dem::Fiber& fiber, double load) {
  dem::Load<2> end{fiber.aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  return {{0}, {end}};
}

double distance(const dem::Poses<2>& poses, double length, const reference::TipState& tip) {
  const auto& end = poses.back().position;
  return std::hypot(end[1] / length - tip.y, 1 - end[0] / length - tip.x);
}

/// From the Elastica, of the corrected bond the one that stretches as its bonds do.
double static_error(const dem::Fiber& fiber, double load) {
  const auto poses = dem::solve_equilibrium(dem::straight_chain<2>(fiber), pulled(fiber, load)).poses;
  const double L = dem::fiber_length(fiber), r = dem::slenderness(fiber);
  const auto tip = fiber.bond_model == BondModel::paper
                       ? reference::elastica_shooting(load)
                       : reference::reissner_tip(load, 16 * r * r, std::numeric_limits<double>::infinity());
  return distance(poses, L, tip);
}

constexpr double spacings[] = {0.5, 1.7, 2.6};

}  // namespace

BOOST_AUTO_TEST_CASE(bonds_have_the_stiffness_of_their_length) {
  const double R = d / 2, A = pi * R * R, I = pi * std::pow(R, 4) / 4, G = E / (2 * (1 + nu));
  for (const double s : spacings) {
    const dem::Fiber paper = spaced(5, s, BondModel::paper), corrected = spaced(5, s, BondModel::corrected);
    const double l = s * d, L = 5 * l;
    const auto K = dem::bond_stiffness(paper);
    const double equal = 1e-13;
    BOOST_CHECK_CLOSE_FRACTION(K.stretch, E * A / l, equal);
    BOOST_CHECK_CLOSE_FRACTION(K.shear, G * A / l, equal);
    BOOST_CHECK_CLOSE_FRACTION(K.twist, G * 2 * I / l, equal);
    BOOST_CHECK_CLOSE_FRACTION(K.bend, E * I / l, equal);
    BOOST_CHECK_CLOSE_FRACTION(dem::bond_stiffness(corrected).shear, 12 * E * I / (l * l * l), equal);
    BOOST_CHECK_CLOSE_FRACTION(dem::fiber_length(paper), L, equal);
    BOOST_CHECK_CLOSE_FRACTION(dem::slenderness(paper), 5 * s, equal);
  }
}

BOOST_AUTO_TEST_CASE(the_whole_has_the_mass_and_inertia_of_touching_spheres_or_of_the_cylinder) {
  const double R = d / 2, sphere = 4.0 / 3 * pi * R * R * R * rho, A = pi * R * R;
  for (const auto& [bonds, s] :
       {std::pair{26, 0.5}, std::pair{8, 1.625}, std::pair{5, 2.6}, std::pair{2, 6.5}}) {  // 13 diameters
    const double L = 13 * d;
    for (const auto mass : {MassModel::spheres, MassModel::cylinder}) {
      const dem::Fiber fiber = spaced(bonds, s, BondModel::paper, mass);
      double sum = 0, moment = 0, about_axis = 0;
      for (int i = 0; i <= bonds; ++i) {
        const double m = dem::mass_share(fiber, i) * dem::sphere_mass(fiber);
        sum += m, moment += m * std::pow(L * i / bonds - L / 2, 2);
        about_axis += dem::mass_share(fiber, i) * dem::sphere_inertia(fiber);
      }
      double whole = rho * A * L, turns = whole * L * L / 12, rolls = whole * R * R / 2;
      if (mass == MassModel::spheres) {
        whole = 14 * sphere, turns = 0, rolls = 14 * 0.4 * sphere * R * R;
        for (int i = 0; i <= 13; ++i) turns += sphere * std::pow((i - 6.5) * d, 2);
      }
      BOOST_CHECK_CLOSE_FRACTION(sum, whole, 1e-13);
      BOOST_CHECK_CLOSE_FRACTION(dem::fiber_mass(fiber), whole, 1e-13);
      BOOST_CHECK_CLOSE_FRACTION(moment, turns, 1e-12);
      BOOST_CHECK_CLOSE_FRACTION(about_axis, rolls, 1e-13);
    }
  }
  // a single bond has ends only
  BOOST_CHECK_CLOSE_FRACTION(dem::fiber_mass(spaced(1, 2.6, BondModel::paper)), 3.6 * sphere, 1e-13);
  BOOST_CHECK_CLOSE_FRACTION(dem::fiber_mass(spaced(1, 2.6, BondModel::paper, MassModel::cylinder)),
                             rho * A * 2.6 * d, 1e-13);
}

BOOST_AUTO_TEST_CASE(touching_spheres_keep_their_bits) {
  const double R = d / 2, G = dem::isotropic_material(E, nu, rho).shear_modulus;
  for (const auto model : {BondModel::paper, BondModel::corrected}) {
    const dem::Fiber fiber = spaced(13, 1, model);
    const auto K = dem::bond_stiffness(fiber);
    BOOST_TEST(K.stretch == pi * R * E / 2);
    BOOST_TEST(K.shear == (model == BondModel::paper ? pi * R * G / 2 : 0.75 * (pi * R * E / 2)));
    BOOST_TEST(K.twist == pi * R * R * R * G / 4);
    BOOST_TEST(K.bend == pi * R * R * R * E / 8);
    BOOST_TEST(dem::bond_length(fiber) == d);
    BOOST_TEST(dem::sphere_mass(fiber) == 4.0 / 3.0 * pi * std::pow(R, 3) * rho);
    BOOST_TEST(dem::end_mass_share(fiber) == 1);
    BOOST_TEST(dem::end_mass_share(spaced(13, 1, model, MassModel::cylinder)) == 0.5);
  }
}

BOOST_AUTO_TEST_CASE(the_free_end_goes_to_the_elasticas_at_the_order_of_touching_spheres) {
  for (const double s : spacings) {
    for (const auto model : {BondModel::paper, BondModel::corrected}) {
      const double expected = model == BondModel::paper ? 2 : 4;
      for (const double load : {0.7, 6.0}) {
        std::vector<double> errors;
        for (const int bonds : {13, 26, 52}) errors.push_back(static_error(spaced(bonds, s, model), load));
        for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
          const double order = std::log2(errors[i] / errors[i + 1]);
          BOOST_TEST(std::abs(order - expected) < 0.1, dem::name(model)
                                                           << " s " << s << " load " << load << ": order "
                                                           << order << ", error " << errors[i]);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(at_small_load_it_is_off_by_shear_and_the_length_of_a_bond) {
  for (const double s : spacings) {
    const dem::Fiber fiber = spaced(13, s, BondModel::paper);
    const double r = dem::slenderness(fiber), load = 1e-4,
                 expected = (0.375 * (1 + nu) - s * s / 4) / (r * r);
    const auto poses = dem::solve_equilibrium(dem::straight_chain<2>(fiber), pulled(fiber, load)).poses;
    const double y = poses.back().position[1] / dem::fiber_length(fiber);
    BOOST_TEST(std::abs(y / (load / 3) - 1 - expected) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(marching_to_rest_finds_what_is_solved_for) {
  for (const double s : spacings) {
    const dem::Fiber fiber = spaced(s < 1 ? 11 : 5, s, BondModel::corrected);
    const dem::Boundary<2> boundary = pulled(fiber, 2);
    const auto chain = dem::straight_chain<2>(fiber);
    const auto solved = dem::solve_equilibrium(chain, boundary).poses.back().position;
    dem::RelaxOptions options;
    options.residual = 1e-8;
    const auto total = dem::relax_to_equilibrium<2>({{chain, {boundary}}}, options)[0];
    BOOST_TEST(norm(total.poses.back().position - solved) < 1e-6 * dem::fiber_length(fiber));
    options.form = dem::BondForm::incremental;
    const auto summed = dem::relax_to_equilibrium<2>({{chain, {boundary}}}, options)[0];
    BOOST_TEST(norm(summed.poses.back().position - solved) < 1e-3 * dem::fiber_length(fiber));
  }
}

BOOST_AUTO_TEST_CASE(first_mode_and_its_damping_are_the_linear_chains) {
  for (const double s : spacings) {
    for (const auto model : {BondModel::paper, BondModel::corrected}) {
      for (const auto mass : {MassModel::spheres, MassModel::cylinder}) {
        dem::Fiber fiber = spaced(13, s, model, mass);
        fiber.bond_damping = 0.3;
        const dem::FirstMode own = dem::first_mode(fiber);
        const auto mode = reference::first_bending_mode(linear(13, s, model, mass, 0.3));
        BOOST_CHECK_CLOSE_FRACTION(own.frequency, mode.frequency, 1e-7);  // of the undamped shape
        BOOST_CHECK_CLOSE_FRACTION(own.damping, mode.damping, 1e-7);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(fiber_damping_goes_with_the_spacing_over_the_square_of_the_slenderness) {
  constexpr double beta = 1.8751040687119611;
  for (const double s : spacings) {
    const int bonds = static_cast<int>(std::lround(65 / s));
    const double r = bonds * s, spheres = beta * beta / std::sqrt(20.0) * s / ((r + 0.5) * (r + 0.5)),
                 cylinder = beta * beta / 4 * s / (r * r);
    for (const auto model : {BondModel::paper, BondModel::corrected}) {
      const auto damping = [&](MassModel mass) {
        return reference::first_bending_mode(linear(bonds, s, model, mass, 0.01)).damping / 0.01;
      };
      BOOST_TEST(std::abs(damping(MassModel::spheres) / spheres - 1) < 0.002);
      BOOST_TEST(std::abs(damping(MassModel::cylinder) / cylinder - 1) < 0.002);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_cut_ever_finer_has_a_limit_at_second_order) {
  for (const auto mass : {MassModel::spheres, MassModel::cylinder}) {
    std::vector<double> frequencies;
    for (const int parts : {2, 4, 8, 16})
      frequencies.push_back(
          dem::first_mode(spaced(13 * parts, 1.0 / parts, BondModel::paper, mass)).frequency);
    for (std::size_t i = 0; i + 2 < frequencies.size(); ++i) {
      const double order =
          std::log2((frequencies[i] - frequencies[i + 1]) / (frequencies[i + 1] - frequencies[i + 2]));
      BOOST_TEST(std::abs(order - 2) < 0.1, order);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_integrator_keeps_its_energy_and_finds_the_same_motion) {
  for (const double s : {0.5, 2.6}) {
    const dem::Fiber f = spaced(s < 1 ? 11 : 5, s, BondModel::corrected);
    dem::Release<3> release{dem::straight_chain<3>(f), {}, {}, {}, dem::first_mode(f).period, 3};
    dem::Load<3> pull{f.aspect_ratio, {}, {}};
    pull.force[1] = dem::load_force(f, 0.3);
    release.start = dem::solve_equilibrium<3>(release.chain, {{0}, {pull}}).poses;
    BOOST_TEST_CONTEXT("s " << s) {
      swinging::check_schemes(release,
                              {{dem::Integrator::leapfrog, dem::BondForm::total},
                               {dem::Integrator::leapfrog, dem::BondForm::incremental},
                               {dem::Integrator::leapfrog_damped, dem::BondForm::total},
                               {dem::Integrator::leapfrog_stiff, dem::BondForm::total},
                               {dem::Integrator::implicit, dem::BondForm::total},
                               {dem::Integrator::cvode, dem::BondForm::total}},
                              2e-3, 5e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_packing_lets_it_fall_and_swing_as_it_should) {
  const auto chain = dem::straight_chain<3>(spaced(5, 2.6, BondModel::corrected, MassModel::cylinder));
  for (const auto integrator : {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff}) {
    swinging::check_fall(chain, 1, {.step = 2e-6, .integrator = integrator, .form = dem::BondForm::total},
                         1e-11);
  }
}

BOOST_AUTO_TEST_CASE(spacings_without_meaning_and_fluids_are_refused) {
  for (const double s : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW(dem::check(spaced(5, s, BondModel::paper)), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::stokes_drag({0.8, {}}, spaced(5, 1.7, BondModel::paper)), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
