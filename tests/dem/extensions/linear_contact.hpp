#pragma once
#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/contact/effective_body.hpp"
#include "dem/contact/laws/contact_action.hpp"
#include "dem/math/inverse_sqrt.hpp"
#include "dem/model/contact_properties.hpp"

namespace extensions {
using namespace fiberchain::dem;

/// Springs k = E* R* and 2/7 k and a normal dashpot, with Coulomb friction (Cundall & Strack, Geotechnique 29
/// (1979) 47).
struct LinearContact {
  static constexpr std::string_view name = "linear";
  static constexpr bool acts_beyond_touch = false;
  template <class Real>
  struct Parameters {
    Real normal, tangential, damping, friction;
  };
  template <class Real>
  struct History {
    Vec<Real, 3> spring;
    Real depth, normal_velocity, rolling_power;
  };

  static double damping(const EffectiveBody& e, const ContactProperties& c) {
    const double l = std::log(c.restitution), pi = std::numbers::pi;
    return -2 * l * std::sqrt(e.mass * e.youngs_modulus * e.radius / (pi * pi + l * l));
  }
  static Parameters<double> parameters(const EffectiveBody& e, const ContactProperties& c, double) {
    const double k = e.youngs_modulus * e.radius;
    return {k, 2.0 / 7 * k, damping(e, c), c.friction};
  }
  static ContactStiffness stiffness(const EffectiveBody& e, const ContactProperties& c, double) {
    const double k = e.youngs_modulus * e.radius;
    return {k, c.friction > 0 ? 2.0 / 7 * k : 0, damping(e, c), 0};
  }
  template <bool rolls, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& h) {
    using std::max, std::min;
    const Real v = dot(pair.velocity, pair.normal), force = p.normal * pair.overlap - p.damping * v;
    const Vec<Real, 3> slip = pair.velocity - v * pair.normal,
                       trial = tangential(h.spring, pair.normal) + (dt * p.tangential) * slip;
    const Real limit = p.friction * max(force, Real(0.0)),
               size = inverse_sqrt(max(dot(trial, trial), Real(1e-290)));
    h = {min(Real(1.0), limit * size) * trial, pair.overlap, v, Real(0.0)};
    return {h.spring - force * pair.normal, {Real(0.0), Real(0.0), Real(0.0)}};
  }
  static History<double> exchanged(History<double> h) {
    h.spring = -h.spring;
    return h;
  }
  template <class Real>
  static Real overlap(const History<Real>& h) {
    return h.depth;
  }
  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const Real& overlap) {
    return p.normal * overlap;
  }
  template <class Real>
  static Real spring_energy(const Parameters<Real>& p, const History<Real>& h) {
    return Real(0.5) * dot(h.spring, h.spring) / p.tangential;
  }
  static double stored_energy(const Parameters<double>& p, const History<double>& h) {
    return 0.5 * p.normal * h.depth * h.depth + spring_energy(p, h);
  }
  static double closing_power(const Parameters<double>& p, const History<double>& h) {
    return -p.normal * h.depth * h.normal_velocity;
  }
};

}  // namespace extensions
