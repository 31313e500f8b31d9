#pragma once

#include "dem/contact/kernels/pairs.hpp"

namespace fiberchain::dem {

/// As many spheres as there are lanes, at a wall.
template <class Real>
struct WallLanes {
  Slots<Real> sphere, contact;
  NearestPoint<Real> nearest;  ///< of the wall
  Real radius;
  Real reach;  ///< distance of the center below which the law acts
};

template <class Law, ContactPhysics P, class Real>
typename Law::template Parameters<Real> wall_parameters(const ContactView& view, const WallView& wall,
                                                        const Slots<Real>& sphere) {
  if constexpr (P.uniform) {
    return broadcast<Law::template Parameters, Real>(wall.parameters);
  } else {
    std::int32_t kind[lane_count<Real>];
    for (int k = 0; k < lane_count<Real>; ++k) kind[k] = view.kind[sphere.at[k]];
    return gather<Law::template Parameters, Real>(wall.parameters, kind);
  }
}

/// Sphere and wall as two bodies; lanes beyond the reach overlap by next to nothing.
template <class Real>
TouchingPair<Real> pair_at_wall(const WallLanes<Real>& at, const VelocitySpin<Real>& motion,
                                const Vec<Real, 3>& wall_velocity) {
  const Vec<Real, 3>&v = motion.velocity, &w = motion.spin;
  TouchingPair<Real> pair;
  pair.normal = at.nearest.direction;
  pair.overlap = select(at.nearest.distance < at.reach, at.radius - at.nearest.distance, Real(1e-300));
  pair.velocity = wall_velocity - v - cross(at.nearest.distance * w, at.nearest.direction);
  pair.spin = -w;
  pair.mean_spin = Real(0.5) * w;
  return pair;
}

/// Energy dissipated in the contacts, and the work of the wall, in the lanes within reach.
template <class Law, class Real, class Parameters, class History>
void account_wall(const ContactView& view, const WallLanes<Real>& at, const Vec<Real, 3>& wall_velocity,
                  const Parameters& p, const TouchingPair<Real>& pair, History before, History after,
                  const ContactAction<Real>& action, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const Real on = select(at.nearest.distance < at.reach, Real(1.0), Real(0.0));
  const ContactAction<Real> counted{on * action.force, on * action.moment};
  before.spring = on * before.spring, after.spring = on * after.spring;
  const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, at.contact.at);
  Real elastic_force = Law::elastic_force(p, pair.overlap);  // beyond the reach 0, unless the law pulls
  if constexpr (Law::acts_beyond_touch) elastic_force = on * elastic_force;
  account<Law, Real>(p, pair, before, after, counted, elastic_force, Real(view.step), lanes, work, task);
  const double power = summed<Real>(dot(counted.force, wall_velocity), lanes);
  task.wall_work += view.step * power;
  task.wall_power += power;
}

/// Loads on the spheres, as rows. `deepest` of their overlaps over the radius, lane by lane.
template <class Law, ContactPhysics P, class Real>
LoadRows<Real> wall_loads(const ContactView& view, const WallView& wall, const WallLanes<Real>& at,
                          const Vec<Real, 3>& wall_velocity, ContactTask& task, Real& deepest) {
  using std::max;
  const auto p = wall_parameters<Law, P, Real>(view, wall, at.sphere);
  const TouchingPair<Real> pair = pair_at_wall(at, velocity_spin_at<Real>(view, at.sphere.at), wall_velocity);
  deepest = max(deepest, pair.overlap / at.radius);
  const RowStarts<Real> history_rows = rows_at<contact_history_size, Real>(view.histories, at.contact.at);
  auto history = load_struct<contact_history_size, Law::template History, Real>(history_rows);
  [[maybe_unused]] const auto before = history;
  const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
  store_struct<contact_history_size, Law::template History, Real>(history, history_rows);
  if constexpr (P.accounted)
    account_wall<Law>(view, at, wall_velocity, p, pair, before, history, action, task);
  LoadRows<Real> loads;
  to_rows(action.force, at.nearest.distance * cross(at.nearest.direction, action.force) + action.moment,
          loads);
  return loads;
}

/// Spheres of a part against one wall of a shape.
template <class Law, ContactPhysics P, template <class> class Shape, class Real>
FIBERCHAIN_FLATTEN void contact_wall(const ContactView& view, const WallView& wall, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const Shape<Real> shape = broadcast<Shape, Real>(wall.shape);
  const Vec<Real, 3> wall_velocity{Real(wall.velocity[0]), Real(wall.velocity[1]), Real(wall.velocity[2])};
  Real deepest(0.0);
  for (std::int32_t n = 0; n < wall.count; n += lanes) {
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = n + k;
    WallLanes<Real> at;
    at.sphere = slots_of<Real>(wall.slots, entry);
    const Balls<Real> ball = balls_at<Real>(view, at.sphere.at);
    at.nearest = shape.nearest(ball.center - shape.point);
    at.radius = ball.radius;
    at.reach = Law::acts_beyond_touch ? at.radius + contact_gap<Law, Real>(view) : at.radius;
    const unsigned touching = less_mask(at.nearest.distance, at.reach);
    const unsigned touched = touched_mask<Real>(wall.contact + n);
    if ((touching | touched) == 0) continue;
    for (unsigned begins = touching & ~touched; begins != 0; begins &= begins - 1)
      wall.contact[n + __builtin_ctz(begins)] = begin_contact<P>(view, task);
    clear<P>(view, 0);  // of lanes that do not touch
    at.contact = slots_of<Real>(wall.contact, entry);
    const LoadRows<Real> loads = wall_loads<Law, P, Real>(view, wall, at, wall_velocity, task, deepest);
    for (unsigned loaded = touching; loaded != 0; loaded &= loaded - 1) {
      const int k = __builtin_ctz(loaded);
      add_row<Real>(loads.at[k], at.sphere.at[k], task);
      ++task.contacts;
    }
    for (unsigned ends = touched & ~touching; ends != 0; ends &= ends - 1) {
      std::int32_t& contact = wall.contact[n + __builtin_ctz(ends)];
      contact = end_contact(contact, task);
    }
  }
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
