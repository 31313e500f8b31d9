#pragma once

#include "dem/contact/kernels/pairs.hpp"
#include "dem/contact/kernels/segment_view.hpp"
#include "dem/contact/segment_geometry.hpp"

// The contact loop of smooth fibers: which inner pairs of segments touch, which of these are contacts of
// their own, whose history those that begin go on with, then the law, each as many pairs at a time as there
// are lanes.
namespace fiberchain::dem {

/// Nodes of some bodies, one a lane.
template <class Real>
struct BodySlots {
  Slots<Real> before, begin, end, behind;
};

template <class Real>
BodySlots<Real> body_slots(const SegmentView& view, const std::int32_t* bodies) {
  BodySlots<Real> at;
  for (int k = 0; k < lane_count<Real>; ++k) {
    const std::int32_t i = bodies[k];
    at.begin.at[k] = i;
    at.before.at[k] = view.nodes.before[i], at.end.at[k] = view.nodes.end[i];
    at.behind.at[k] = view.nodes.behind[i];
  }
  return at;
}

/// Without the nodes next to them.
template <class Real>
SegmentNodes<Real> bodies_at(const SegmentView& view, const BodySlots<Real>& at) {
  const Balls<Real> begin = balls_at<Real>(view, at.begin.at), end = balls_at<Real>(view, at.end.at);
  return {begin.center, begin.center, end.center, end.center, begin.radius};
}

template <class Real>
void add_neighbors(const SegmentView& view, const BodySlots<Real>& at, SegmentNodes<Real>& body) {
  body.before = balls_at<Real>(view, at.before.at).center;
  body.behind = balls_at<Real>(view, at.behind.at).center;
}

/// What takes the second body to the image nearest to the first one.
template <class Real>
Vec<Real, 3> image_shift(const SegmentView& view, const SegmentNodes<Real>& a, const SegmentNodes<Real>& b) {
  const Vec<Real, 3> r = Real(0.5) * ((b.begin + b.end) - (a.begin + a.end));
  return nearest_image(view.periods, r) - r;
}

template <class Real>
void shift(SegmentNodes<Real>& body, const Vec<Real, 3>& by) {
  body.before = body.before + by, body.begin = body.begin + by;
  body.end = body.end + by, body.behind = body.behind + by;
}

/// Lanes in which bodies have a gap below `gap`.
template <class Real>
unsigned bodies_closer_than(const SegmentView& view, const Real& gap, const std::int32_t* first,
                            const std::int32_t* second) {
  const SegmentNodes<Real> a = bodies_at(view, body_slots<Real>(view, first));
  SegmentNodes<Real> b = bodies_at(view, body_slots<Real>(view, second));
  shift(b, image_shift(view, a, b));
  const ClosestPlaces<Real> at = closest_places(a, b);
  const Vec<Real, 3> r = separation(a, b, at.first, at.second);
  const Real reach = a.radius + b.radius + gap;
  return less_mask(dot(r, r), reach * reach);
}

template <class Real>
FIBERCHAIN_FLATTEN std::int32_t prune_bodies(const ContactView& base, std::int32_t begin, std::int32_t end,
                                             double gap, const InnerPairs& inner, std::int32_t found) {
  const auto& view = static_cast<const SegmentView&>(base);
  constexpr int lanes = lane_count<Real>;
  for (std::int32_t p = begin; p < end; p += lanes) {
    fetch_positions<Real>(view, view.second, p, end);
    const unsigned closer = bodies_closer_than<Real>(view, Real(gap), view.first + p, view.second + p);
    found = add_inner(view, p, closer | touched_mask<Real>(view.contact + p), inner, found);
  }
  return found;
}

/// Inner pairs that overlap, to view.near; those that touched and no longer do to view.ended.
template <class Real>
int find_near(const SegmentView& view, const ContactTask& task, int& ended) {
  constexpr int lanes = lane_count<Real>;
  const InnerPairs& inner = task.inner;
  int count = 0;
  for (std::int32_t n = 0; n < task.inner_count; n += lanes) {
    fetch_positions<Real>(view, inner.second, n, task.inner_count);
    const unsigned near = bodies_closer_than<Real>(view, Real(0.0), inner.first + n, inner.second + n);
    for (unsigned gone = flag_mask<Real>(inner.touches + n) & ~near; gone != 0; gone &= gone - 1)
      view.ended[ended++] = n + __builtin_ctz(gone);
    append_lanes<Real>(near, n, view.near + count);
    count += __builtin_popcount(near);
  }
  return count;
}

/// Of those near, the pairs with a share go with it into the task's list; those that begin or end are noted.
template <class Real>
int choose_touching(const SegmentView& view, ContactTask& task, int near, int& begun, int& ended) {
  constexpr int lanes = lane_count<Real>;
  int count = 0;
  for (int n = 0; n < near; n += lanes) {
    const int valid = near - n < lanes ? near - n : lanes;
    for (int k = valid; k < lanes; ++k) view.near[n + k] = view.near[n];
    const BodySlots<Real> i = body_slots<Real>(view, slots_of<Real>(task.inner.first, view.near + n).at),
                          j = body_slots<Real>(view, slots_of<Real>(task.inner.second, view.near + n).at);
    SegmentNodes<Real> a = bodies_at(view, i), b = bodies_at(view, j);
    add_neighbors(view, i, a), add_neighbors(view, j, b);
    shift(b, image_shift(view, a, b));
    const SegmentContact<Real> at = segment_contact(a, b);
    const Vec<Real, 3> r = separation(a, b, at.first, at.second);
    const Real reach = a.radius + b.radius;
    const unsigned touching = less_mask(dot(r, r), reach * reach) & less_mask(Real(least_share), at.share);
    double numbers[4][lanes];
    store_lanes(at.first, numbers[0]), store_lanes(at.second, numbers[1]);
    store_lanes(at.share, numbers[2]), store_lanes(at.stiffness, numbers[3]);
    for (int k = 0; k < valid; ++k) {
      const std::int32_t pair = view.near[n + k];
      const bool touched = task.inner.touches[pair] != 0;
      if ((touching >> k & 1) == 0) {
        if (touched) view.ended[ended++] = pair;
        continue;
      }
      if (!touched) view.begun[begun++] = pair;
      for (int c = 0; c < 4; ++c) view.places[c * view.stride + count] = numbers[c][k];
      task.touching[count++] = pair;
    }
  }
  return count;
}

/// Whether two bodies are one, or neighbors along a smooth fiber.
template <class Real>
bool are_neighbors(const SegmentView& view, std::int32_t a, std::int32_t b) {
  return a == b || (view.nodes.end[a] != a && view.nodes.end[b] != b && (a - b == 1 || b - a == 1));
}

/// Whether a contact is among those that end in this step.
inline bool has_ended(const SegmentView& view, const ContactTask& task, std::int32_t contact, int ended) {
  for (int n = 0; n < ended; ++n) {
    if (task.inner.contact[view.ended[n]] == contact) return true;
  }
  return false;
}

/// The contact that one of a pair goes on with: of the same bodies or their neighbors, the one pressed in
/// deepest of those that share a body, else of those that end in this step (contacts slide over two joints at
/// once).
template <class Law, class Real>
std::int32_t source_of(const SegmentView& view, const ContactTask& task, std::int32_t pair, int ended) {
  const std::int32_t i = task.inner.first[pair], j = task.inner.second[pair];
  std::int32_t low = 0, high = view.pair_count;
  while (low < high) {
    const std::int32_t middle = low + (high - low) / 2;
    if (view.first[middle] < i - 1) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  std::int32_t best = 0;
  double deepest = 0;
  for (std::int32_t p = low; p < view.pair_count && view.first[p] <= i + 1; ++p) {
    const std::int32_t a = view.first[p], b = view.second[p], contact = view.contact[p];
    if (contact == 0 || (a == i && b == j)) continue;
    if (!are_neighbors<Real>(view, a, i) || !are_neighbors<Real>(view, b, j)) continue;
    if (a != i && b != j && !has_ended(view, task, contact, ended)) continue;
    const double depth =
        view.histories[static_cast<std::ptrdiff_t>(contact) * contact_history_size + Law::sqrt_overlap_at];
    const double weight = (a == i || b == j) ? 2 * depth : depth;
    if (weight > deepest) deepest = weight, best = contact;
  }
  return best;
}

/// Histories of contacts that begin, and back those of contacts that have ended. One that ends hands on all
/// that is known of the step before; of one that goes on the spring is copied, with no share of it yet.
template <class Law, ContactPhysics P, class Real>
void begin_and_end(const SegmentView& view, ContactTask& task, int begun, int ended) {
  const InnerPairs& inner = task.inner;
  for (int n = 0; n < begun; ++n) view.source[n] = source_of<Law, Real>(view, task, view.begun[n], ended);
  for (int n = 0; n < begun; ++n) {
    const std::int32_t pair = view.begun[n], from = view.source[n];
    const std::int32_t contact = begin_contact<P>(view, task);
    inner.touches[pair] = 1, inner.contact[pair] = contact, view.contact[inner.pair[pair]] = contact;
    if (from == 0) continue;
    double* to = view.histories + static_cast<std::ptrdiff_t>(contact) * contact_history_size;
    double* old = view.histories + static_cast<std::ptrdiff_t>(from) * contact_history_size;
    for (int c = 0; c < contact_history_size; ++c) to[c] = old[c];
    if (!has_ended(view, task, from, ended)) {
      to[Law::rolling_power_at] = 0, to[Law::share_less_one_at] = -1;
      continue;
    }
    old[Law::share_less_one_at] = -1, old[Law::rolling_power_at] = 0;  // handed on once
    if constexpr (P.accounted) {
      for (int c = 0; c < contact_account_size; ++c) {
        double& work = view.work[static_cast<std::ptrdiff_t>(from) * contact_account_size + c];
        view.work[static_cast<std::ptrdiff_t>(contact) * contact_account_size + c] = work;
        work = 0;
      }
    }
  }
  for (int n = 0; n < ended; ++n) {
    const std::int32_t pair = view.ended[n];
    inner.touches[pair] = 0, view.contact[inner.pair[pair]] = 0;
    inner.contact[pair] = end_contact(inner.contact[pair], task);
  }
}

/// On the nodes of one body: its place between them shares force and moment.
template <class Real>
void add_body_loads(const Vec<Real, 3>& force, const Vec<Real, 3>& moment, const Real& place,
                    const BodySlots<Real>& at, int count, ContactTask& task) {
  LoadRows<Real> begin, end;
  const Real rest = Real(1.0) - place;
  to_rows(rest * force, rest * moment, begin);
  to_rows(place * force, place * moment, end);
  const auto put = [&](const double* row, std::int32_t slot) {
    if (slot < task.slots_end) {
      add_row<Real>(row, slot, task);
    } else {
      HaloForce& later = task.halo[task.halo_count++];
      for (int c = 0; c < 6; ++c) later.load[c] = row[c];
      later.slot = slot;
    }
  };
  for (int k = 0; k < count; ++k) {
    put(begin.at[k], at.begin.at[k]);
    if (at.end.at[k] != at.begin.at[k]) put(end.at[k], at.end.at[k]);
  }
}

template <class Real>
VelocitySpin<Real> motion_along(const SegmentView& view, const BodySlots<Real>& at, const Real& place) {
  const VelocitySpin<Real> begin = velocity_spin_at<Real>(view, at.begin.at),
                           end = velocity_spin_at<Real>(view, at.end.at);
  return {begin.velocity + place * (end.velocity - begin.velocity),
          begin.spin + place * (end.spin - begin.spin)};
}

/// The law for the touching pairs n ... n + lanes - 1, of which `count` count, and what it does to their
/// nodes.
template <class Law, ContactPhysics P, class Real>
void touch_bodies(const SegmentView& view, int n, int count, ContactTask& task, Real& deepest) {
  using std::max, std::min;
  const std::int32_t* chosen = task.touching + n;
  const Slots<Real> contacts = slots_of<Real>(task.inner.contact, chosen);
  const BodySlots<Real> i = body_slots<Real>(view, slots_of<Real>(task.inner.first, chosen).at),
                        j = body_slots<Real>(view, slots_of<Real>(task.inner.second, chosen).at);
  const SegmentNodes<Real> a = bodies_at(view, i);
  SegmentNodes<Real> b = bodies_at(view, j);
  shift(b, image_shift(view, a, b));
  const auto place = [&](int c) { return load_lanes<Real>(view.places + c * view.stride + n); };
  const Real first = place(0), second = place(1);
  const Vec<Real, 3> r = separation(a, b, first, second);
  const Real square = max(dot(r, r), Real(1e-290)), inverse_distance = inverse_sqrt(square),
             distance = square * inverse_distance, radii = a.radius + b.radius;
  const VelocitySpin<Real> motion_i = motion_along(view, i, first), motion_j = motion_along(view, j, second);
  const Real arm_i = a.radius / radii * distance, arm_j = distance - arm_i;
  TouchingPair<Real> pair;
  pair.normal = inverse_distance * r;
  pair.overlap = max(radii - distance, Real(1e-300));  // squares that differ may have one root
  deepest = max(deepest, pair.overlap / min(a.radius, b.radius));
  pair.velocity = plus_cross(motion_j.velocity - motion_i.velocity, pair.normal,
                             arm_i * motion_i.spin + arm_j * motion_j.spin);
  pair.spin = motion_j.spin - motion_i.spin;
  pair.mean_spin = Real(0.5) * (motion_i.spin + motion_j.spin);
  std::int32_t entry[lane_count<Real>];
  for (int k = 0; k < lane_count<Real>; ++k)
    entry[k] = view.kind[i.begin.at[k]] * view.kinds + view.kind[j.begin.at[k]];
  const auto p = gather<Law::template Parameters, Real>(view.parameters, entry);
  const RowStarts<Real> rows = rows_at<contact_history_size, Real>(view.histories, contacts.at);
  auto history = load_struct<contact_history_size, Law::template History, Real>(rows);
  [[maybe_unused]] const auto before = history;
  history.share_less_one = place(2) - Real(1.0);
  history.stiffer = place(3) - Real(1.0);
  const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
  if constexpr (P.accounted) {
    const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, contacts.at);
    account<Law, Real>(p, pair, before, history, action, Law::elastic_force(p, history), Real(view.step),
                       count, work, task);
  }
  store_struct<contact_history_size, Law::template History, Real>(history, rows);
  const Vec<Real, 3> turn = cross(pair.normal, action.force);
  add_body_loads(action.force, arm_i * turn + action.moment, first, i, count, task);
  add_body_loads(-action.force, arm_j * turn - action.moment, second, j, count, task);
}

template <class Law, ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN void contact_bodies(const ContactView& base, ContactTask& task) {
  const auto& view = static_cast<const SegmentView&>(base);
  constexpr int lanes = lane_count<Real>;
  int begun = 0, ended = 0;
  const int near = find_near<Real>(view, task, ended);
  const int touching = choose_touching<Real>(view, task, near, begun, ended);
  begin_and_end<Law, P, Real>(view, task, begun, ended);
  task.contacts += touching;
  Real deepest(0.0);
  for (int n = 0; n < touching; n += lanes) {
    fetch_touching<Real>(view, task, n + touching_ahead, touching);
    const int count = touching - n < lanes ? touching - n : lanes;
    for (int k = count; k < lanes; ++k) {
      task.touching[n + k] = task.touching[n];
      for (int c = 0; c < 4; ++c) view.places[c * view.stride + n + k] = view.places[c * view.stride + n];
    }
    touch_bodies<Law, P, Real>(view, n, count, task, deepest);
  }
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
