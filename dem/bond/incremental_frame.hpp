#pragma once

#include "dem/bond/branches.hpp"
#include "dem/bond/incremental.hpp"

// The incremental form by components: strains summed along the bond and along two directors across it, which
// turn with it, as they turn the strain of BondHistory. Nothing but one director has to be turned, however
// many Maxwell branches keep strains of their own.
namespace fiberchain::dem {

/// Strains summed so far, in the bond's frame.
template <class Real, int Dim>
struct BondFrameHistory;

template <class Real>
struct BondFrameHistory<Real, 2> : BondHistory<Real, 2> {};

template <class Real>
struct BondFrameHistory<Real, 3> {
  Real stretch;           ///< delta_n [m]
  Vec<Real, 2> shear;     ///< delta_t [m]
  Real twist;             ///< theta_n [rad]
  Vec<Real, 2> bend;      ///< theta_t [rad]
  Vec<Real, 3> director;  ///< unit vector across the bond; the other one is e x director
};

/// Axes of a bond's frame.
template <class Real, int Dim>
struct BondAxes {
  Vec<Real, Dim> along;
  Vec<Real, Dim> across[across_size<Dim>];

  Vec<Real, across_size<Dim>> components_across(const Vec<Real, Dim>& u) const {
    Vec<Real, across_size<Dim>> all;
    for (int c = 0; c < across_size<Dim>; ++c) all[c] = dot(across[c], u);
    return all;
  }
  Vec<Real, Dim> sum(const Real& a, const Vec<Real, across_size<Dim>>& b) const {
    Vec<Real, Dim> u = a * along;
    for (int c = 0; c < across_size<Dim>; ++c) u = u + b[c] * across[c];
    return u;
  }
};

template <class Real>
BondAxes<Real, 2> axes_of(const BondVector<Real, 2>& line, const BondFrameHistory<Real, 2>&) {
  const Vec<Real, 2> e = line.inverse_length * line.vector;
  return {e, {{Real(0.0) - e[1], e[0]}}};
}

template <class Real>
BondAxes<Real, 3> axes_of(const BondVector<Real, 3>& line, const BondFrameHistory<Real, 3>& history) {
  const Vec<Real, 3> e = line.inverse_length * line.vector;
  return {e, {history.director, cross(e, history.director)}};
}

/// Change of the strains in a step that led here, at its middle. In space the director turns.
template <class Real>
BondStrains<Real, 2> strain_change(BondFrameHistory<Real, 2>&, const BondVector<Real, 2>& end,
                                   const RelativeMotion<Real, 2>& motion, const Real& dt) {
  const Vec<Real, 2> slide = dt * motion.velocity;
  const BondVector<Real, 2> middle = earlier(end, end.vector - Real(0.5) * slide);
  const Real turn = dt * motion.mean_spin[0];
  return {{middle.inverse_length * dot(middle.vector, slide)},
          {middle.inverse_length * (cross(middle.vector, slide)[0] - turn * middle.length_squared)},
          {Real(0.0)},
          dt * motion.relative_spin};
}

template <class Real>
BondStrains<Real, 3> strain_change(BondFrameHistory<Real, 3>& history, const BondVector<Real, 3>& end,
                                   const RelativeMotion<Real, 3>& motion, const Real& dt) {
  const Vec<Real, 3> slide = dt * motion.velocity;
  const BondVector<Real, 3> middle = earlier(end, end.vector - Real(0.5) * slide);
  const Vec<Real, 3> along = middle.inverse_length * middle.vector;
  const Vec<Real, 3> turn = bond_turn(swing_of(middle.vector, slide, middle.inverse_length),
                                      end.inverse_length * end.vector, dt * dot(motion.mean_spin, along));
  const Vec<Real, 3> before = history.director, after = turn_by(turn, turn_scale(turn), before);
  history.director = after;
  const Vec<Real, 3> first = Real(0.5) * (before + after);
  const BondAxes<Real, 3> axes{along, {first, cross(along, first)}};
  const Vec<Real, 3> sliding = dt * plus_cross(motion.velocity, middle.vector, motion.mean_spin),
                     turning = dt * motion.relative_spin;
  return {{dot(along, slide)},
          axes.components_across(sliding),
          {dot(along, turning)},
          axes.components_across(turning)};
}

template <class Real>
void add_strains(BondFrameHistory<Real, 2>& history, const BondStrains<Real, 2>& change) {
  history.stretch = history.stretch + change.stretch[0];
  history.shear = history.shear + change.shear[0];
  history.bend = history.bend + change.bend;
}

template <class Real>
void add_strains(BondFrameHistory<Real, 3>& history, const BondStrains<Real, 3>& change) {
  history.stretch = history.stretch + change.stretch[0];
  history.shear = history.shear + change.shear;
  history.twist = history.twist + change.twist[0];
  history.bend = history.bend + change.bend;
}

/// Strain of shear by components, which the plane keeps as a number.
template <class Real>
Vec<Real, 1> shear_of(const BondFrameHistory<Real, 2>& history) {
  return {history.shear};
}

template <class Real>
Vec<Real, 2> shear_of(const BondFrameHistory<Real, 3>& history) {
  return history.shear;
}

/// theta_b^2
template <class Real, int Dim>
Real bent_squared(const BondFrameHistory<Real, Dim>& history) {
  return dot(history.bend, history.bend);
}

/// A frame's history with the strain that `strain` has in it.
inline BondFrameHistory<double, 2> in_frame(const BondHistory<double, 2>& strain, const Vec<double, 2>&) {
  return {strain};
}

inline BondFrameHistory<double, 3> in_frame(const BondHistory<double, 3>& strain, const Vec<double, 3>& e) {
  // the coordinate axis that is farthest from the bond's
  int axis = 0;
  for (int c = 1; c < 3; ++c) axis = e[c] * e[c] < e[axis] * e[axis] ? c : axis;
  Vec<double, 3> director = -e[axis] * e;
  director[axis] += 1;
  director = unit(director);
  const BondAxes<double, 3> axes{e, {director, cross(e, director)}};
  return {dot(strain.displacement, e), axes.components_across(strain.displacement), dot(strain.rotation, e),
          axes.components_across(strain.rotation), director};
}

/// The reverse.
inline BondHistory<double, 2> out_of_frame(const BondFrameHistory<double, 2>& history,
                                           const Vec<double, 2>&) {
  return history;
}

inline BondHistory<double, 3> out_of_frame(const BondFrameHistory<double, 3>& history,
                                           const Vec<double, 3>& e) {
  const BondAxes<double, 3> axes{e, {history.director, cross(e, history.director)}};
  return {axes.sum(history.stretch, history.shear), axes.sum(history.twist, history.bend)};
}

}  // namespace fiberchain::dem
