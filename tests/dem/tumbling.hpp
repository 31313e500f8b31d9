#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "tests/dem/free_motion.hpp"

/// A free, damped chain of 7 spheres that tumbles end over end until nothing but the rotation is left of its
/// motion.
namespace marching {

struct Tumbling {
  double stretch;   ///< largest relative difference of a bond's strain from that of the steady rotation
  double slowing;   ///< relative change of the angular momentum
  double momentum;  ///< momentum, over the size of its parts
  double turns;     ///< made
  double strain;    ///< of the middle bonds
};

/// Strains of the steady rotation by `angle` a step, exactly as leapfrog has them: centers on circles with
/// the acceleration 2(1 - cos angle)/dt^2 times the radius, and lagged dashpots that see the bond turn by
/// half a step, an apparent stretching of (2 l/dt) sin^2(angle/2).
inline Eigen::VectorXd rotating_strains(const dem::Fiber& fiber, double angle, double dt) {
  const dem::BondParameters<double> bond = dem::bond_parameters(fiber);
  const int n = fiber.aspect_ratio;
  const double pull = dem::sphere_mass(fiber) * 2 * (1 - std::cos(angle)) / (dt * dt);
  const double k = bond.stretch + bond.dash_stretch * 2 / dt * std::pow(std::sin(angle / 2), 2);
  Eigen::MatrixXd balance = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n + 1);
  for (int i = 0; i <= n; ++i) {
    balance(i, i) = pull;
    for (const int other : {i - 1, i + 1}) {
      if (other < 0 || other > n) continue;
      balance(i, i) -= k;
      balance(i, other) = k;
      load(i) += (other - i) * bond.stretch * bond.rest_length;
    }
  }
  const Eigen::VectorXd position = balance.partialPivLu().solve(load);
  return (position.tail(n) - position.head(n)) / bond.rest_length - Eigen::VectorXd::Ones(n);
}

template <int Dim>
dem::Spin<double, Dim> tumbling_axis() {
  if constexpr (Dim == 2) return {1.0};
  if constexpr (Dim == 3) return {0, 0.6, 0.8};
}

/// Tumbles for a number of turns as begun; it slows when centrifugal force stretches it.
template <int Dim>
Tumbling tumble(dem::BondForm form, double turns, double step_ratio) {
  const dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.3, 431), 0.0262, 6, dem::BondModel::paper, 0.3};
  const double dt = step_ratio * dem::stable_time_step(fiber), rate = 0.05 / dem::bond_time_step(fiber);
  const double l = dem::bond_length(fiber);
  dem::ChainBatch<Dim> block(
      {dem::straight_chain<Dim>(fiber)}, {false, false}, {dt}, {0.0},
      {.dimension = Dim, .form = form, .damped = true, .settling_damping = false, .curved = false},
      dem::InstructionSet::scalar);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(0, i);
    sphere.pose.position[0] -= fiber.aspect_ratio / 2.0 * l;
    sphere.spin = rate * tumbling_axis<Dim>();
    sphere.velocity = dem::cross(sphere.spin, sphere.pose.position);
    block.set_sphere(0, i, sphere);
  }
  block.synchronize();
  const Account<Dim> before = account(block, fiber);
  const auto span = [&] {
    return dem::unit(block.sphere(0, fiber.aspect_ratio).pose.position - block.sphere(0, 0).pose.position);
  };
  const double steps = std::ceil(turns * 2 * std::numbers::pi / (rate * dt));
  for (double done = 0; done < steps; done += 1e6) block.march(static_cast<int>(std::min(1e6, steps - done)));
  const Account<Dim> after = account(block, fiber);
  Eigen::VectorXd strain(fiber.aspect_ratio);
  for (int i = 0; i < fiber.aspect_ratio; ++i) {
    strain(i) = dem::norm(block.sphere(0, i + 1).pose.position - block.sphere(0, i).pose.position) / l - 1;
  }
  const auto now = span();
  block.march(1);
  const double angle = 2 * std::asin(0.5 * dem::norm(span() - now));
  const Eigen::VectorXd steady = rotating_strains(fiber, angle, dt);
  return {(strain - steady).cwiseAbs().maxCoeff() / steady.maxCoeff(), angular_drift(before, after),
          dem::norm(after.momentum) / after.momentum_scale, angle * steps / (2 * std::numbers::pi),
          steady.maxCoeff()};
}

}  // namespace marching
