#pragma once

#include <cmath>

#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/kernels/pack_numbers.hpp"
#include "dem/math/near_one.hpp"
#include "dem/simd/gather.hpp"
#include "dem/simd/transpose.hpp"

namespace fiberchain::dem {

/// Sum of the first `count` lanes.
template <class Real>
double summed(const Real& value, int count) {
  double numbers[lane_count<Real>], sum = 0;
  store_lanes(value, numbers);
  for (int k = 0; k < count; ++k) sum += numbers[k];
  return sum;
}

/// The normal spring's force after act().
template <class Law, class Real>
Real elastic_force_of(const typename Law::template Parameters<Real>& p, const Real& overlap,
                      [[maybe_unused]] const typename Law::template History<Real>& after) {
  if constexpr (Law::acts_beyond_touch) {
    return Law::elastic_force(p, after);
  } else {
    return Law::elastic_force(p, overlap);
  }
}

/// What the normal spring of a contact has lost that ends before the next act() [J].
template <class Law>
double lost_at_end(const ContactView& view, const double* parameters, std::int32_t contact) {
  typename Law::template History<double> history;
  double* numbers = pack_numbers<double, Law::template History>(history);
  const double* row = view.histories + static_cast<std::ptrdiff_t>(contact) * contact_history_size;
  for (int n = 0; n < numbers_in<Law::template History>; ++n) numbers[n] = row[n];
  return Law::lost_at_end(broadcast<Law::template Parameters, double>(parameters), history);
}

/// Energies of the step. A kick with a force takes force times the mean of the velocities before and after
/// it: the one before is at hand, the one after comes with the next step, which corrects this one by what its
/// row keeps: dashpot force, tangential force, rolling moment, power of the tangential force. `elastic_force`
/// is the law's in each lane that touches.
template <class Law, class Real>
void account(const typename Law::template Parameters<Real>& p, const TouchingPair<Real>& pair,
             const typename Law::template History<Real>& before,
             const typename Law::template History<Real>& after, const ContactAction<Real>& action,
             const Real& elastic_force, const Real& dt, int count, const RowStarts<Real>& work,
             ContactTask& task) {
  const Real normal_velocity = dot(pair.velocity, pair.normal);
  const Real normal_force = Real(0.0) - dot(action.force, pair.normal);
  const Real dashpot = elastic_force - normal_force;
  const Vec<Real, 3> slip = pair.velocity - normal_velocity * pair.normal,
                     tangential_force = action.force + normal_force * pair.normal;
  Real saved[contact_account_size];
  load_rows<contact_account_size>(work, 0, saved);
  const auto held = Law::overlap(before) != Real(0.0);
  const auto of_step_before = [&](const Real& power_now) {
    return select(held, Real(0.5) * dt * power_now, Real(0.0));
  };
  const Vec<Real, 3> last_tangential_force{saved[1], saved[2], saved[3]},
      last_moment{saved[4], saved[5], saved[6]};
  const Real normal = dashpot * normal_velocity, sliding = dot(tangential_force, slip),
             rolling = dot(action.moment, pair.spin);
  task.account.normal_dashpot += summed<Real>(
      dt * normal + of_step_before(saved[0] * (normal_velocity - before.normal_velocity)), count);
  task.account.sliding +=
      summed<Real>(dt * sliding + of_step_before(dot(last_tangential_force, slip) - saved[7]) -
                       (Law::spring_energy(p, after) - Law::spring_energy(p, before)),
                   count);
  task.account.rolling +=
      summed<Real>(dt * rolling + of_step_before(dot(last_moment, pair.spin) - before.rolling_power), count);
  task.power.normal_dashpot += summed<Real>(normal, count);
  task.power.sliding += summed<Real>(sliding, count);
  task.power.rolling += summed<Real>(rolling, count);
  if constexpr (Law::acts_beyond_touch) {
    const Real lost = select(held, Law::lost_at_end(p, before), Real(0.0));
    task.account.normal_dashpot +=
        summed<Real>(select(Law::overlap(after) != Real(0.0), Real(0.0), lost), count);
  }
  const Real keep[contact_account_size] = {
      dashpot,          tangential_force[0], tangential_force[1], tangential_force[2],
      action.moment[0], action.moment[1],    action.moment[2],    sliding};
  store_rows<contact_account_size>(keep, work, 0);
}

}  // namespace fiberchain::dem
