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
  /// before. Normal: max(0, k d^1.5 + c d^0.25 d'). Tangential: along_surface(), both forces together at most
  /// mu F_n. A resting contact carries what Hertz's spring does, whatever the step. `rolls`: with rolling
  /// friction.
  template <bool rolls = true, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& history) {
    using std::max;
    using std::sqrt;
    const Real sqrt_overlap = sqrt(pair.overlap), quarter = sqrt(sqrt_overlap);
    const Real normal_velocity = dot(pair.velocity, pair.normal);
    const auto touched = history.sqrt_overlap > Real(0.0);
    const Real change = select(touched, normal_velocity - history.normal_velocity, Real(0.0));
    Real root = quarter;
    if (!all(touched))
      root = select(touched, quarter,
                    first_root(pair.overlap, max(Real(0.0), Real(0.0) - normal_velocity) * dt));
    const Real normal_force =
        max(Real(0.0), p.normal * sqrt_overlap * pair.overlap -
                           p.normal_damping * root * (normal_velocity + p.extrapolation * change));
    return along_surface<rolls>(p, pair, {normal_velocity, normal_force, normal_force}, sqrt_overlap, quarter,
                                dt, history);
  }

  /// What acts along the normal, for along_surface().
  template <class Real>
  struct Normal {
    Real velocity, force;  ///< of the second body; on the first one against the normal
    Real load;             ///< which Coulomb's limit is a multiple of
  };

  /// The normal force and what acts along the surfaces: increments 8 G* sqrt(R* d) u dt of a spring that
  /// turns with the contact, less by sqrt(d / d_before) on unloading (Thornton, Cummins & Cleary, Powder
  /// Technol. 233 (2013) 30), a dashpot beside it, at the velocity half a step before, both together at most
  /// mu times the load. Where they slide, the spring moves on as the dashpot lets it under that limit:
  /// spring and dashpot stretch alike, a slider in series, which never gives energy that it was not given.
  /// `sqrt_depth` is the radius of the contact over sqrt(R*), `quarter` its root.
  template <bool rolls, class Real, class Parameters, class History>
  static ContactAction<Real> along_surface(const Parameters& p, const TouchingPair<Real>& pair,
                                           const Normal<Real>& normal, const Real& sqrt_depth,
                                           const Real& quarter, const Real& dt, History& history) {
    using std::max;
    using std::min;
    const Real sqrt_depth_before = max(history.sqrt_overlap, Real(1e-150));
    const Vec<Real, 3> slip = pair.velocity - normal.velocity * pair.normal;
    Vec<Real, 3> before = tangential(history.spring, pair.normal);
    before = before + (dt * dot(pair.mean_spin, pair.normal)) * cross(pair.normal, before);
    before = min(Real(1.0), sqrt_depth / sqrt_depth_before) * before;
    // the mean over the step on loading; on unloading spring / sqrt(d) grows by 8 G* sqrt(R*) u dt
    const Real stiffness =
        dt * p.tangential * (Real(0.5) * (sqrt_depth + min(sqrt_depth, sqrt_depth_before)));
    const Real dashpot = p.tangential_damping * quarter;
    const Vec<Real, 3> trial = before + (stiffness + dashpot) * slip;
    const Real limit = p.friction * normal.load;
    const Vec<Real, 3> held =
        min(Real(1.0), limit * inverse_sqrt(max(dot(trial, trial), Real(1e-290)))) * trial;
    // before + stiffness r + dashpot r = held, r the rate at which the spring is stretched: the slip where it
    // sticks
    const Real share = stiffness / max(stiffness + dashpot, Real(1e-300));
    history.spring = before + share * (held - before);
    history.sqrt_overlap = sqrt_depth;
    history.normal_velocity = normal.velocity;
    history.rolling_power = Real(0.0);

    const Vec<Real, 3> force = held - normal.force * pair.normal;
    if constexpr (!rolls) return {force, {Real(0.0), Real(0.0), Real(0.0)}};
    const Vec<Real, 3> rolling = tangential(pair.spin, pair.normal);
    const Real inverse_rate = inverse_sqrt(max(dot(rolling, rolling), Real(1e-290)));
    const Vec<Real, 3> moment = min(p.rolling_limit, p.rolling * normal.load * inverse_rate) * rolling;
    history.rolling_power = dot(moment, pair.spin);
    return {force, moment};
  }

  /// The fourth root of the overlap for the first kick of a contact that has closed by `path` in the step:
  /// kicks at x, x + 1 ... steps after the touch take the sum of (x + k)^(1/4) for the integral of the root,
  /// which is off by the Hurwitz zeta function, zeta(-1/4, x), a part of the step to the power 5/4. With
  /// -zeta(-1/4, 1 + x) in place of x^(1/4) it is right: (1 + x)^(1/4) times a polynomial of 1 + x, to 3e-4.
  template <class Real>
  static Real first_root(const Real& overlap, const Real& path) {
    using std::max;
    using std::sqrt;
    const Real a = (overlap + path) / max(path, Real(1e-300));
    const Real corrected = sqrt(sqrt(overlap + path)) * polynomial(a, -0.456672, 0.770588, 0.006464);
    // bodies that begin overlapped have not closed by their overlap
    return select(a < Real(2.000001), corrected, sqrt(sqrt(overlap)));
  }

  /// With the second body as the first.
  template <class Contact>
  static Contact exchanged(Contact h) {
    h.spring = -h.spring;
    return h;
  }

  template <class Contact>
  static auto overlap(const Contact& h) {
    return h.sqrt_overlap * h.sqrt_overlap;
  }

  /// Hertz: k d^1.5.
  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const Real& overlap) {
    using std::sqrt;
    return p.normal * overlap * sqrt(overlap);
  }

  /// T^2 / (2 k_t sqrt(d)).
  template <class Real, class Contact>
  static Real spring_energy(const Parameters<Real>& p, const Contact& h) {
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
