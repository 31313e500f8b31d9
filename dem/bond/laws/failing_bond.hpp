#pragma once

#include <type_traits>

#include "dem/bond/laws/incremental_bond.hpp"
#include "dem/bond/laws/total_bond.hpp"

// Bonds that break for good beyond a strength, and bend plastically beyond a moment: around a bond law of the
// library, in space.
namespace fiberchain::dem {

/// What a bond has for it; the last numbers of its history.
template <class Real>
struct BondFailure {
  Real limit[4];    ///< strengths times A, in the order of BreakCause from tension on; huge where none [N]
  Real yield;       ///< moment at which it yields now; huge where it does not [N m]
  Real plastic[2];  ///< bend that stays, in the mid-frame (form total; the incremental strain is elastic)
                    ///< [rad]
  Real work;        ///< plastic, so far [J]
  Real stress;      ///< that it broke at, times A [N]
  Real cause;       ///< BreakCause; of one that is to break in the next step by hand already
  Real energy;      ///< that it stored as it broke [J]
  Real intact;      ///< 1; 1/2 in the step it breaks in; 0 from then on
};

/// Where nothing is borne by a limit: its square is infinite, and nothing exceeds that.
inline constexpr double no_limit = 1e300;

// Of BondParameters::own.
inline constexpr int inverse_radius_place = 0;  ///< 2/R, A R/(2 I) [1/m]
inline constexpr int may_break_place = 1;       ///< 1 in a step; 0 where the bond is only looked at
inline constexpr int hardening_place = 2;       ///< of the yield moment by the plastic angle [N m]

/// Whether a mask holds in any lane.
template <class Mask>
bool any_lane(const Mask& mask) {
  if constexpr (std::is_arithmetic_v<Mask>) {
    return mask;
  } else {
    return any(mask);
  }
}

template <class Real>
void scale(BondLoads<Real, 3>& loads, const Real& factor) {
  loads.force_on_first = factor * loads.force_on_first;
  loads.moment_on_first = factor * loads.moment_on_first;
  loads.moment_on_second = factor * loads.moment_on_second;
}

/// Forces on the bond's section.
template <class Real>
struct SectionForces {
  Real N, shear_squared;      ///< N, Q^2
  Real torque, bend_squared;  ///< T, M^2
};

template <class Real>
SectionForces<Real> section_forces(const Vec<Real, 3>& force, const Vec<Real, 3>& along, const Real& torque,
                                   const Real& bend_squared) {
  const Real N = dot(force, along);
  return {N, dot(force, force) - N * N, torque, bend_squared};
}

/// Plastic part of an elastic bend theta that goes beyond the yield moment, over |theta|: with the moment
/// m = K |theta| the plastic angle is (m - yield) / (K + H), from where yield + H angle is what the bond
/// bears. Its work is that of the mean of both, exact as bending goes on; kicks take the moment at their
/// middle (README.md).
template <class Real>
Real yielded_share(const BondParameters<Real>& bond, const Real& bend_squared, BondFailure<Real>& failure) {
  using std::sqrt;
  const Real& hardening = bond.own[hardening_place];
  const auto over = bond.bend * bond.bend * bend_squared > failure.yield * failure.yield;
  if (!any_lane(over)) return Real(0.0);
  const Real size = sqrt(bend_squared);
  const Real angle = select(over, (bond.bend * size - failure.yield) / (bond.bend + hardening), Real(0.0));
  const Real more = hardening * angle;
  failure.work = failure.work + (failure.yield + Real(0.5) * more) * angle;
  failure.yield = failure.yield + more;
  return select(over, angle / size, Real(0.0));
}

/// The cause whose stress is the largest part of its strength, and that stress.
template <class Real>
void find_cause(const BondParameters<Real>& bond, const SectionForces<Real>& s, BondFailure<Real>& failure,
                const Real& energy) {
  using std::abs;
  using std::sqrt;
  const Real edge = Real(2.0) * bond.own[inverse_radius_place] * sqrt(s.bend_squared);
  const Real stress[4] = {s.N + edge, edge - s.N, sqrt(s.shear_squared),
                          bond.own[inverse_radius_place] * abs(s.torque)};
  const auto& limit = failure.limit;
  const auto torn = (stress[0] > limit[0]) | (stress[1] > limit[1]) | (stress[2] > limit[2]) |
                    (stress[3] > limit[3]) | (failure.cause > Real(0.0));
  const auto breaks = (failure.intact == Real(1.0)) & (bond.own[may_break_place] > Real(0.0)) & torn;
  Real ratio = stress[0] / limit[0], largest = stress[0], cause(1.0);
  for (int n = 1; n < 4; ++n) {
    const Real own = stress[n] / limit[n];
    const auto larger = own > ratio;
    ratio = select(larger, own, ratio);
    largest = select(larger, stress[n], largest);
    cause = select(larger, Real(1.0 + n), cause);
  }
  cause = select(failure.cause > Real(0.0), failure.cause, cause);
  failure.stress = select(breaks, largest, failure.stress);
  failure.cause = select(breaks, cause, failure.cause);
  failure.energy = select(breaks, energy, failure.energy);
  failure.intact = select(breaks, Real(0.5), failure.intact);
}

/// Whether in any lane a bond may be beyond its strength: without roots.
template <class Real>
bool may_be_beyond(const BondParameters<Real>& bond, const SectionForces<Real>& s,
                   const BondFailure<Real>& failure) {
  const Real& arm = bond.own[inverse_radius_place];
  const Real edge = Real(4.0) * (arm * arm) * s.bend_squared;  // (|M| A R/I)^2
  const Real left = failure.limit[0] - s.N, right = failure.limit[1] + s.N;
  const auto beyond = (left < Real(0.0)) | (edge > left * left) | (right < Real(0.0)) |
                      (edge > right * right) | (s.shear_squared > failure.limit[2] * failure.limit[2]) |
                      ((arm * arm) * (s.torque * s.torque) > failure.limit[3] * failure.limit[3]) |
                      (failure.cause > Real(0.0));
  return any_lane((failure.intact == Real(1.0)) & beyond);
}

/// In the step that breaks it a bond has half of its force: the kick goes from half a step before to half a
/// step after the moment it breaks at, so that it is whole up to there and gone from there on, exactly.
template <class Base>
struct FailingBond : Base {
  static constexpr bool rolls = false, dissipates = false;

