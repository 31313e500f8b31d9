#pragma once

#include "dem/contact/kernels/pairs.hpp"

namespace fiberchain::dem {

/// From a sphere to a wall: direction, and how far the wall is.
template <class Real>
struct WallSight {
  Vec<Real, 3> normal;
  Real distance;
};

template <class Real>
Vec<Real, 3> broadcast_vector(const double* v) {
  return {Real(v[0]), Real(v[1]), Real(v[2])};
}

template <class Real>
WallSight<Real> sight(const WallView& wall, const Vec<Real, 3>& x) {
  using std::max;
  using std::sqrt;
  const Vec<Real, 3> from = x - broadcast_vector<Real>(wall.point), direction = broadcast_vector<Real>(wall.direction);
  const Real along = dot(from, direction);
  if (!wall.cylinder) return {-direction, along};
  const Vec<Real, 3> out = from - along * direction;
  const Real radius = sqrt(max(dot(out, out), Real(1e-300)));
  return {(Real(1.0) / radius) * out, Real(wall.radius) - radius};
}

/// Spheres of a part against one wall.
template <ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN void contact_wall(const ContactView& view, const WallView& wall, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const Vec<Real, 3> wall_velocity = broadcast_vector<Real>(wall.velocity);
  for (std::int32_t n = 0; n < wall.count; n += lanes) {
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = n + k;
    const Slots<Real> i = slots_of<Real>(wall.slots, entry);
    const Balls<Real> ball = balls_at<Real>(view, i.at);
    const WallSight<Real> seen = sight(wall, ball.center);
    const Real radius = ball.radius;
    const unsigned touching = less_mask(seen.distance, radius);
    const unsigned touched = touched_mask<Real>(wall.contact + n);
    if ((touching | touched) == 0) continue;
    for (unsigned begins = touching & ~touched; begins != 0; begins &= begins - 1) {
      wall.contact[n + __builtin_ctz(begins)] = begin_contact<P>(view, task);
    }
    clear<P>(view, 0);  // of lanes that do not touch
    ContactParameters<Real> p;
    if constexpr (P.uniform) {
      p = broadcast<Real>(wall.parameters[0]);
    } else {
      std::int32_t kind[lanes];
      for (int k = 0; k < lanes; ++k) kind[k] = view.kind[i.at[k]];
      p = gather_parameters<Real>(wall.parameters, kind);
    }
    const Motions<Real> motion = motions_at<Real>(view, i.at);
    const Vec<Real, 3>&v = motion.velocity, &w = motion.spin;
    TouchingPair<Real> pair;
    pair.normal = seen.normal;
    pair.overlap = select(seen.distance < radius, radius - seen.distance, Real(1e-300));
    pair.velocity = wall_velocity - v - cross(seen.distance * w, seen.normal);
    pair.spin = -w;
    pair.mean_spin = Real(0.5) * w;
    const Slots<Real> contacts = slots_of<Real>(wall.contact, entry);
    const RowStarts<Real> history_rows = rows_at<contact_history_size, Real>(view.histories, contacts.at);
    ContactHistory<Real> history = remembered<Real>(history_rows);
    const ContactHistory<Real> before = history;
    const ContactAction<Real> action = contact_action<P.rolling>(p, pair, Real(view.step), history);
    const Vec<Real, 3> moment = seen.distance * cross(seen.normal, action.force) + action.moment;
    keep<Real>(history, history_rows);
    LoadRows<Real> loads;
    to_rows(action.force, moment, loads);
    for (int k = 0; k < lanes; ++k) {
      if ((touching >> k & 1u) == 0) continue;
      add_row<Real>(loads.at[k], i.at[k], task);
      ++task.contacts;
    }
    if constexpr (P.accounted) {
      const Real on = select(seen.distance < radius, Real(1.0), Real(0.0));
      const ContactAction<Real> counted{on * action.force, on * action.moment};
      ContactHistory<Real> was = before, is = history;
      was.spring = on * was.spring, is.spring = on * is.spring;
      const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, contacts.at);
      account(p, pair, was, is, counted, Real(view.step), lanes, work, task);
      const double power = summed<Real>(dot(counted.force, wall_velocity), lanes);
      task.wall_work += view.step * power;
      task.wall_power += power;
    }
    for (unsigned ends = touched & ~touching; ends != 0; ends &= ends - 1) {
      std::int32_t& contact = wall.contact[n + __builtin_ctz(ends)];
      contact = end_contact(contact, task);
    }
  }
}

}  // namespace fiberchain::dem
