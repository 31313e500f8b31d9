#pragma once

#include <string_view>

#include "dem/contact/laws/contact_action.hpp"
#include "dem/math/inverse_sqrt.hpp"
#include "dem/math/near_one.hpp"

namespace fiberchain::dem {

struct ContactProperties;
struct EffectiveBody;

/// Hertz-Mindlin contact of two spheres, or of a sphere and a wall, with dashpots and Coulomb friction. The
/// only place of its formulas.
struct HertzMindlin {
  static constexpr std::string_view name = "hertz_mindlin";
  static constexpr bool acts_beyond_touch = false;

  template <class Real>
  struct Parameters {
    Real normal;              ///< 4/3 E* sqrt(R*) [N/m^1.5]
    Real tangential;          ///< 8 G* sqrt(R*) [N/m^1.5]
    Real normal_damping;      ///< 2 zeta sqrt(5/4 m* normal) [N s/m^1.25]
    Real tangential_damping;  ///< 2 zeta sqrt(5/6 m* tangential) [N s/m^1.25]
    Real friction;            ///< Coulomb's mu [-]
    Real rolling;             ///< mu_r R* [m]
    Real rolling_limit;       ///< J* / dt: the moment over spin that stops rolling within a step [N m s]
    /// 1/2: the normal dashpot acts at the velocity in the middle of its kick, extrapolated from the step
    /// before, which needs History::normal_velocity saved; 0: at the velocity half a step before.
    Real extrapolation = Real(0.0);
  };

  template <class Real>
  struct History {
    Vec<Real, 3> spring;  ///< tangential spring force on the first body [N]
    Real sqrt_overlap;    ///< square root of the overlap at the step before [m^0.5]; 0 before the first touch
    Real normal_velocity = Real(0.0);  ///< normal velocity at the step before [m/s]
    Real rolling_power = Real(0.0);    ///< of rolling friction at the step before [W]
  };

  /// The normal damping from the coefficient of restitution with the end of contact at zero force
  /// (restitution.hpp), the same ratio along the surface. `step` [s] sets the limit of rolling friction.
  /// Throws InvalidInput for a coefficient of restitution outside (0, 1].
  static Parameters<double> parameters(const EffectiveBody& body, const ContactProperties& properties,
                                       double step);

  /// Throws as parameters().
  static ContactStiffness stiffness(const EffectiveBody& body, const ContactProperties& properties,
                                    double overlap);

  /// Force on the first body over one step `dt`; the history moves on. Velocities are those half a step
  /// before. Normal: max(0, k d^1.5 + c d^0.25 d'). Tangential: increments 8 G* sqrt(R* d) u dt of a spring
  /// that turns with the contact, less by sqrt(d / d_before) on unloading (Thornton, Cummins & Cleary, Powder
  /// Technol. 233 (2013) 30), a dashpot beside it, both together at most mu F_n. Where they slide, the spring
  /// moves on as the dashpot lets it under mu F_n: spring and dashpot stretch alike, a slider in series,
  /// which never gives energy that it was not given. A resting contact carries what Hertz's spring does,
  /// whatever the step. `rolls`: with rolling friction.
  template <bool rolls = true, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& history) {
    using std::max;
    using std::min;
    using std::sqrt;
    const Real sqrt_overlap = sqrt(pair.overlap),
               sqrt_overlap_before = max(history.sqrt_overlap, Real(1e-150));
    const Real quarter = sqrt(sqrt_overlap);
    const Real normal_velocity = dot(pair.velocity, pair.normal);
    const Real change =
        select(history.sqrt_overlap > Real(0.0), normal_velocity - history.normal_velocity, Real(0.0));
    const Real normal_force =
        max(Real(0.0), p.normal * sqrt_overlap * pair.overlap -
                           p.normal_damping * quarter * (normal_velocity + p.extrapolation * change));
    const Vec<Real, 3> slip = pair.velocity - normal_velocity * pair.normal;

    Vec<Real, 3> before = tangential(history.spring, pair.normal);
    before = before + (dt * dot(pair.mean_spin, pair.normal)) * cross(pair.normal, before);
    before = min(Real(1.0), sqrt_overlap / sqrt_overlap_before) * before;
    // the mean over the step on loading; on unloading spring / sqrt(d) grows by 8 G* sqrt(R*) u dt
    const Real stiffness =
        dt * p.tangential * (Real(0.5) * (sqrt_overlap + min(sqrt_overlap, sqrt_overlap_before)));
    const Real dashpot = p.tangential_damping * quarter;
    Vec<Real, 3> tangential_force = before + (stiffness + dashpot) * slip;
    const Real limit = p.friction * normal_force;
    const Real scale =
        min(Real(1.0), limit * inverse_sqrt(max(dot(tangential_force, tangential_force), Real(1e-290))));
    tangential_force = scale * tangential_force;
    // before + stiffness r + dashpot r = tangential_force, r the rate at which the spring is stretched: the
    // slip where it sticks
    const Real share = stiffness / max(stiffness + dashpot, Real(1e-300));
    history = {before + share * (tangential_force - before), sqrt_overlap, normal_velocity, Real(0.0)};

    const Vec<Real, 3> force = tangential_force - normal_force * pair.normal;
    if constexpr (!rolls) return {force, {Real(0.0), Real(0.0), Real(0.0)}};
    const Vec<Real, 3> rolling = tangential(pair.spin, pair.normal);
    const Real inverse_rate = inverse_sqrt(max(dot(rolling, rolling), Real(1e-290)));
    const Vec<Real, 3> moment = min(p.rolling_limit, p.rolling * normal_force * inverse_rate) * rolling;
    history.rolling_power = dot(moment, pair.spin);
    return {force, moment};
  }

  /// With the second body as the first.
  static History<double> exchanged(History<double> h) {
    h.spring = -h.spring;
    return h;
  }

  template <class Real>
  static Real overlap(const History<Real>& h) {
    return h.sqrt_overlap * h.sqrt_overlap;
  }

  /// Hertz: k d^1.5.
  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const Real& overlap) {
    using std::sqrt;
    return p.normal * overlap * sqrt(overlap);
  }

  /// T^2 / (2 k_t sqrt(d)).
  template <class Real>
  static Real spring_energy(const Parameters<Real>& p, const History<Real>& h) {
    using std::max;
    const Real stiffness = max(p.tangential * h.sqrt_overlap, Real(1e-300));
    return select(h.sqrt_overlap > Real(0.0), Real(0.5) * dot(h.spring, h.spring) / stiffness, Real(0.0));
  }

  /// 2/5 k d^2.5 and the tangential spring.
  static double stored_energy(const Parameters<double>& p, const History<double>& h) {
    double energy =
        0.4 * p.normal * h.sqrt_overlap * h.sqrt_overlap * h.sqrt_overlap * h.sqrt_overlap * h.sqrt_overlap;
    for (const double spring : h.spring.c) {
      if (p.tangential > 0) energy += 0.5 * spring * spring / (p.tangential * h.sqrt_overlap);
    }
    return energy;
  }

  /// -k d^1.5 v_n.
  static double closing_power(const Parameters<double>& p, const History<double>& h) {
    return -p.normal * h.sqrt_overlap * h.sqrt_overlap * h.sqrt_overlap * h.normal_velocity;
  }
};

}  // namespace fiberchain::dem
