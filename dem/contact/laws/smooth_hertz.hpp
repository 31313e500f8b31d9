#pragma once

#include <cstddef>
#include <string_view>

#include "dem/contact/laws/hertz_mindlin.hpp"

namespace fiberchain::dem {

/// Hertz-Mindlin contact of two segments of smooth fibers: the law of two spheres with their radii, k and 8
/// G* sqrt(R*) times `stiffness`, the dashpots' coefficients times its root; the pair of segments has the
/// share of it that segment_contact() gives. History zero in both is a sphere's contact.
struct SmoothHertz {
  static constexpr std::string_view name = HertzMindlin::name;
  static constexpr bool acts_beyond_touch = false;

  template <class Real>
  using Parameters = HertzMindlin::Parameters<Real>;

  template <class Real>
  struct History {
    Vec<Real, 3> spring;  ///< of the whole contact, as HertzMindlin's
    Real sqrt_overlap, normal_velocity;
    Real rolling_power;   ///< of the share
    Real share_less_one;  ///< share - 1
    Real stiffer;         ///< stiffness - 1
  };
  /// Places among the numbers of a history.
  static constexpr int sqrt_overlap_at = 3, rolling_power_at = 5, share_less_one_at = 6;

  template <class Real>
  static Real share_of(const History<Real>& h) {
    return Real(1.0) + h.share_less_one;
  }

  /// Of the contact at its angle.
  template <class Real>
  static Parameters<Real> scaled(Parameters<Real> p, const Real& stiffness) {
    using std::sqrt;
    const Real root = sqrt(stiffness);
    p.normal = stiffness * p.normal;
    p.tangential = stiffness * p.tangential;
    p.normal_damping = root * p.normal_damping;
    p.tangential_damping = root * p.tangential_damping;
    return p;
  }

  /// The share of the action; the history has share and stiffness of the moment already.
  template <bool rolls = true, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& history) {
    const Real share = share_of(history);
    HertzMindlin::History<Real> whole{history.spring, history.sqrt_overlap, history.normal_velocity,
                                      history.rolling_power};
    const ContactAction<Real> action =
        HertzMindlin::act<rolls>(scaled(p, Real(1.0) + history.stiffer), pair, dt, whole);
    history.spring = whole.spring;
    history.sqrt_overlap = whole.sqrt_overlap;
    history.normal_velocity = whole.normal_velocity;
    history.rolling_power = share * whole.rolling_power;
    return {share * action.force, share * action.moment};
  }

  template <class Contact>
  static Contact exchanged(Contact h) {
    return HertzMindlin::exchanged(h);
  }

  template <class Real>
  static Real overlap(const History<Real>& h) {
    return h.sqrt_overlap * h.sqrt_overlap;
  }

  /// The share of Hertz's force.
  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const History<Real>& h) {
    return share_of(h) * (Real(1.0) + h.stiffer) * p.normal * h.sqrt_overlap * h.sqrt_overlap *
           h.sqrt_overlap;
  }

  template <class Real>
  static Real spring_energy(const Parameters<Real>& p, const History<Real>& h) {
    return share_of(h) * HertzMindlin::spring_energy(scaled(p, Real(1.0) + h.stiffer), h);
  }

  static double stored_energy(const Parameters<double>& p, const History<double>& h) {
    return share_of(h) * HertzMindlin::stored_energy(scaled(p, 1 + h.stiffer),
                                                     {h.spring, h.sqrt_overlap, h.normal_velocity, 0});
  }

  static double closing_power(const Parameters<double>& p, const History<double>& h) {
    return -elastic_force(p, h) * h.normal_velocity;
  }
};

using SmoothHertzHistory = SmoothHertz::History<double>;
static_assert(offsetof(SmoothHertzHistory, sqrt_overlap) == SmoothHertz::sqrt_overlap_at * sizeof(double));
static_assert(offsetof(SmoothHertzHistory, rolling_power) == SmoothHertz::rolling_power_at * sizeof(double));
static_assert(offsetof(SmoothHertzHistory, share_less_one) ==
              SmoothHertz::share_less_one_at * sizeof(double));

}  // namespace fiberchain::dem
