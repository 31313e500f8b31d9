#include "compare/stability/large_motion.hpp"

#include <cmath>
#include <random>

#include "dem/chain/chain.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/vibration/first_mode.hpp"

namespace fiberchain::compare {
namespace {

dem::Fiber fiber_of(int aspect_ratio, double bond_damping) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, dem::BondModel::corrected,
          bond_damping};
}

template <int Dim>
dem::ChainBatch<Dim> block_of(const dem::Fiber& fiber, dem::Clamps clamps, dem::BondForm form, double dt) {
  return {{dem::straight_chain<Dim>(fiber)},
          clamps,
          {dt},
          {0.0},
          {.dimension = Dim,
           .form = form,
           .damped = true,
           .settling_damping = false,
           .curved = false,
           .solved = dem::Solved::bonds},
          dem::best_instruction_set()};
}

template <int Dim>
dem::Vec<double, Dim> pulled_tip(const dem::Fiber& fiber, dem::BondForm form, double load,
                                 int steps_per_period) {
  auto block = block_of<Dim>(fiber, {true, false}, form, dem::first_mode(fiber).period / steps_per_period);
  dem::Load<Dim> end{fiber.aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  if constexpr (Dim == 3) {
    end.force[2] = -0.4 * end.force[1];
    end.moment[0] = 0.3 * end.force[1] * dem::fiber_length(fiber);
  }
  block.set_ramp(0, {{0}, {}}, {{0}, {end}}, steps_per_period);
  block.synchronize();
  block.march(2 * steps_per_period);
  return (1 / dem::fiber_length(fiber)) * block.sphere(0, fiber.aspect_ratio).pose.position;
}

using Vec3 = dem::Vec<double, 3>;

struct Momenta {
  Vec3 linear{}, angular{};
  double linear_size = 0, angular_size = 0;
};

Momenta momenta(const dem::ChainBatch<3>& block, const dem::Fiber& fiber) {
  const double m = dem::sphere_mass(fiber), J = dem::sphere_inertia(fiber);
  Momenta sum;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const auto s = block.sphere(0, i);
    const Vec3 p = m * s.velocity, h = dem::cross(s.pose.position, p) + J * s.spin;
    sum.linear = sum.linear + p;
    sum.angular = sum.angular + h;
    sum.linear_size += dem::norm(p);
    sum.angular_size += dem::norm(h);
  }
  return sum;
}

}  // namespace

template <int Dim>
ObservedOrder order_of_large_motion(dem::BondForm form, double load) {
  constexpr int coarsest = 320;
  const dem::Fiber fiber = fiber_of(13, 0.7);
  dem::Vec<double, Dim> tips[3];
  for (int k = 0; k < 3; ++k) tips[k] = pulled_tip<Dim>(fiber, form, load, coarsest << k);
  const double coarse = dem::norm(tips[0] - tips[1]), fine = dem::norm(tips[1] - tips[2]);
  return {std::log2(coarse / fine), 4 * coarse / 3,
          dem::first_mode(fiber).period / coarsest / dem::bond_time_step(fiber)};
}

MomentumChange momentum_change(dem::BondForm form, double ratio) {
  const dem::Fiber fiber = fiber_of(21, 0.4);
  const double dt = ratio * dem::bond_time_step(fiber), turn = 0.01 / dt;  // of a bond in a step [rad]
  auto block = block_of<3>(fiber, {false, false}, form, dt);
  std::mt19937 generator(9);
  std::normal_distribution<double> normal;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto s = block.sphere(0, i);
    for (double& v : s.velocity.c) v = turn * dem::bond_length(fiber) * normal(generator);
    for (double& w : s.spin.c) w = turn * normal(generator);
    block.set_sphere(0, i, s);
  }
  const Momenta before = momenta(block, fiber);
  block.march(2000);
  const Momenta after = momenta(block, fiber);
  return {dem::norm(after.linear - before.linear) / before.linear_size,
          dem::norm(after.angular - before.angular) / before.angular_size};
}

template ObservedOrder order_of_large_motion<2>(dem::BondForm, double);
template ObservedOrder order_of_large_motion<3>(dem::BondForm, double);

}  // namespace fiberchain::compare
