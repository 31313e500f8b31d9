// The leapfrog with springs and dashpots solved for within the step: order, energy, the limits that the turn
// of bonds and their tension set.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "dem/equilibrium/newton.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/motion/relaxation.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/vibration/first_mode.hpp"
#include "dem/vibration/release.hpp"

BOOST_AUTO_TEST_SUITE(stiff_leapfrog_test)

namespace dem = fiberchain::dem;

namespace {

dem::Fiber odd_fiber(double bond_damping, int aspect_ratio = 13) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, dem::BondModel::corrected,
          bond_damping};
}

/// A cantilever on whose tip a dead load rises over `ramp` of a period; its tip at the end of `periods`, over
/// L.
template <int Dim>
dem::Vec<double, Dim> pulled_tip(const dem::Fiber& fiber, dem::BondForm form, double load,
                                 double steps_per_period, double periods, double ramp) {
  const double dt = dem::first_mode(fiber).period / steps_per_period;
  const dem::Chain<Dim> chain = dem::straight_chain<Dim>(fiber);
  dem::ChainBatch<Dim> block({chain}, {true, false}, {dt}, {0},
                             {.dimension = Dim,
                              .form = form,
                              .damped = true,
                              .settling_damping = false,
                              .curved = false,
                              .solved = dem::Solved::bonds},
                             dem::InstructionSet::scalar);
  dem::Load<Dim> end{fiber.aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  if constexpr (Dim == 3) {
    end.force[2] = -0.4 * end.force[1];
    end.moment[0] = 0.3 * end.force[1] * dem::fiber_length(fiber);
  }
  block.set_ramp(0, {{0}, {}}, {{0}, {end}}, ramp * steps_per_period);
  block.synchronize();
  block.march(static_cast<int>(std::lround(periods * steps_per_period)));
  return (1 / dem::fiber_length(fiber)) * block.sphere(0, fiber.aspect_ratio).pose.position;
}

template <int Dim>
double order(const dem::Fiber& fiber, dem::BondForm form, double load, double steps_per_period) {
  dem::Vec<double, Dim> tips[3];
  for (int k = 0; k < 3; ++k) tips[k] = pulled_tip<Dim>(fiber, form, load, steps_per_period * (1 << k), 2, 1);
  const double found = std::log2(dem::norm(tips[0] - tips[1]) / dem::norm(tips[1] - tips[2]));
  BOOST_TEST_MESSAGE(Dim << "D " << dem::name(form) << " load " << load << ": order " << found << ", error "
                         << dem::norm(tips[0] - tips[1]) * 4 / 3 << " at T/" << steps_per_period);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tip_of_a_loaded_chain_has_second_order_in_the_step) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const double load : {0.01, 3.1}) {
      BOOST_TEST(std::abs(order<2>(odd_fiber(0.7), form, load, 320) - 2) < 0.05);
      BOOST_TEST(std::abs(order<3>(odd_fiber(0.7), form, load, 320) - 2) < 0.05);
    }
  }
}

namespace {

/// Largest tension over the length of a chain under which small transverse motions at rest do not grow in
/// `periods` steps: bisection over runs of a chain drawn out by dead forces on its ends.
bool stays_straight(const dem::Fiber& fiber, double tension, double dt, double beta) {
  const dem::Chain<2> chain = dem::straight_chain<2>(fiber);
  const dem::BondStiffness K = dem::bond_stiffness(fiber);
  std::vector<dem::MovingSphere<double, 2>> spheres;
  dem::MarchParameters<double, 2> p = dem::march_parameters<2>(fiber, {}, dt);
  p.solved_stretch = beta * K.stretch, p.solved_shear = beta * K.shear;
  p.solved_twist = beta * K.twist, p.solved_bend = beta * K.bend;
  p.ramp.rate = 1;
  p.ramp.first_from.force = p.ramp.first_to.force = {-tension, 0};
  p.ramp.last_from.force = p.ramp.last_to.force = {tension, 0};
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double l = dem::bond_length(fiber), size = 1e-9;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    dem::MovingSphere<double, 2> s{};
    s.pose = chain.poses[i];
    s.pose.position[0] *= 1 + tension / (K.stretch * l);
    s.velocity = {0, size * l / dt * uniform(generator)};
    s.spin = {size / dt * uniform(generator)};
    spheres.push_back(s);
  }
  constexpr dem::Physics physics{.dimension = 2,
                                 .form = dem::BondForm::total,
                                 .damped = true,
                                 .settling_damping = false,
                                 .curved = false,
                                 .solved = dem::Solved::bonds};
  std::vector<double> workspace(dem::workspace_reals<physics, double>(fiber.aspect_ratio));
  const dem::ChainBlock<physics, double> block{.bonds = fiber.aspect_ratio,
                                               .clamps = {false, false},
                                               .spheres = spheres.data(),
                                               .history = nullptr,
                                               .natural = nullptr,
                                               .parameters = p,
                                               .workspace = workspace.data()};
  dem::start_march<physics, double>(block);
  for (int n = 0; n < 4000; ++n) {
    dem::march_step<physics, double>(block, n);
    for (const auto& s : spheres) {
      if (!(std::abs(dt * s.velocity[1]) < 1e4 * size * l)) return false;
    }
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(tension_grows_small_motions_beyond_the_predicted_one) {
  const dem::Fiber fiber = odd_fiber(0, 60);
  const double t_b = dem::bond_time_step(fiber);
  for (const double beta : {0.25, dem::stiff_beta}) {
    for (const double ratio : {7.0, 70.0}) {
      const double predicted = dem::largest_tension(fiber, ratio * t_b, beta);
      BOOST_TEST_CONTEXT("beta " << beta << " dt / t_b " << ratio << " tension " << predicted) {
        BOOST_TEST(stays_straight(fiber, 0.98 * predicted, ratio * t_b, beta));
        BOOST_TEST(!stays_straight(fiber, 1.03 * predicted, ratio * t_b, beta));
        BOOST_TEST(std::abs(dem::step_for_tension(fiber, predicted, beta) / (ratio * t_b) - 1) < 1e-9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_free_straight_fiber_bends_with_the_period_of_the_beam) {
  dem::Fiber fiber = odd_fiber(0, 20);
  fiber.bond_model = dem::BondModel::paper;
  BOOST_TEST(std::abs(dem::free_bending_period(fiber) / dem::bond_time_step(fiber) / 449.3 - 1) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
