#pragma once

#include "dem/bond/configuration.hpp"

// The paper's incremental form (Eqs 3-6): strains summed over the steps, turned with the bond. Increments are
// taken at the middle of the step, so that the sum is second order in the step.
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

/// The bond's vector at an earlier moment of the step, by the length at its end.
template <class Real, int Dim>
BondVector<Real, Dim> earlier(const BondVector<Real, Dim>& end, const Vec<Real, Dim>& vector) {
  const Real squared = dot(vector, vector);
  const Real ratio = squared * (end.inverse_length * end.inverse_length);
  return {vector, squared, end.inverse_length * inverse_sqrt_below_one(Real(1.0) - ratio)};
}

/// The smallest turn that brings the bond's old axis to the new one, as half-angle tangent vector: applying
/// it needs no trigonometry. With r_0, r_1 = m -+ s / 2 it is r_0 x r_1 / (|r_0| |r_1| + r_0.r_1) = m x s /
/// (2 m^2 (1 - k)), k = (m.s / 2 m^2)^2; against it what is left out is of fourth order in s / |m|.
template <class Real>
Vec<Real, 3> swing_of(const Vec<Real, 3>& middle, const Vec<Real, 3>& slide, const Real& inverse_length) {
  const Real scale = Real(0.5) * (inverse_length * inverse_length);
  const Real stretch = scale * dot(middle, slide);
  const Vec<Real, 3> swing = scale * cross(middle, slide);
  return swing + (stretch * stretch) * swing;
}

/// Turn of the bond over the step: the swing, then the mean spin of its spheres about the new axis, likewise.
template <class Real>
Vec<Real, 3> bond_turn(const Vec<Real, 3>& swing, const Vec<Real, 3>& new_axis, const Real& axial_angle) {
  const Vec<Real, 3> about = (Real(0.5) * axial_angle) * new_axis;
  return plus_cross(swing + about, about, swing);
}

/// Scale 2 / (1 + t.t) of turn_by, in powers of t.t to eighth order.
template <class Real>
Real turn_scale(const Vec<Real, 3>& half_tangent) {
  const Real tt = dot(half_tangent, half_tangent), two = Real(2.0) - Real(2.0) * tt;
  return two + two * (tt * tt);
}

template <class Real>
Vec<Real, 3> turn_by(const Vec<Real, 3>& half_tangent, const Real& scale, const Vec<Real, 3>& u) {
  const Vec<Real, 3> t = cross(half_tangent, u);
  return u + scale * plus_cross(t, half_tangent, t);
}

template <class Real>
void advance(BondHistory<Real, 2>& history, const BondVector<Real, 2>& end,
             const RelativeMotion<Real, 2>& motion, const Real& dt) {
  const Vec<Real, 2> slide = dt * motion.velocity;
  const BondVector<Real, 2> middle = earlier(end, end.vector - Real(0.5) * slide);
  const Real turn = dt * motion.mean_spin[0];
  history.stretch = history.stretch + middle.inverse_length * dot(middle.vector, slide);
  history.shear =
      history.shear + middle.inverse_length * (cross(middle.vector, slide)[0] - turn * middle.length_squared);
  history.bend = history.bend + dt * motion.relative_spin;
}

template <class Real>
void advance(BondHistory<Real, 3>& history, const BondVector<Real, 3>& end,
             const RelativeMotion<Real, 3>& motion, const Real& dt) {
  const Vec<Real, 3> slide = dt * motion.velocity;
  const BondVector<Real, 3> middle = earlier(end, end.vector - Real(0.5) * slide);
  const Real axial_angle = dt * middle.inverse_length * dot(motion.mean_spin, middle.vector);
  const Vec<Real, 3> turn = bond_turn(swing_of(middle.vector, slide, middle.inverse_length),
                                      end.inverse_length * end.vector, axial_angle);
  const Real scale = turn_scale(turn);
  const Vec<Real, 3> half_slide =
      (Real(0.5) * dt) * plus_cross(motion.velocity, middle.vector, motion.mean_spin);
  const Vec<Real, 3> half_rotation = (Real(0.5) * dt) * motion.relative_spin;
  history.displacement = turn_by(turn, scale, history.displacement + half_slide) + half_slide;
  history.rotation = turn_by(turn, scale, history.rotation + half_rotation) + half_rotation;
}

