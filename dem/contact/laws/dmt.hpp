#pragma once

#include <string_view>

#include "dem/contact/laws/hertz_mindlin.hpp"
#include "dem/contact/laws/share_of_kick.hpp"

namespace fiberchain::dem {

/// Adhesive contact of stiff bodies by Derjaguin, Muller & Toporov (J. Colloid Interface Sci. 53 (1975) 314):
/// Hertz's contact and a constant pull 2 pi w R* while the bodies touch, by forces that reach so little
/// beyond that their reach is left out. Nothing is lost by making and breaking. Coulomb's limit is mu times
/// Hertz's force.
struct Dmt {
  static constexpr std::string_view name = "dmt";
  static constexpr bool acts_beyond_touch = true, adheres = true;  ///< by 0 [m]: its end is booked

  template <class Real>
  struct Parameters {
    HertzMindlin::Parameters<Real> hertz;
    Real pull;  ///< 2 pi w R* [N]
  };

  template <class Real>
  struct History {
    Vec<Real, 3> spring;
    Real sqrt_overlap, normal_velocity, rolling_power;  ///< as HertzMindlin's
    Real share;  ///< of the step before for which the pull was there (share_of_kick())
  };

  static Parameters<double> parameters(const EffectiveBody& body, const ContactProperties& properties,
                                       double step);
  static ContactStiffness stiffness(const EffectiveBody& body, const ContactProperties& properties,
                                    double overlap);
  static double pull_off(const EffectiveBody& body, const ContactProperties& properties);  ///< 2 pi w R* [N]
  static double reach(const EffectiveBody&, const ContactProperties&) { return 0; }

  template <bool rolls = true, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& history) {
    using std::max;
    using std::sqrt;
    const Real overlap = max(pair.overlap, Real(1e-300));  // squares that differ may have one root
    const Real sqrt_overlap = sqrt(overlap), quarter = sqrt(sqrt_overlap);
    const Real velocity = dot(pair.velocity, pair.normal);
    const auto touched = history.sqrt_overlap > Real(0.0);
    const Real change = select(touched, velocity - history.normal_velocity, Real(0.0));
    const Real load =
        max(Real(0.0), p.hertz.normal * sqrt_overlap * overlap -
                           p.hertz.normal_damping * quarter * (velocity + p.hertz.extrapolation * change));
    const Real share = share_of_kick<Real>(
        {select(touched, Real(1.0), Real(0.0)), history.share, overlap, overlap, velocity * dt});
    history.share = share;
    return HertzMindlin::along_surface<rolls>(p.hertz, pair,
                                              {velocity, load - size_of_share(share) * p.pull, load},
                                              sqrt_overlap, quarter, dt, history);
  }

  static History<double> exchanged(const History<double>& h) { return HertzMindlin::exchanged(h); }

  template <class Real>
  static Real overlap(const History<Real>& h) {
    return HertzMindlin::overlap(h);
  }

  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const History<Real>& h) {
    const Real cube = h.sqrt_overlap * h.sqrt_overlap * h.sqrt_overlap;
    return select(h.sqrt_overlap > Real(0.0), p.hertz.normal * cube - size_of_share(h.share) * p.pull,
                  Real(0.0));
  }

  template <class Real>
  static Real spring_energy(const Parameters<Real>& p, const History<Real>& h) {
    return HertzMindlin::spring_energy(p.hertz, h);
  }

  /// The work from the touch on, and the tangential spring.
  template <class Real>
  static Real stored_energy(const Parameters<Real>& p, const History<Real>& h) {
    const Real overlap = h.sqrt_overlap * h.sqrt_overlap;
    return overlap * (Real(0.4) * p.hertz.normal * overlap * h.sqrt_overlap - p.pull) + spring_energy(p, h);
  }

  template <class Real>
  static Real lost_at_end(const Parameters<Real>&, const History<Real>&) {
    return Real(0.0);
  }

  static double closing_power(const Parameters<double>& p, const History<double>& h) {
    return -elastic_force(p, h) * h.normal_velocity;
  }
};

}  // namespace fiberchain::dem
