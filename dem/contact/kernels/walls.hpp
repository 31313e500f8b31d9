#pragma once

#include "dem/contact/kernels/pairs.hpp"
#include "dem/model/shapes/shapes.hpp"

namespace fiberchain::dem {

/// As many spheres as there are lanes, at a wall.
template <class Real>
struct WallLanes {
  Slots<Real> sphere, contact;
  NearestPoint<Real> nearest;  ///< of the wall
  Vec<Real, 3> arm;            ///< from the wall's center to its nearest point
  Real radius;
  Real reach;  ///< distance of the center below which the law acts
};

/// A rigid body's: v + w x arm.
template <class Real>
struct WallMotionLanes {
  Vec<Real, 3> velocity, spin;
};

/// On a wall, about its center, lane by lane.
template <class Real>
struct WallLoadLanes {
  Vec<Real, 3> force{Real(0.0), Real(0.0), Real(0.0)}, moment{Real(0.0), Real(0.0), Real(0.0)};
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
                                const WallMotionLanes<Real>& wall) {
  const Vec<Real, 3>&v = motion.velocity, &w = motion.spin;
  TouchingPair<Real> pair;
  pair.normal = at.nearest.direction;
  pair.overlap = select(at.nearest.distance < at.reach, at.radius - at.nearest.distance, Real(1e-300));
  pair.velocity =
      plus_cross(wall.velocity, wall.spin, at.arm) - v - cross(at.nearest.distance * w, at.nearest.direction);
  pair.spin = wall.spin - w;
  pair.mean_spin = Real(0.5) * (w + wall.spin);
  return pair;
}

/// Energy dissipated in the contacts, in the lanes within reach.
template <class Law, class Real, class Parameters, class History>
void account_wall(const ContactView& view, const WallLanes<Real>& at, const Parameters& p,
                  const TouchingPair<Real>& pair, History before, History after,
                  const ContactAction<Real>& action, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const Real on = select(at.nearest.distance < at.reach, Real(1.0), Real(0.0));
  const ContactAction<Real> counted{on * action.force, on * action.moment};
  before.spring = on * before.spring, after.spring = on * after.spring;
  const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, at.contact.at);
  Real elastic_force =
      elastic_force_of<Law, Real>(p, pair.overlap, after);  // beyond the reach 0, unless the law pulls
  if constexpr (Law::acts_beyond_touch) elastic_force = on * elastic_force;
  account<Law, Real>(p, pair, before, after, counted, elastic_force, Real(view.step), lanes, work, task);
}

/// What the lanes within reach do to the wall.
template <class Real>
void load_wall(const WallLanes<Real>& at, const ContactAction<Real>& action, WallLoadLanes<Real>& load) {
  const Real on = select(at.nearest.distance < at.reach, Real(1.0), Real(0.0));
  const Vec<Real, 3> force = on * action.force;
  load.force = load.force - force;
  load.moment = load.moment - cross(at.arm, force) - on * action.moment;
}

/// Loads on the spheres, as rows. `deepest` of their overlaps over the radius, lane by lane.
template <class Law, ContactPhysics P, class Real>
LoadRows<Real> wall_loads(const ContactView& view, const WallView& wall, const WallLanes<Real>& at,
                          const WallMotionLanes<Real>& motion, ContactTask& task, WallLoadLanes<Real>& load,
                          Real& deepest) {
  using std::max;
  const auto p = wall_parameters<Law, P, Real>(view, wall, at.sphere);
  const TouchingPair<Real> pair = pair_at_wall(at, velocity_spin_at<Real>(view, at.sphere.at), motion);
  deepest = max(deepest, pair.overlap / at.radius);
  const RowStarts<Real> history_rows = rows_at<contact_history_size, Real>(view.histories, at.contact.at);
  auto history = load_struct<contact_history_size, Law::template History, Real>(history_rows);
  [[maybe_unused]] const auto before = history;
  const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
  store_struct<contact_history_size, Law::template History, Real>(history, history_rows);
  if constexpr (P.accounted) account_wall<Law>(view, at, p, pair, before, history, action, task);
  load_wall(at, action, load);
  LoadRows<Real> loads;
  to_rows(action.force, at.nearest.distance * cross(at.nearest.direction, action.force) + action.moment,
          loads);
  return loads;
}