/// N of the summed strain.
template <class Real>
Real spring_tension(const BondParameters<Real>& bond, const BondHistory<Real, 2>& history,
                    const BondVector<Real, 2>&) {
  return tension(bond, history.stretch, bend_squared(history.bend));
}

template <class Real>
Real spring_tension(const BondParameters<Real>& bond, const BondHistory<Real, 3>& history,
                    const BondVector<Real, 3>& b) {
  const Vec<Real, 3> e = b.inverse_length * b.vector;
  const Real twist = dot(history.rotation, e);
  return tension(bond, dot(history.displacement, e), dot(history.rotation, history.rotation) - twist * twist);
}

/// Force and moment of the summed strain by the same law (tension, shear, twist and bending with the chord's
/// moment) and, with `damped`, of the dashpots. In the plane along and across the bond.
template <bool damped, class Real>
BondAction<Real, 2> incremental_action(const BondParameters<Real>& bond, const BondHistory<Real, 2>& history,
                                       const BondVector<Real, 2>& b, const RelativeMotion<Real, 2>& motion) {
  const Real N = tension(bond, history.stretch, bend_squared(history.bend));
  Real along = N, across = bond.shear * history.shear;
  Vec<Real, 1> moment = bending_coefficient(bond, N) * history.bend;
  if constexpr (damped) {
    along = along + bond.dash_stretch * (b.inverse_length * dot(b.vector, motion.velocity));
    const Real sliding = cross(b.vector, motion.velocity)[0] - motion.mean_spin[0] * b.length_squared;
    across = across + bond.dash_shear * (b.inverse_length * sliding);
    moment = moment + bond.dash_bend * motion.relative_spin;
  }
  along = along * b.inverse_length, across = across * b.inverse_length;
  return {{along * b.vector[0] - across * b.vector[1], along * b.vector[1] + across * b.vector[0]}, moment};
}

template <bool damped, class Real>
BondAction<Real, 3> incremental_action(const BondParameters<Real>& bond, const BondHistory<Real, 3>& history,
                                       const BondVector<Real, 3>& b, const RelativeMotion<Real, 3>& motion) {
  const Vec<Real, 3> e = b.inverse_length * b.vector;
  const Real stretch = dot(history.displacement, e);
  const Real twist = dot(history.rotation, e);
  const Real N = tension(bond, stretch, dot(history.rotation, history.rotation) - twist * twist);
  const Real bend = bending_coefficient(bond, N);
  Vec<Real, 3> force = bond.shear * history.displacement, moment = bend * history.rotation;
  Real along = N - bond.shear * stretch, about = (bond.twist - bend) * twist;
  if constexpr (damped) {
    force = force + bond.dash_shear * plus_cross(motion.velocity, b.vector, motion.mean_spin);
    along = along + (bond.dash_stretch - bond.dash_shear) * dot(motion.velocity, e);
    moment = moment + bond.dash_bend * motion.relative_spin;
    about = about + (bond.dash_twist - bond.dash_bend) * dot(motion.relative_spin, e);
  }
  return {force + along * e, moment + about * e};
}

/// Elastic energy of the summed strain [J].
inline double stored_energy(const BondParameters<double>& bond, const BondHistory<double, 2>& h,
                            const Vec<double, 2>&) {
  const double N = tension(bond, h.stretch, bend_squared(h.bend));
  return 0.5 * (N * N / bond.stretch + bond.shear * h.shear * h.shear + bond.bend * bend_squared(h.bend));
}

template <class Real>
Real stored_energy(const BondParameters<Real>& bond, const BondHistory<Real, 3>& h, const Vec<Real, 3>& e) {
  const Real stretch = dot(h.displacement, e), twist = dot(h.rotation, e);
  const Real shear_squared = dot(h.displacement, h.displacement) - stretch * stretch;
  const Real bend = dot(h.rotation, h.rotation) - twist * twist;
  const Real N = tension(bond, stretch, bend);
  return Real(0.5) *
         (N * N / bond.stretch + bond.shear * shear_squared + bond.bend * bend + bond.twist * twist * twist);
}

/// The history with which the incremental form carries the same force and moment as `loads`: where a march of
/// it starts from an equilibrium. The shear torque of the bond's middle is taken off the moment first.
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
