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
  const auto elastic =
      reference::complex_chain_modes(viscoelastic::linear_chain(fiber), reference::bond_moduli({}),
                                     ChainMotion::bending, reference::ChainEnds::clamped_free, 1);
  const double f = elastic[0].decay.frequency / (2 * std::numbers::pi), T = 1 / f;
  std::vector<dem::Fiber> all(4, fiber);
  all[0].branches = dem::maxwell_branches({{{0.13, 0.21 * T}}, {{0.13, 0.21 * T}}, {}}, fiber.bond_model);
  all[1].branches = dem::maxwell_branches(
      {{{0.05, 3 * T}, {0.08, 0.1 * T}}, {{0.3, 0.02 * T}, {0.1, 0.5 * T}}, {}}, fiber.bond_model);
  const dem::PronySeries flat = dem::flat_loss(0.03, {f / 2, 500 * f}, 5).series;
  all[2].branches =
      dem::maxwell_branches({flat, dem::flat_loss(0.05, {f / 2, 500 * f}, 5).series, {}}, fiber.bond_model);
  all[3].branches = dem::maxwell_branches({{}, {}, {{0.01, 0.3 * T}, {0.002, 0.02 * T}}}, fiber.bond_model);
  all[3].bond_damping = 0.05;
  return all;
}

/// Largest relative error of zeta over the lowest `count` modes.
template <int Dim>
double largest_error(const dem::Fiber& fiber, dem::BondForm form, ChainMotion motion, int count,
                     dem::Solved solved = dem::Solved::nothing) {
  const auto modes = reference::complex_chain_modes(
      viscoelastic::linear_chain(fiber), reference::bond_moduli(viscoelastic::spectra(fiber.branches)),
      motion, reference::ChainEnds::clamped_free, count);
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

// The damping ratio of a dashpot is that of the lagged velocity's (dt/t_b)-parts; without one the leapfrog is
// second order.
double bound(const dem::Fiber& fiber) { return fiber.bond_damping > 0 ? 3e-4 : 4e-5; }

BOOST_AUTO_TEST_CASE(bending_modes_decay_by_the_roots_of_their_complex_moduli) {
  for (const int aspect_ratio : {5, 13, 50}) {
    std::vector<dem::Fiber> fibers = materials(aspect_ratio);
    if (aspect_ratio == 50) fibers = {fibers[2]};
    for (const dem::Fiber& fiber : fibers) {
      for (const auto form : forms) {
        BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::bending, 3) < bound(fiber));
        BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::bending, 3) < bound(fiber));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(stretch_and_twist_modes_too) {
  for (const dem::Fiber& fiber : materials(13)) {
    if (fiber.branches.stretch.empty()) continue;
    for (const auto form : forms) {
      BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::axial, 3) < bound(fiber));
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::axial, 3) < bound(fiber));
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::twist, 3) < bound(fiber));
    }
  }
}

BOOST_AUTO_TEST_CASE(and_beside_springs_that_are_solved_for) {
  for (const dem::Fiber& fiber : materials(13)) {
    for (const auto form : forms) {
      BOOST_TEST(largest_error<2>(fiber, form, ChainMotion::bending, 3, dem::Solved::bonds) < 2e-4);
      BOOST_TEST(largest_error<3>(fiber, form, ChainMotion::bending, 3, dem::Solved::bonds) < 2e-4);
    }
  }
}

namespace {

/// Tip over L, after two periods, of a cantilever on whose end a large dead load rises during the first.
template <int Dim>
dem::Vec<double, Dim> pulled_tip(const dem::Fiber& fiber, dem::BondForm form, dem::Solved solved,
                                 double period, double steps_per_period) {
  const dem::Chain<Dim> chain = dem::straight_chain<Dim>(fiber);
  dem::ChainBatch<Dim> block({chain}, {true, false}, {period / steps_per_period}, {0},
                             dem::physics_of(chain, {.form = form, .solved = solved}),
                             dem::best_instruction_set());
  dem::Load<Dim> end{fiber.aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, 3.1);
  if constexpr (Dim == 3) {
    end.force[2] = -0.4 * end.force[1];
    end.moment[0] = 0.3 * end.force[1] * dem::fiber_length(fiber);
  }
  block.set_ramp(0, {{0}, {}}, {{0}, {end}}, steps_per_period);
  block.synchronize();
  block.march(static_cast<int>(std::lround(2 * steps_per_period)));
  return (1 / dem::fiber_length(fiber)) * block.sphere(0, fiber.aspect_ratio).pose.position;
}

template <int Dim>
double order(const dem::Fiber& fiber, dem::BondForm form, dem::Solved solved, double period, double steps) {
  dem::Vec<double, Dim> tips[3];
  for (int k = 0; k < 3; ++k) tips[k] = pulled_tip<Dim>(fiber, form, solved, period, steps * (1 << k));
  const double found = std::log2(dem::norm(tips[0] - tips[1]) / dem::norm(tips[1] - tips[2]));
  BOOST_TEST_MESSAGE(Dim << "D " << dem::name(form) << " " << dem::name(solved) << ": order " << found
                         << ", tip at " << tips[2][0] << ", " << tips[2][1]);
  return found;
}

double first_period(const dem::Fiber& fiber) {
  dem::Fiber elastic = fiber;
  elastic.branches = {};
  const auto modes =
      reference::complex_chain_modes(viscoelastic::linear_chain(elastic), reference::bond_moduli({}),
                                     ChainMotion::bending, reference::ChainEnds::clamped_free, 1);
  return 2 * std::numbers::pi / modes[0].decay.frequency;
}

}  // namespace