  template <class Real, int Dim>
  struct History {
    [[no_unique_address]] typename Base::template History<Real, Dim> base;
    BondFailure<Real> failure;
  };

  /// A whole bond that bears everything; limits are the fiber's.
  template <int Dim>
  static History<double, Dim> start(const BondParameters<double>& bond,
                                    const BondConfiguration<double, Dim>& now) {
    History<double, Dim> history{};
    if constexpr (!Base::from_poses) history.base = Base::start(bond, now);
    BondFailure<double>& failure = history.failure;
    for (double& limit : failure.limit) limit = no_limit;
    failure.yield = no_limit;
    failure.intact = 1;
    return history;
  }

  /// Springs and dashpots after a step of `dt` that led here; it yields and breaks.
  template <class Real>
  static BondLoads<Real, 3> loads(const BondParameters<Real>& bond, History<Real, 3>& history,
                                  const BondConfiguration<Real, 3>& now, const Real& dt) {
    BondLoads<Real, 3> all = springs(bond, history, now, dt) + dashpot_loads(bond, now);
    const Real& intact = history.failure.intact;
    const auto acts = intact > Real(0.0);
    for (Vec<Real, 3>* part : {&all.force_on_first, &all.moment_on_first, &all.moment_on_second}) {
      for (Real& c : part->c) c = select(acts, intact * c, Real(0.0));  // not 0 c: c may be no number
    }
    return all;
  }

  /// [J]
  template <class Real, int Dim>
  static Real stored_energy(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                            const BondConfiguration<Real, Dim>& now) {
    if constexpr (Base::from_poses) {
      const BondKinematics<Real, 3> k = bond_kinematics(now.first, now.second);
      return energy_from_poses(bond, k, history.failure);
    } else {
      return Base::stored_energy(bond, history.base, now);
    }
  }

