#pragma once

#include "dem/contact/kernels/pairs.hpp"

namespace fiberchain::dem {

/// Spheres of a part against one wall of a shape.
template <class Law, ContactPhysics P, template <class> class Shape, class Real>
FIBERCHAIN_FLATTEN void contact_wall(const ContactView& view, const WallView& wall, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const Shape<Real> shape = broadcast<Shape, Real>(wall.shape);
  const Vec<Real, 3> wall_velocity{Real(wall.velocity[0]), Real(wall.velocity[1]), Real(wall.velocity[2])};
  using std::max;
  Real deepest(0.0);
  for (std::int32_t n = 0; n < wall.count; n += lanes) {
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = n + k;
    const Slots<Real> i = slots_of<Real>(wall.slots, entry);
    const Balls<Real> ball = balls_at<Real>(view, i.at);
    const NearestPoint<Real> seen = shape.nearest(ball.center - shape.point);
    const Real radius = ball.radius,
               edge = Law::acts_beyond_touch ? radius + contact_gap<Law, Real>(view) : radius;
    const unsigned touching = less_mask(seen.distance, edge);
    const unsigned touched = touched_mask<Real>(wall.contact + n);
    if ((touching | touched) == 0) continue;
    for (unsigned begins = touching & ~touched; begins != 0; begins &= begins - 1) {
      wall.contact[n + __builtin_ctz(begins)] = begin_contact<P>(view, task);
    }
    clear<P>(view, 0);  // of lanes that do not touch
    typename Law::template Parameters<Real> p;
    if constexpr (P.uniform) {
      p = broadcast<Law::template Parameters, Real>(wall.parameters);
    } else {
      std::int32_t kind[lanes];
      for (int k = 0; k < lanes; ++k) kind[k] = view.kind[i.at[k]];
      p = gather<Law::template Parameters, Real>(wall.parameters, kind);
    }
    const Motions<Real> motion = motions_at<Real>(view, i.at);
    const Vec<Real, 3>&v = motion.velocity, &w = motion.spin;
    TouchingPair<Real> pair;
    pair.normal = seen.direction;
    pair.overlap = select(seen.distance < edge, radius - seen.distance, Real(1e-300));
    deepest = max(deepest, pair.overlap / radius);
    pair.velocity = wall_velocity - v - cross(seen.distance * w, seen.direction);
    pair.spin = -w;
    pair.mean_spin = Real(0.5) * w;
    const Slots<Real> contacts = slots_of<Real>(wall.contact, entry);
    const RowStarts<Real> history_rows = rows_at<contact_history_size, Real>(view.histories, contacts.at);
    auto history = load_struct<contact_history_size, Law::template History, Real>(history_rows);
    [[maybe_unused]] const auto before = history;
    const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
    const Vec<Real, 3> moment = seen.distance * cross(seen.direction, action.force) + action.moment;
    store_struct<contact_history_size, Law::template History, Real>(history, history_rows);
    LoadRows<Real> loads;
    to_rows(action.force, moment, loads);
    for (int k = 0; k < lanes; ++k) {
      if ((touching >> k & 1u) == 0) continue;
      add_row<Real>(loads.at[k], i.at[k], task);
      ++task.contacts;
    }
    if constexpr (P.accounted) {
      const Real on = select(seen.distance < edge, Real(1.0), Real(0.0));
      const ContactAction<Real> counted{on * action.force, on * action.moment};
      auto was = before, is = history;
      was.spring = on * was.spring, is.spring = on * is.spring;
      const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, contacts.at);
      Real elastic_force =
          Law::elastic_force(p, pair.overlap);  // of lanes that do not touch: 0, unless the law pulls
      if constexpr (Law::acts_beyond_touch) elastic_force = on * elastic_force;
      account<Law, Real>(p, pair, was, is, counted, elastic_force, Real(view.step), lanes, work, task);
      const double power = summed<Real>(dot(counted.force, wall_velocity), lanes);
      task.wall_work += view.step * power;
      task.wall_power += power;
    }
    for (unsigned ends = touched & ~touching; ends != 0; ends &= ends - 1) {
      std::int32_t& contact = wall.contact[n + __builtin_ctz(ends)];
      contact = end_contact(contact, task);
    }
  }
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