BOOST_AUTO_TEST_CASE(large_motions_have_second_order_in_the_step) {
  for (const auto model : {dem::BondModel::paper, dem::BondModel::corrected}) {
    dem::Fiber fiber = odd_fiber(7, model);
    const double T = first_period(fiber);
    fiber.branches = dem::maxwell_branches({{{0.2, 0.3 * T}}, {{0.4, 0.05 * T}}, {{0.1, 2 * T}}}, model);
    for (const auto form : forms) {
      for (const auto solved : {dem::Solved::nothing, dem::Solved::bonds}) {
        BOOST_TEST(std::abs(order<2>(fiber, form, solved, T, 1600) - 2) < 0.01);
        BOOST_TEST(std::abs(order<3>(fiber, form, solved, T, 1600) - 2) < 0.01);
      }
    }
  }
}

// A branch without strength changes nothing: the total form's path to round-off, the incremental one's, which
// sums its strain by components then, at second order.
BOOST_AUTO_TEST_CASE(a_branch_without_strength_changes_nothing) {
  dem::Fiber plain = odd_fiber(7, dem::BondModel::corrected), with = plain;
  plain.bond_damping = with.bond_damping = 0.3;
  const double T = first_period(plain);
  with.branches.bend = {{0, T}};
  const auto apart = [&](dem::BondForm form, double steps) {
    const auto solved = dem::Solved::nothing;
    return dem::norm(pulled_tip<3>(with, form, solved, T, steps) -
                     pulled_tip<3>(plain, form, solved, T, steps));
  };
  BOOST_TEST(apart(dem::BondForm::total, 2400) < 1e-11);
  const double coarse = apart(dem::BondForm::incremental, 2400),
               fine = apart(dem::BondForm::incremental, 4800);
  BOOST_TEST(coarse < 1e-6);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 2) < 0.1);
}

// The step that is stable for the unrelaxed springs is for any relaxation time: shaken at 0.98 of it a
// chain's energy does not grow, just beyond the elastic limit of those springs it does where nothing relaxes.
BOOST_AUTO_TEST_CASE(no_relaxation_time_limits_the_step) {
  for (const double time : {1e-6, 1e-2, 0.3, 1.0, 10.0, 1e9}) {
    dem::Fiber fiber = odd_fiber(13);
    const double t_b = dem::bond_time_step(fiber);
    fiber.branches = dem::maxwell_branches({{{1.5, time * t_b}}, {{1.5, time * t_b}}, {}}, fiber.bond_model);
    const double stable = dem::stable_time_step(fiber), elastic = dem::stable_time_step(odd_fiber(13));
    BOOST_TEST(stable == elastic / std::sqrt(2.5), boost::test_tools::tolerance(1e-9));
    for (const auto form : forms) {
      const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
      const auto largest = [&](double dt) {
        dem::ChainBatch<3> block({chain}, {false, false}, {dt}, {0}, dem::physics_of(chain, {.form = form}),
                                 dem::best_instruction_set());
        dem::ChainState<3> state = dem::at_rest<3>(chain.poses);
        const double small = 1e-9 * fiber.diameter / t_b;
        for (int i = 0; i <= 13; ++i)
          state.velocity[i] = {small * (i % 2 ? 1 : -1), small * (i % 3 - 1.0), small * (i % 4 - 1.5)};
        dem::put_state(block, 0, chain, state);
        block.march(20000);
        return dem::broken_sphere(block, 0, fiber) < 0 ? dem::norm(block.sphere(0, 6).velocity) / small
                                                       : 1e300;
      };
      BOOST_TEST(largest(0.98 * stable) < 10);
      if (time > 1e8) BOOST_TEST(largest(1.03 * stable) > 1e3);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