  template <class History>
  static double bending_angle(const History& history,
                              const BondConfiguration<double, 3>& now) requires(!Base::from_poses) {
    return Base::bending_angle(history.base, now);
  }

 private:
  /// Bend in the mid-frame that the springs feel, the plastic part taken off.
  template <class Real>
  static Vec<Real, 2> elastic_bend(const BondParameters<Real>& bond, const BondKinematics<Real, 3>& k,
                                   const BondFailure<Real>& failure) {
    return {k.rotation[1] - failure.plastic[0],
            k.rotation[2] - bond.rest_moment / bond.bend - failure.plastic[1]};
  }

  template <class Real>
  static Real energy_from_poses(const BondParameters<Real>& bond, const BondKinematics<Real, 3>& k,
                                const BondFailure<Real>& failure) {
    const Vec<Real, 2> elastic = elastic_bend(bond, k, failure);
    const Vec<Real, 2> whole{elastic[0] + failure.plastic[0], elastic[1] + failure.plastic[1]};
    return bond_energy(bond, k.separation, k.rotation) +
           Real(0.5) * bond.bend * (dot(elastic, elastic) - dot(whole, whole));
  }

  template <class Real>
  static BondLoads<Real, 3> springs(const BondParameters<Real>& bond, History<Real, 3>& history,
                                    const BondConfiguration<Real, 3>& now, const Real& dt) {
    if constexpr (Base::from_poses) {
      return springs_from_poses(bond, history.failure, now);
    } else {
      return summed_springs(bond, history, now, dt);
    }
  }

  template <class Real>
  static BondLoads<Real, 3> springs_from_poses(const BondParameters<Real>& bond, BondFailure<Real>& failure,
                                               const BondConfiguration<Real, 3>& now) {
    const BondKinematics<Real, 3> k = bond_kinematics(now.first, now.second);
    const Vec<Real, 2> trial = elastic_bend(bond, k, failure);
    const Real share = yielded_share(bond, dot(trial, trial), failure);
    BondStress<Real, 3> stress = bond_stress<Real, 3>(bond, k.separation, k.rotation);
    for (int c = 0; c < 2; ++c) {
      failure.plastic[c] = failure.plastic[c] + share * trial[c];
      stress.moment[1 + c] = stress.moment[1 + c] - bond.bend * failure.plastic[c];
    }
    const Vec<Real, 3>& m = stress.moment;
    const Vec<Real, 3> along = (Real(1.0) / norm(k.separation)) * k.separation;
    const auto s = section_forces(stress.force, along, m[0], m[1] * m[1] + m[2] * m[2]);
    if (may_be_beyond(bond, s, failure)) find_cause(bond, s, failure, energy_from_poses(bond, k, failure));
    return bond_loads(k, stress);
  }

  /// The strain of a broken bond stays 0.
  template <class Real>
  static BondLoads<Real, 3> summed_springs(const BondParameters<Real>& bond, History<Real, 3>& history,
                                           const BondConfiguration<Real, 3>& now, const Real& dt) {
    BondHistory<Real, 3>& strain = history.base;
    Base::advance(bond, strain, now, dt);
    const auto whole = history.failure.intact == Real(1.0);
    for (int c = 0; c < 3; ++c) {
      strain.displacement[c] = select(whole, strain.displacement[c], Real(0.0));
      strain.rotation[c] = select(whole, strain.rotation[c], Real(0.0));
    }
    const Vec<Real, 3> e = now.line.inverse_length * now.line.vector;
    const Vec<Real, 3> bend = strain.rotation - dot(strain.rotation, e) * e;
    const Real share = yielded_share(bond, dot(bend, bend), history.failure);
    strain.rotation = strain.rotation - share * bend;
    const BondAction<Real, 3> action = Base::template action<false>(bond, strain, now);
    const Real torque = dot(action.moment, e);
    const auto s =
        section_forces(action.force, e, torque, dot(action.moment, action.moment) - torque * torque);
    if (may_be_beyond(bond, s, history.failure))
      find_cause(bond, s, history.failure, Base::stored_energy(bond, strain, now));
    return act_at_middle(now.line.vector, action);
  }
};

}  // namespace fiberchain::dem
