#pragma once

#include "dem/math/near_one.hpp"
#include "dem/math/vec.hpp"

// Hertz-Mindlin contact of two spheres, or of a sphere and a wall, with dashpots and Coulomb friction. A template on the
// number type: a double, or as many contacts side by side as a Real has lanes.
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
};

/// What a contact remembers.
template <class Real>
struct ContactHistory {
  Vec<Real, 3> spring;  ///< tangential spring force on the first body [N]
  Real overlap;         ///< at the step before [m]; 0 before the first touch
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

/// Power [W] that each mechanism takes, and the energy [J] that the springs hold.
template <class Real>
struct ContactBook {
  Real normal_dashpot, sliding, rolling, elastic;
};

template <class Real>
Vec<Real, 3> tangential(const Vec<Real, 3>& u, const Vec<Real, 3>& normal) {
  return u - dot(u, normal) * normal;
}

/// Force on the first body over one step `dt`; the history moves on. Normal: max(0, k d^1.5 + c d^0.25 d'). Tangential:
/// increments 8 G* sqrt(R* d) u dt of a spring that turns with the contact, less by sqrt(d / d_before) on unloading
/// (Thornton, Cummins & Cleary, Powder Technol. 233 (2013) 30), a dashpot beside it, both together at most mu F_n.
template <class Real>
ContactAction<Real> contact_action(const ContactParameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                   ContactHistory<Real>& history) {
  using std::max;
  using std::min;
  using std::sqrt;
  const Real root = sqrt(pair.overlap), quarter = sqrt(root);
  const Real opening = dot(pair.velocity, pair.normal);
  const Real push = max(Real(0.0), p.normal * root * pair.overlap - p.normal_damping * quarter * opening);
  const Vec<Real, 3> slip = pair.velocity - opening * pair.normal;

  Vec<Real, 3> spring = tangential(history.spring, pair.normal);
  spring = spring + (dt * dot(pair.mean_spin, pair.normal)) * cross(pair.normal, spring);
  const Real unloading = min(Real(1.0), sqrt(pair.overlap / max(history.overlap, Real(1e-300))));
  spring = unloading * spring + (dt * p.tangential * root) * slip;
  const Vec<Real, 3> dashpot = (p.tangential_damping * quarter) * slip;
  Vec<Real, 3> drag = spring + dashpot;
  const Real limit = p.friction * push;
  const Real scale = min(Real(1.0), limit / sqrt(max(dot(drag, drag), Real(1e-300))));
  drag = scale * drag;
  // a sliding contact's spring is what is left with the dashpot's share taken off
  const Real sliding = select(scale < Real(1.0), Real(1.0), Real(0.0));
  spring = spring + sliding * (drag - dashpot - spring);
  history = {spring, pair.overlap};

  const Vec<Real, 3> rolling = tangential(pair.spin, pair.normal);
  const Real rate = sqrt(max(dot(rolling, rolling), Real(1e-300)));
  const Vec<Real, 3> moment = min(p.rolling_limit, p.rolling * push / rate) * rolling;
  return {drag - push * pair.normal, moment};
}

}  // namespace fiberchain::dem
