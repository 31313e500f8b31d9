#pragma once

#include <string_view>

#include "dem/contact/laws/hertz_mindlin.hpp"
#include "dem/contact/laws/share_of_kick.hpp"

namespace fiberchain::dem {

/// Adhesive contact of soft bodies by Johnson, Kendall & Roberts (Proc. R. Soc. A 324 (1971) 301): a contact
/// of radius a has, with the work of adhesion w,
///   d = a^2/R* - sqrt(2 pi w a / E*),   F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3).
/// With a_0^3 = pi w R*^2 / (8 E*) and u^2 = a / a_0: d = (u^4 - 4 u) a_0^2/R*, F = (4/3 u^6 - 8 u^3) f, f =
/// pi w R*/8. Bodies that come near touch at d = 0 and are at once on the stable branch u >= 1; they hold on
/// to its end, u = 1 at d = -3 a_0^2/R*, beyond the largest pull 3/2 pi w R* (u^3 = 3). Dashpots and friction
/// are those of Hertz-Mindlin for the contact radius, and pull no more than adhesion does; Coulomb's limit is
/// mu (F_n + 3 pi w R*) (Thornton & Yin, Powder Technol. 65 (1991) 153).
struct Jkr {
  static constexpr std::string_view name = "jkr";
  static constexpr bool acts_beyond_touch = true, adheres = true;

  template <class Real>
  struct Parameters {
    HertzMindlin::Parameters<Real> hertz;
    Real depth;  ///< a_0^2/R* [m]
    Real force;  ///< f = pi w R*/8 [N]
  };

  template <class Real>
  struct History {
    Vec<Real, 3> spring;
    Real sqrt_overlap;     ///< a/sqrt(R*) [m^0.5]; 0: the bodies do not hold each other
    Real normal_velocity;  ///< [m/s]
    Real rolling_power;    ///< [W]
    Real overlap;          ///< d while they do, else 0 [m]
    Real share;            ///< of the step before for which the elastic force was there (share_of_kick())
  };

  static Parameters<double> parameters(const EffectiveBody& body, const ContactProperties& properties,
                                       double step);
  static ContactStiffness stiffness(const EffectiveBody& body, const ContactProperties& properties,
                                    double overlap);
  static double pull_off(const EffectiveBody& body,
                         const ContactProperties& properties);  ///< 3/2 pi w R* [N]
  static double reach(const EffectiveBody& body, const ContactProperties& properties);

  /// u >= 1 of d R*/a_0^2 = u^4 - 4 u, at least -3: with m > 0 of m^3 + d m - 2 = 0, which Newton finds in
  /// five iterations from above, (u^2 + m)^2 is a square on both sides.
  template <class Real>
  static Real root_of_radius(const Real& d) {
    using std::max;
    using std::sqrt;
    Real m = select(d < Real(0.0), Real(1.26) - Real(0.2467) * d, Real(1.26) / (Real(1.0) + Real(0.21) * d));
    for (int n = 0; n < 6; ++n) m = Real(2.0) * (m * m * m + Real(1.0)) / (Real(3.0) * m * m + d);
    return sqrt(Real(0.5) * m) + sqrt(max(Real(0.0), sqrt(Real(2.0) / m) - Real(0.5) * m));
  }

  template <class Real>
  static Real force_at(const Parameters<Real>& p, const Real& u) {
    const Real cube = u * u * u;
    return p.force * cube * (Real(4.0 / 3) * cube - Real(8.0));
  }

  template <bool rolls = true, class Real>
  static ContactAction<Real> act(const Parameters<Real>& p, const TouchingPair<Real>& pair, const Real& dt,
                                 History<Real>& history) {
    using std::max;
    using std::sqrt;
    const Real zero(0.0), end = Real(-3.0) * p.depth;
    const auto held = history.sqrt_overlap > zero;
    const Real on = select(pair.overlap > select(held, end, zero), Real(1.0), zero);
    const Real u = root_of_radius(max(Real(-3.0), pair.overlap / p.depth));
    const Real sqrt_depth = sqrt(p.depth) * u * u, quarter = sqrt(sqrt_depth);
    const Real velocity = dot(pair.velocity, pair.normal);
    const Real change = select(held, velocity - history.normal_velocity, zero);
    const Real pull = Real(12.0) * p.force, elastic = force_at(p, u);
    const Real force = max(zero - pull, elastic - p.hertz.normal_damping * quarter *
                                                      (velocity + p.hertz.extrapolation * change));
    const Real share = share_of_kick<Real>(
        {select(held, Real(1.0), zero), history.share, pair.overlap, pair.overlap - end, velocity * dt});
    const ContactAction<Real> action = HertzMindlin::along_surface<rolls>(
        p.hertz, pair,
        {velocity, on * (force + (size_of_share(share) - Real(1.0)) * elastic),
         on * (force + Real(2.0) * pull)},
        on * sqrt_depth, on * quarter, dt, history);
    history.share = share;
    history.spring = on * history.spring;
    history.overlap = on * pair.overlap;
    return action;
  }

  static History<double> exchanged(const History<double>& h) { return HertzMindlin::exchanged(h); }

  template <class Real>
  static Real overlap(const History<Real>& h) {
    return h.overlap;
  }

  /// u of the contact as it is.
  template <class Real>
  static Real root_of(const Parameters<Real>& p, const History<Real>& h) {
    using std::sqrt;
    return sqrt(h.sqrt_overlap / sqrt(p.depth));
  }

  template <class Real>
  static Real elastic_force(const Parameters<Real>& p, const History<Real>& h) {
    return size_of_share(h.share) * force_at(p, root_of(p, h));
  }

  template <class Real>
  static Real spring_energy(const Parameters<Real>& p, const History<Real>& h) {
    return HertzMindlin::spring_energy(p.hertz, h);
  }

  /// The work from the touch on, 0 there: f a_0^2/R* (8/15 u^10 - 16/3 u^7 + 8 u^4 + 96/5 4^(1/3)), and the
  /// tangential spring.
  template <class Real>
  static Real stored_energy(const Parameters<Real>& p, const History<Real>& h) {
    const Real u = root_of(p, h), u3 = u * u * u, u4 = u3 * u;
    const Real work =
        u4 * ((Real(8.0 / 15) * u3 - Real(16.0 / 3)) * u3 + Real(8.0)) + Real(19.2 * 1.5874010519681994);
    return select(h.sqrt_overlap > Real(0.0), p.force * p.depth * work + spring_energy(p, h), Real(0.0));
  }

  /// What making and breaking a contact loses, the same at u = 1: 33.68 f a_0^2/R* = 7.09 (w^5 R*^4 /
  /// E*^2)^(1/3).
  template <class Real>
  static Real lost_at_end(const Parameters<Real>& p, const History<Real>& h) {
    const Real loss = p.force * p.depth * Real(3.2 + 19.2 * 1.5874010519681994);
    return select(h.sqrt_overlap > Real(0.0), loss, Real(0.0));
  }

  static double closing_power(const Parameters<double>& p, const History<double>& h) {
    return -elastic_force(p, h) * h.normal_velocity;
  }
};

}  // namespace fiberchain::dem
