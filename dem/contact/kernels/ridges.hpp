#pragma once

#include "dem/contact/kernels/segments.hpp"
#include "dem/contact/kernels/walls.hpp"

// Segments of smooth fibers at the ridges of a wall, found before: the law, as many at a time as there are
// lanes.
namespace fiberchain::dem {

/// Loads on the nodes of the contacts n ... n + lanes - 1, of which `count` count.
template <class Law, ContactPhysics P, class Real>
void touch_ridges(const SegmentView& view, const RidgeView& wall, const WallMotionLanes<Real>& motion, int n,
                  int count, ContactTask& task, WallLoadLanes<Real>& load, Real& deepest) {
  using std::max, std::min;
  const BodySlots<Real> at = body_slots<Real>(view, wall.slots + n);
  const SegmentNodes<Real> segment = bodies_at(view, at);
  const Real place = load_lanes<Real>(wall.places + n);
  WallLanes<Real> lanes;
  lanes.sphere = at.begin;
  for (int k = 0; k < lane_count<Real>; ++k) lanes.contact.at[k] = wall.contact[n + k];
  listed_nearest<Real>(wall, n, {}, lanes.nearest);
  lanes.radius = lanes.reach = segment.radius;
  // pads are far away in no direction
  const Real near = min(lanes.nearest.distance, lanes.reach);
  lanes.arm = along(segment, place) + near * lanes.nearest.direction - broadcast_vector<Real>(wall.center);
  const TouchingPair<Real> pair = pair_at_wall(lanes, motion_along(view, at, place), motion);
  deepest = max(deepest, pair.overlap / lanes.radius);
  const auto p = wall_parameters<Law, P, Real>(view, wall, at.begin);
  const RowStarts<Real> rows = rows_at<contact_history_size, Real>(view.histories, lanes.contact.at);
  auto history = load_struct<contact_history_size, Law::template History, Real>(rows);
  [[maybe_unused]] const auto before = history;
  history.share_less_one = load_lanes<Real>(wall.shares + n) - Real(1.0);
  history.stiffer = Real(0.0);
  const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
  if constexpr (P.accounted) {
    const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, lanes.contact.at);
    account<Law, Real>(p, pair, before, history, action, Law::elastic_force(p, history), Real(view.step),
                       count, work, task);
  }
  store_struct<contact_history_size, Law::template History, Real>(history, rows);
  load_wall(lanes, action, load);
  add_body_loads(action.force, near * cross(lanes.nearest.direction, action.force) + action.moment, place, at,
                 count, task);
}

template <class Law, ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN void contact_ridges(const ContactView& base, const RidgeView& wall, ContactTask& task) {
  const auto& view = static_cast<const SegmentView&>(base);
  constexpr int lanes = lane_count<Real>;
  const WallMotionLanes<Real> motion{broadcast_vector<Real>(wall.velocity),
                                     broadcast_vector<Real>(wall.spin)};
  WallLoadLanes<Real> load;
  Real deepest(0.0);
  clear<P>(view, 0);  // of pads
  for (int n = 0; n < wall.touching; n += lanes) {
    const int count = wall.touching - n < lanes ? wall.touching - n : lanes;
    touch_ridges<Law, P, Real>(view, wall, motion, n, count, task, load, deepest);
  }
  for (int c = 0; c < 3; ++c) {
    task.wall_force[c] += summed<Real>(load.force[c], lanes);
    task.wall_moment[c] += summed<Real>(load.moment[c], lanes);
  }
  task.contacts += wall.touching;
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
