#pragma once

#include "dem/bond/dashpot.hpp"

// The paper's incremental form (Eqs 3-6): strains summed over the steps, turned with the bond. Increments are taken
// at the middle of the step, so that the sum is second order in the step.
namespace fiberchain::dem {

/// Strain summed so far. In the plane its components along and across the bond turn with it by themselves.
template <class Real, int Dim>
struct BondHistory;

template <class Real>
struct BondHistory<Real, 2> {
  Real stretch, shear;  ///< delta_n, delta_t [m]
  Vec<Real, 1> bend;    ///< theta_t [rad]
};

template <class Real>
struct BondHistory<Real, 3> {
  Vec<Real, 3> displacement;  ///< delta_n e + delta_t, global frame [m]
  Vec<Real, 3> rotation;      ///< theta_n e + theta_t, global frame [rad]
};

template <class Real, int Dim>
Vec<Real, Dim> unit(const Vec<Real, Dim>& u) {
  return (Real(1.0) / norm(u)) * u;
}

/// Turn of the bond over the step: the smallest that brings its old axis to the new one, then the mean spin of its
/// spheres about it. As half-angle tangent vector, so that applying it is exact and needs no trigonometry.
template <class Real>
Vec<Real, 3> bond_turn(const Vec<Real, 3>& old_axis, const Vec<Real, 3>& new_axis, const Real& axial_angle) {
  const Vec<Real, 3> swing = (Real(1.0) / (Real(1.0) + dot(old_axis, new_axis))) * cross(old_axis, new_axis);
  return swing + (Real(0.5) * axial_angle) * (new_axis + cross(new_axis, swing));
}

template <class Real>
Vec<Real, 3> turn_by(const Vec<Real, 3>& half_tangent, const Vec<Real, 3>& u) {
  const Vec<Real, 3> t = cross(half_tangent, u);
  const Real scale = Real(2.0) / (Real(1.0) + dot(half_tangent, half_tangent));
  return u + scale * (t + cross(half_tangent, t));
}

template <class Real>
void advance(BondHistory<Real, 2>& history, const Vec<Real, 2>& end, const Vec<Real, 2>&,
             const RelativeMotion<Real, 2>& motion, const Real& dt) {
  const Vec<Real, 2> middle = end - (Real(0.5) * dt) * motion.velocity;
  const Vec<Real, 2> axis = unit(middle);
  const Vec<Real, 2> sliding = dt * (motion.velocity - cross(motion.mean_spin, middle));
  history.stretch = history.stretch + dot(axis, sliding);
  history.shear = history.shear + cross(axis, sliding)[0];
  history.bend = history.bend + dt * motion.relative_spin;
}

template <class Real>
void advance(BondHistory<Real, 3>& history, const Vec<Real, 3>& end, const Vec<Real, 3>& end_axis,
             const RelativeMotion<Real, 3>& motion, const Real& dt) {
  const Vec<Real, 3> start = end - dt * motion.velocity;
  const Vec<Real, 3> middle = Real(0.5) * (start + end);
  const Vec<Real, 3> turn = bond_turn(unit(start), end_axis, dt * dot(motion.mean_spin, unit(middle)));
  const Vec<Real, 3> half_slide = (Real(0.5) * dt) * (motion.velocity - cross(motion.mean_spin, middle));
  const Vec<Real, 3> half_rotation = (Real(0.5) * dt) * motion.relative_spin;
  history.displacement = turn_by(turn, history.displacement + half_slide) + half_slide;
  history.rotation = turn_by(turn, history.rotation + half_rotation) + half_rotation;
}

/// Spring forces of the summed strain by the same law: tension, shear, twist and bending with the chord's moment.
template <class Real>
BondAction<Real, 2> spring_action(const BondParameters<Real>& bond, const BondHistory<Real, 2>& history,
                                  const Vec<Real, 2>& e) {
  const Real N = tension(bond, history.stretch, bend_squared(history.bend));
  const Real Q = bond.shear * history.shear;
  return {{N * e[0] - Q * e[1], N * e[1] + Q * e[0]},
          scale_spin(bond.twist, bending_coefficient(bond, N), history.bend)};
}

template <class Real>
BondAction<Real, 3> spring_action(const BondParameters<Real>& bond, const BondHistory<Real, 3>& history,
                                  const Vec<Real, 3>& e) {
  const Real stretch = dot(history.displacement, e);
  const Real twist = dot(history.rotation, e);
  const Real N = tension(bond, stretch, dot(history.rotation, history.rotation) - twist * twist);
  return {bond.shear * history.displacement + (N - bond.shear * stretch) * e,
          scale_about(bond.twist, bending_coefficient(bond, N), e, history.rotation)};
}

/// Elastic energy of the summed strain [J].
inline double stored_energy(const BondParameters<double>& bond, const BondHistory<double, 2>& h, const Vec<double, 2>&) {
  const double N = tension(bond, h.stretch, bend_squared(h.bend));
  return 0.5 * (N * N / bond.stretch + bond.shear * h.shear * h.shear + bond.bend * bend_squared(h.bend));
}

inline double stored_energy(const BondParameters<double>& bond, const BondHistory<double, 3>& h,
                            const Vec<double, 3>& e) {
  const double stretch = dot(h.displacement, e), twist = dot(h.rotation, e);
  const double shear_squared = dot(h.displacement, h.displacement) - stretch * stretch;
  const double bend = dot(h.rotation, h.rotation) - twist * twist;
  const double N = tension(bond, stretch, bend);
  return 0.5 * (N * N / bond.stretch + bond.shear * shear_squared + bond.bend * bend + bond.twist * twist * twist);
}

/// The history with which the incremental form carries the same force and moment as `loads`: where a march of it
/// starts from an equilibrium. The shear torque of the bond's middle is taken off the moment first.
inline BondHistory<double, 2> history_of(const BondParameters<double>& bond, const Vec<double, 2>& separation,
                                         const BondLoads<double, 2>& loads) {
  const Vec<double, 2> e = unit(separation);
  const double N = dot(loads.force_on_first, e), Q = cross(e, loads.force_on_first)[0];
  const double moment = 0.5 * (loads.moment_on_first[0] - loads.moment_on_second[0]);
  const Vec<double, 1> bend{moment / bending_coefficient(bond, N)};
  return {N / bond.stretch - bond.rest_length * bond.chord * bend_squared(bend), Q / bond.shear, bend};
}

inline BondHistory<double, 3> history_of(const BondParameters<double>& bond, const Vec<double, 3>& separation,
                                         const BondLoads<double, 3>& loads) {
  const Vec<double, 3> e = unit(separation);
  const double N = dot(loads.force_on_first, e);
  const Vec<double, 3> moment = 0.5 * (loads.moment_on_first - loads.moment_on_second);
  const Vec<double, 3> rotation = scale_about(1 / bond.twist, 1 / bending_coefficient(bond, N), e, moment);
  const double twist = dot(rotation, e);
  const double stretch =
      N / bond.stretch - bond.rest_length * bond.chord * (dot(rotation, rotation) - twist * twist);
  return {(1 / bond.shear) * (loads.force_on_first - N * e) + stretch * e, rotation};
}

}  // namespace fiberchain::dem
