#pragma once

#include "dem/bond/law.hpp"

// Dashpots beside the springs (Eqs 7-10), and how a bond's force and moment act on its two spheres.
namespace fiberchain::dem {

/// Relative motion of the two spheres of a bond, global frame.
template <class Real, int Dim>
struct RelativeMotion {
  Vec<Real, Dim> velocity;        ///< V = v_2 - v_1 [m/s]
  Spin<Real, Dim> mean_spin;      ///< (w_1 + w_2) / 2 [1/s]
  Spin<Real, Dim> relative_spin;  ///< w_2 - w_1 [1/s]
};

/// Force and moment carried by a bond, global frame, as they act on its first sphere.
template <class Real, int Dim>
struct BondAction {
  Vec<Real, Dim> force;
  Spin<Real, Dim> moment;
};

template <class Real, int Dim>
BondAction<Real, Dim> operator+(const BondAction<Real, Dim>& a, const BondAction<Real, Dim>& b) {
  return {a.force + b.force, a.moment + b.moment};
}

/// along times the component of w along e, across times the rest; in the plane all spin is across.
template <class Real>
Vec<Real, 1> scale_about(const Real&, const Real& across, const Vec<Real, 2>&, const Vec<Real, 1>& w) {
  return {across * w[0]};
}

template <class Real>
Vec<Real, 3> scale_about(const Real& along, const Real& across, const Vec<Real, 3>& e,
                         const Vec<Real, 3>& w) {
  return across * w + ((along - across) * dot(w, e)) * e;
}

/// F_dn + F_dt and M_dn + M_dt, the tangential velocity with the spin of both spheres.
template <class Real, int Dim>
BondAction<Real, Dim> dashpot_action(const BondParameters<Real>& bond, const Vec<Real, Dim>& separation,
                                     const Vec<Real, Dim>& e, const RelativeMotion<Real, Dim>& motion) {
  const Vec<Real, Dim> sliding = motion.velocity - cross(motion.mean_spin, separation);
  const Real along = (bond.dash_stretch - bond.dash_shear) * dot(motion.velocity, e);
  return {bond.dash_shear * sliding + along * e,
          scale_about(bond.dash_twist, bond.dash_bend, e, motion.relative_spin)};
}

/// The force acts at the middle of the bond, arm half its current length: momentum and angular momentum
/// balance.
template <class Real, int Dim>
BondLoads<Real, Dim> act_at_middle(const Vec<Real, Dim>& separation, const BondAction<Real, Dim>& action) {
  const Spin<Real, Dim> half_torque = Real(0.5) * cross(separation, action.force);
  return {action.force, half_torque + action.moment, half_torque - action.moment};
}

/// What loads take from two spheres at these velocities [W].
template <class Real, int Dim>
Real power_taken(const BondLoads<Real, Dim>& loads, const Vec<Real, Dim>& velocity_between,
                 const Spin<Real, Dim>& first_spin, const Spin<Real, Dim>& second_spin) {
  return dot(loads.force_on_first, velocity_between) - dot(loads.moment_on_first, first_spin) -
         dot(loads.moment_on_second, second_spin);
}

template <class Real, int Dim>
BondLoads<Real, Dim> operator+(const BondLoads<Real, Dim>& a, const BondLoads<Real, Dim>& b) {
  return {a.force_on_first + b.force_on_first, a.moment_on_first + b.moment_on_first,
          a.moment_on_second + b.moment_on_second};
}

}  // namespace fiberchain::dem
