#pragma once

#include <cmath>

#include "dem/motion/kernels/chain_batch.hpp"

/// What a free chain must keep: momentum, angular momentum and, undamped, energy.
namespace marching {

namespace dem = fiberchain::dem;

/// Momentum and angular momentum about the origin, with the sizes they are sums of.
template <int Dim>
struct Account {
  dem::Vec<double, Dim> momentum{};
  dem::Spin<double, Dim> angular{};
  double momentum_scale = 0, angular_scale = 0;
};

template <int Dim>
Account<Dim> account(const dem::ChainBatch<Dim>& block, const dem::Fiber& fiber, int lane = 0) {
  Account<Dim> sum;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const double share = dem::mass_share(fiber, i);
    const double m = share * dem::sphere_mass(fiber), J = share * dem::sphere_inertia(fiber);
    const auto s = block.sphere(lane, i);
    sum.momentum = sum.momentum + m * s.velocity;
    sum.angular = sum.angular + m * dem::cross(s.pose.position, s.velocity) + J * s.spin;
    sum.momentum_scale += m * dem::norm(s.velocity);
    sum.angular_scale += m * dem::norm(s.pose.position) * dem::norm(s.velocity) + J * dem::norm(s.spin);
  }
  return sum;
}

/// Drift of either since `before`, over its size then.
template <int Dim>
double momentum_drift(const Account<Dim>& before, const Account<Dim>& after) {
  return dem::norm(after.momentum - before.momentum) / before.momentum_scale;
}

template <int Dim>
double angular_drift(const Account<Dim>& before, const Account<Dim>& after) {
  return dem::norm(after.angular - before.angular) / before.angular_scale;
}

/// Elastic energy of the bonds, from the poses or from the summed strain [J].
template <int Dim>
double elastic_energy(const dem::ChainBatch<Dim>& block, const dem::Chain<Dim>& chain, dem::BondForm form,
                      int lane) {
  if (form == dem::BondForm::total) return dem::elastic_energy(chain, block.poses(lane));
  const auto bond = dem::bond_parameters(chain.fiber);
  double sum = 0;
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const auto axis = block.sphere(lane, i + 1).pose.position - block.sphere(lane, i).pose.position;
    sum += dem::stored_energy(bond, block.history(lane, i), dem::unit(axis));
  }
  return sum;
}

/// Kinetic energy at the step: velocities half a step before are moved on by the forces at the step [J].
template <int Dim>
double kinetic_energy(const dem::ChainBatch<Dim>& block, const dem::Fiber& fiber, double dt, int lane) {
  double sum = 0;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const double share = dem::mass_share(fiber, i);
    const double m = share * dem::sphere_mass(fiber), J = share * dem::sphere_inertia(fiber);
    const auto s = block.sphere(lane, i);
    const auto v = s.velocity + (0.5 * dt / m) * s.force;
    const auto w = s.spin + (0.5 * dt / J) * s.moment;
    sum += 0.5 * (m * dem::dot(v, v) + J * dem::dot(w, w));
  }
  return sum;
}

}  // namespace marching