template <class Real>
Vec<Real, 3> broadcast_vector(const double* numbers) {
  return {Real(numbers[0]), Real(numbers[1]), Real(numbers[2])};
}

/// Nearest points of a wall's shape, seen from as many places as there are lanes: those of the entries of its
/// list from `entry` on.
template <class Real>
using NearestOfShape = void (*)(const WallView& wall, std::int32_t entry, const Vec<Real, 3>& place,
                                NearestPoint<Real>& nearest);

template <template <class> class Shape, class Real>
void nearest_of_shape(const WallView& wall, std::int32_t, const Vec<Real, 3>& place,
                      NearestPoint<Real>& nearest) {
  const Shape<Real> shape = broadcast<Shape, Real>(wall.shape);
  nearest = shape.nearest(place - shape.point);
}

/// Those of a mesh, found before.
template <class Real>
void listed_nearest(const WallView& wall, std::int32_t entry, const Vec<Real, 3>&,
                    NearestPoint<Real>& nearest) {
  const auto row = [&](int n) {
    return load_lanes<Real>(wall.nearest + static_cast<std::ptrdiff_t>(n) * wall.count + entry);
  };
  nearest = {{row(0), row(1), row(2)}, row(3)};
}

/// One a shape, then that of meshes, so that the loop with the law in it is compiled once for all of them.
template <class Real, class Shapes>
struct NearestOfShapes;
template <class Real, template <class> class... Shapes>
struct NearestOfShapes<Real, ShapeList<Shapes...>> {
  static constexpr NearestOfShape<Real> list[] = {nearest_of_shape<Shapes, Real>..., listed_nearest<Real>};
};

/// Spheres of a part against one wall.
template <class Law, ContactPhysics P, class Shapes, class Real>
FIBERCHAIN_FLATTEN void contact_wall(const ContactView& view, const WallView& wall, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const NearestOfShape<Real> nearest = Shapes::list[wall.shape_index];
  const WallMotionLanes<Real> motion{broadcast_vector<Real>(wall.velocity),
                                     broadcast_vector<Real>(wall.spin)};
  const Vec<Real, 3> center = broadcast_vector<Real>(wall.center);
  WallLoadLanes<Real> load;
  Real deepest(0.0);
  for (std::int32_t n = 0; n < wall.count; n += lanes) {
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = n + k;
    WallLanes<Real> at;
    at.sphere = slots_of<Real>(wall.slots, entry);
    const Balls<Real> ball = balls_at<Real>(view, at.sphere.at);
    nearest(wall, n, ball.center, at.nearest);
    at.radius = ball.radius;
    at.reach = Law::acts_beyond_touch ? at.radius + contact_gap<Law, Real>(view) : at.radius;
    const unsigned touching = less_mask(at.nearest.distance, at.reach);
    const unsigned touched = touched_mask<Real>(wall.contact + n);
    if ((touching | touched) == 0) continue;
    for (unsigned begins = touching & ~touched; begins != 0; begins &= begins - 1)
      wall.contact[n + __builtin_ctz(begins)] = begin_contact<P>(view, task);
    clear<P>(view, 0);  // of lanes that do not touch
    if constexpr (P.accounted && Law::acts_beyond_touch) {
      for (unsigned ends = touched & ~touching; ends != 0; ends &= ends - 1) {
        const int k = n + __builtin_ctz(ends);
        const std::ptrdiff_t kind = P.uniform ? 0 : view.kind[wall.slots[k]];
        task.account.normal_dashpot += lost_at_end<Law>(
            view, wall.parameters + kind * numbers_in<Law::template Parameters>, wall.contact[k]);
      }
    }
    at.contact = slots_of<Real>(wall.contact, entry);
    at.arm = ball.center + at.nearest.distance * at.nearest.direction - center;
    const LoadRows<Real> loads = wall_loads<Law, P, Real>(view, wall, at, motion, task, load, deepest);
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
  for (int c = 0; c < 3; ++c) {
    task.wall_force[c] += summed<Real>(load.force[c], lanes);
    task.wall_moment[c] += summed<Real>(load.moment[c], lanes);
  }
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
