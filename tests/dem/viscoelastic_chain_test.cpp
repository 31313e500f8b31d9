// Maxwell branches beside the bonds' springs, in time, against the complex-modulus roots of the chain's own
// linearization.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "dem/material/flat_loss.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/viscoelastic_motion.hpp"

BOOST_AUTO_TEST_SUITE(viscoelastic_chain_test)

namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;
using reference::ChainMotion;
using viscoelastic::Complex;

namespace {

constexpr dem::BondForm forms[] = {dem::BondForm::total, dem::BondForm::incremental};

dem::Fiber odd_fiber(int aspect_ratio, dem::BondModel model = dem::BondModel::paper) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, model};
}

double damping(Complex s) { return -s.real() / std::abs(s); }

/// Spectra by the period of the first bending mode: one branch, four with different ones in shear and twist,
/// a flat loss factor, thermoelastic-like in bending alone with a dashpot beside it.
std::vector<dem::Fiber> materials(int aspect_ratio) {
  const dem::Fiber fiber = odd_fiber(aspect_ratio);
  const auto elastic = reference::complex_chain_modes(
      viscoelastic::linear_chain(fiber), reference::bond_moduli({}), ChainMotion::bending,
      reference::ChainEnds::clamped_free, 1);
  const double f = elastic[0].decay.frequency / (2 * std::numbers::pi), T = 1 / f;
  std::vector<dem::Fiber> all(4, fiber);
  all[0].branches = dem::maxwell_branches({{{0.13, 0.21 * T}}, {{0.13, 0.21 * T}}, {}}, fiber.bond_model);
  all[1].branches = dem::maxwell_branches(
      {{{0.05, 3 * T}, {0.08, 0.1 * T}}, {{0.3, 0.02 * T}, {0.1, 0.5 * T}}, {}}, fiber.bond_model);
  const dem::PronySeries flat = dem::flat_loss(0.03, {f / 2, 500 * f}, 5).series;
  all[2].branches = dem::maxwell_branches({flat, dem::flat_loss(0.05, {f / 2, 500 * f}, 5).series, {}},
                                          fiber.bond_model);
  all[3].branches = dem::maxwell_branches({{}, {}, {{0.01, 0.3 * T}, {0.002, 0.02 * T}}}, fiber.bond_model);
  all[3].bond_damping = 0.05;
  return all;
}

/// Largest relative error of zeta over the lowest `count` modes.
template <int Dim>
double largest_error(const dem::Fiber& fiber, dem::BondForm form, ChainMotion motion, int count,
                     dem::Solved solved = dem::Solved::nothing) {
  const auto modes = reference::complex_chain_modes(
      viscoelastic::linear_chain(fiber), reference::bond_moduli(viscoelastic::spectra(fiber.branches)), motion,
      reference::ChainEnds::clamped_free, count);
  double worst = 0;
  for (const auto& mode : modes) {
    const double stable = solved == dem::Solved::nothing ? dem::stable_time_step(fiber) : 1e300;
    const double step = std::min(0.3 * stable, 0.02 / mode.decay.frequency);
    const Complex s = viscoelastic::marched_mode<Dim>(fiber, form, motion, mode, solved, step, 2,
                                                      1e-5 * dem::bond_length(fiber));
    const double error = damping(s) / mode.decay.damping - 1;
    BOOST_TEST_MESSAGE(Dim << "D " << dem::name(form) << " r_f " << fiber.aspect_ratio << " zeta "
                           << mode.decay.damping << " error " << error << " frequency "
                           << s.imag() / mode.decay.eigenvalue.imag() - 1);
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bending_modes_decay_by_the_roots_of_their_complex_moduli) {
  for (const int aspect_ratio : {5, 13, 50}) {
    for (const dem::Fiber& fiber : materials(aspect_ratio)) {
      for (const auto form : forms) {
        BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::bending, 3) < 1e-3);
        BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::bending, 3) < 1e-3);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(stretch_and_twist_modes_too) {
  for (const dem::Fiber& fiber : materials(13)) {
    if (fiber.branches.stretch.empty()) continue;
    for (const auto form : forms) {
      BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::axial, 3) < 1e-3);
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::axial, 3) < 1e-3);
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::twist, 3) < 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(and_beside_springs_that_are_solved_for) {
  for (const dem::Fiber& fiber : materials(13)) {
    for (const auto form : forms) {
      BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::bending, 3, dem::Solved::bonds) < 1e-3);
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::bending, 3, dem::Solved::bonds) < 1e-3);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
