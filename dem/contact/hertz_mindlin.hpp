#pragma once

#include "dem/math/inverse_sqrt.hpp"
#include "dem/math/near_one.hpp"
#include "dem/math/vec.hpp"

// Hertz-Mindlin contact of two spheres, or of a sphere and a wall, with dashpots and Coulomb friction. A
// template on the number type: a double, or as many contacts side by side as a Real has lanes.
namespace fiberchain::dem {

/// What the law needs of a pair of bodies.
template <class Real>
struct ContactParameters {
  Real normal;              ///< 4/3 E* sqrt(R*) [N/m^1.5]
  Real tangential;          ///< 8 G* sqrt(R*) [N/m^1.5]
  Real normal_damping;      ///< 2 zeta sqrt(5/4 m* normal) [N s/m^1.25]
  Real tangential_damping;  ///< 2 zeta sqrt(5/6 m* tangential) [N s/m^1.25]
  Real friction;            ///< Coulomb's mu [-]
  Real rolling;             ///< mu_r R* [m]
  Real rolling_limit;       ///< J* / dt: the moment over spin that stops rolling within a step [N m s]
  /// 1/2: the normal dashpot acts at the velocity in the middle of its kick, extrapolated from the step
  /// before, which needs ContactHistory::normal_velocity saved; 0: at the velocity half a step before.
  Real extrapolation = Real(0.0);
};

/// What a contact remembers.
template <class Real>
struct ContactHistory {
  Vec<Real, 3> spring;       ///< tangential spring force on the first body [N]
  Real sqrt_overlap;                 ///< square sqrt_overlap of the overlap at the step before [m^0.5]; 0 before the first touch
  Real normal_velocity = Real(0.0);  ///< normal velocity at the step before [m/s]
  Real rolling_power = Real(0.0);  ///< of rolling friction at the step before [W]
};

/// Two bodies that touch. The second one is pushed along `normal`.
template <class Real>
struct TouchingPair {
  Vec<Real, 3> normal;    ///< from the first to the second
  Real overlap;           ///< > 0 [m]
  Vec<Real, 3> velocity;  ///< of the second's surface against the first's at the contact [m/s]
  Vec<Real, 3> spin;      ///< of the second against the first [1/s]
  Vec<Real, 3> mean_spin;
};

template <class Real>
struct ContactAction {
  Vec<Real, 3> force;   ///< on the first body, at the contact [N]
  Vec<Real, 3> moment;  ///< of rolling friction on the first body; minus that on the second [N m]
};

/// Energy [J] that each mechanism has dissipated.
template <class Real>
struct ContactAccount {
  Real normal_dashpot, sliding, rolling;
};

template <class Real>
Vec<Real, 3> tangential(const Vec<Real, 3>& u, const Vec<Real, 3>& normal) {
  return u - dot(u, normal) * normal;
}

/// Force on the first body over one step `dt`; the history moves on. Velocities are those half a step before.
/// Normal: max(0, k d^1.5 + c d^0.25 d'). Tangential: increments 8 G* sqrt(R* d) u dt of a spring that turns
/// with the contact, less by sqrt(d / d_before) on unloading (Thornton, Cummins & Cleary, Powder Technol. 233
/// (2013) 30), a dashpot beside it, both together at most mu F_n. Where they slide, the spring moves on as
/// the dashpot lets it under mu F_n: spring and dashpot stretch alike, a slider in series, which never gives
/// energy that it was not given. A resting contact carries what Hertz's spring does, whatever the step.
/// `rolls`: with rolling friction.
template <bool rolls = true, class Real>
ContactAction<Real> contact_action(const ContactParameters<Real>& p, const TouchingPair<Real>& pair,
                                   const Real& dt, ContactHistory<Real>& history) {
  using std::max;
  using std::min;
  using std::sqrt;
  const Real sqrt_overlap = sqrt(pair.overlap), sqrt_overlap_before = max(history.sqrt_overlap, Real(1e-150));
  const Real quarter = sqrt(sqrt_overlap);
  const Real normal_velocity = dot(pair.velocity, pair.normal);
  const Real change = select(history.sqrt_overlap > Real(0.0), normal_velocity - history.normal_velocity, Real(0.0));
  const Real normal_force = max(
      Real(0.0), p.normal * sqrt_overlap * pair.overlap - p.normal_damping * quarter * (normal_velocity + p.extrapolation * change));
  const Vec<Real, 3> slip = pair.velocity - normal_velocity * pair.normal;

  Vec<Real, 3> before = tangential(history.spring, pair.normal);
  before = before + (dt * dot(pair.mean_spin, pair.normal)) * cross(pair.normal, before);
  before = min(Real(1.0), sqrt_overlap / sqrt_overlap_before) * before;
  // the mean over the step on loading; on unloading spring / sqrt(d) grows by 8 G* sqrt(R*) u dt
  const Real stiffness = dt * p.tangential * (Real(0.5) * (sqrt_overlap + min(sqrt_overlap, sqrt_overlap_before)));
  const Real dashpot = p.tangential_damping * quarter;
  Vec<Real, 3> tangential_force = before + (stiffness + dashpot) * slip;
  const Real limit = p.friction * normal_force;
  const Real scale = min(Real(1.0), limit * inverse_sqrt(max(dot(tangential_force, tangential_force), Real(1e-290))));
  tangential_force = scale * tangential_force;
  // before + stiffness r + dashpot r = tangential_force, r the rate at which the spring is stretched: stuck, the slip
  // itself
  const Real share = stiffness / max(stiffness + dashpot, Real(1e-300));
  history = {before + share * (tangential_force - before), sqrt_overlap, normal_velocity};

  const Vec<Real, 3> force = tangential_force - normal_force * pair.normal;
  if constexpr (!rolls) return {force, {Real(0.0), Real(0.0), Real(0.0)}};
  const Vec<Real, 3> rolling = tangential(pair.spin, pair.normal);
  const Real inverse_rate = inverse_sqrt(max(dot(rolling, rolling), Real(1e-290)));
  const Vec<Real, 3> moment = min(p.rolling_limit, p.rolling * normal_force * inverse_rate) * rolling;
  history.rolling_power = dot(moment, pair.spin);
  return {force, moment};
}

}  // namespace fiberchain::dem
