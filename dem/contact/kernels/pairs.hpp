#pragma once

#include <algorithm>

#include "dem/contact/kernels/account.hpp"
#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/kernels/pack_numbers.hpp"
#include "dem/math/inverse_sqrt.hpp"
#include "dem/simd/flatten.hpp"
#include "dem/simd/gather.hpp"
#include "dem/simd/transpose.hpp"

// The contact loop: distances of the inner pairs, then the law for those that touch, as many at a time as
// there are lanes.
namespace fiberchain::dem {

/// Slots of some spheres, one a lane.
template <class Real>
struct Slots {
  std::int32_t at[lane_count<Real>];
};

template <class Real>
Slots<Real> slots_of(const std::int32_t* slots, const std::int32_t* entries) {
  Slots<Real> chosen;
  for (int k = 0; k < lane_count<Real>; ++k) chosen.at[k] = slots[entries[k]];
  return chosen;
}

/// Rows of N numbers of these slots, or of these contacts.
template <int N, class Real, class Number>
RowStarts<Real, Number> rows_at(Number* rows, const std::int32_t* entries) {
  RowStarts<Real, Number> starts;
  for (int k = 0; k < lane_count<Real>; ++k)
    starts.at[k] = rows + static_cast<std::ptrdiff_t>(entries[k]) * N;
  return starts;
}

/// Centers and radii.
template <class Real>
struct Balls {
  Vec<Real, 3> center;
  Real radius;
};

template <class Real>
Balls<Real> balls_at(const ContactView& view, const std::int32_t* slots) {
  Real n[position_radius_size];
  load_rows<position_radius_size>(rows_at<position_radius_size, Real>(view.position_radius, slots), 0, n);
  return {{n[0], n[1], n[2]}, n[radius_offset]};
}

template <class Real>
struct VelocitySpin {
  Vec<Real, 3> velocity, spin;
};

template <class Real>
VelocitySpin<Real> velocity_spin_at(const ContactView& view, const std::int32_t* slots) {
  Real n[velocity_spin_size];
  load_rows<velocity_spin_size>(rows_at<velocity_spin_size, Real>(view.velocity_spin, slots), 0, n);
  return {{n[0], n[1], n[2]}, {n[spin_offset], n[spin_offset + 1], n[spin_offset + 2]}};
}

/// From one to the other, the nearest image of it where the box is periodic.
template <ContactPhysics P, class Real>
Vec<Real, 3> separation(const ContactView& view, const Balls<Real>& a, const Balls<Real>& b) {
  const Vec<Real, 3> r = b.center - a.center;
  if constexpr (P.periodic) return nearest_image(view.periods, r);
  return r;
}

/// Fetches a cache line ahead of its use: which rows pairs need is known long before, but not to the
/// processor.
inline __attribute__((always_inline)) void fetch_line(const double* line) { __builtin_prefetch(line, 0, 3); }

/// Pairs ahead of which rows are fetched.
inline constexpr int pairs_ahead = 48, touching_ahead = 24;

/// Lanes in which spheres have a gap below `gap`.
template <ContactPhysics P, class Real>
unsigned closer_than(const ContactView& view, const Real& gap, const std::int32_t* first,
                     const std::int32_t* second) {
  const Balls<Real> a = balls_at<Real>(view, first), b = balls_at<Real>(view, second);
  const Vec<Real, 3> r = separation<P>(view, a, b);
  const Real reach = P.uniform ? Real(2.0 * view.radius) + gap : a.radius + b.radius + gap;
  return less_mask(dot(r, r), reach * reach);
}

template <class Real>
void fetch_positions(const ContactView& view, const std::int32_t* slots, std::int32_t n, std::int32_t end) {
  if (n + pairs_ahead + lane_count < Real >> end) return;
  for (int k = 0; k < lane_count<Real>; ++k)
    fetch_line(view.position_radius +
               static_cast<std::ptrdiff_t>(slots[n + pairs_ahead + k]) * position_radius_size);
}

/// Of some pairs, those that touched the step before.
template <class Real>
unsigned touched_mask(const std::int32_t* contact) {
  unsigned mask = 0;
  for (int k = 0; k < lane_count<Real>; ++k) mask |= (contact[k] != 0 ? 1u : 0u) << k;
  return mask;
}

/// Puts the listed pairs p + lane of a mask behind the inner ones found; how many there are then.
inline std::int32_t add_inner(const ContactView& view, std::int32_t p, unsigned chosen,
                              const InnerPairs& inner, std::int32_t found) {
  for (; chosen != 0; chosen &= chosen - 1) {
    const std::int32_t pair = p + __builtin_ctz(chosen);
    inner.pair[found] = pair;
    inner.first[found] = view.first[pair];
    inner.second[found] = view.second[pair];
    inner.contact[found] = view.contact[pair];
    inner.touches[found++] = view.contact[pair] != 0 ? 1 : 0;
  }
  return found;
}

template <ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN std::int32_t prune_pairs(const ContactView& view, std::int32_t begin, std::int32_t end,
                                            double gap, const InnerPairs& inner, std::int32_t found) {
  constexpr int lanes = lane_count<Real>;
  for (std::int32_t p = begin; p < end; p += lanes) {
    fetch_positions<Real>(view, view.second, p, end);
    const unsigned closer = closer_than<P, Real>(view, Real(gap), view.first + p, view.second + p);
    found = add_inner(view, p, closer | touched_mask<Real>(view.contact + p), inner, found);
  }
  return found;
}

template <ContactPhysics P>
void clear(const ContactView& view, std::ptrdiff_t contact) {
  for (int n = 0; n < contact_history_size; ++n) view.histories[contact * contact_history_size + n] = 0;
  if constexpr (P.accounted) {
    for (int n = 0; n < contact_account_size; ++n) view.work[contact * contact_account_size + n] = 0;
  }
}

/// A number for a contact that begins: nothing is remembered of it.
template <ContactPhysics P>
std::int32_t begin_contact(const ContactView& view, ContactTask& task) {
  const std::int32_t contact = task.free[--task.free_count];
  clear<P>(view, contact);
  return contact;
}

inline std::int32_t end_contact(std::int32_t contact, ContactTask& task) {
  task.free[task.free_count++] = contact;
  return 0;
}

/// Gap up to which bodies are in contact [m].
template <class Law, class Real>
Real contact_gap(const ContactView& view) {
  if constexpr (Law::acts_beyond_touch) return Real(view.reach);
  return Real(0.0);
}

/// Of a pair of spheres.
template <class Law, ContactPhysics P>
const double* pair_parameters(const ContactView& view, std::int32_t first, std::int32_t second) {
  const std::ptrdiff_t entry = P.uniform ? 0 : view.kind[first] * view.kinds + view.kind[second];
  return view.parameters + entry * numbers_in<Law::template Parameters>;
}

/// Inner pairs that touch go into the task's list; those that begin or end are marked.
template <class Law, ContactPhysics P, class Real>
int find_touching(const ContactView& view, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const InnerPairs& inner = task.inner;
  int count = 0;
  for (std::int32_t n = 0; n < task.inner_count; n += lanes) {
    fetch_positions<Real>(view, inner.second, n, task.inner_count);
    const unsigned touching =
        closer_than<P, Real>(view, contact_gap<Law, Real>(view), inner.first + n, inner.second + n);
    for (unsigned changed = flag_mask<Real>(inner.touches + n) ^ touching; changed != 0;
         changed &= changed - 1) {
      const int k = n + __builtin_ctz(changed);
      inner.touches[k] ^= 1;
      if constexpr (P.accounted && Law::acts_beyond_touch) {
        if (inner.touches[k] == 0)
          task.account.normal_dashpot += lost_at_end<Law>(
              view, pair_parameters<Law, P>(view, inner.first[k], inner.second[k]), inner.contact[k]);
      }
      inner.contact[k] =
          inner.touches[k] != 0 ? begin_contact<P>(view, task) : end_contact(inner.contact[k], task);
      view.contact[inner.pair[k]] = inner.contact[k];
    }
    append_lanes<Real>(touching, n, task.touching + count);
    count += __builtin_popcount(touching);
  }
  return count;
}

/// What one pair gives to its two spheres.
template <class Real>
struct PairLoads {
  Vec<Real, 3> force, first_moment, second_moment;  ///< force on the first
};

/// The law for pairs of the spheres i and j, of which `count` count. `deepest` of their overlaps over the
/// smaller radius, lane by lane.
template <class Law, ContactPhysics P, class Real>
PairLoads<Real> pair_loads(const ContactView& view, const Slots<Real>& contacts, const Slots<Real>& i,
                           const Slots<Real>& j, int count, ContactTask& task, Real& deepest) {
  using std::max, std::min;
  constexpr int lanes = lane_count<Real>;
  const Balls<Real> a = balls_at<Real>(view, i.at), b = balls_at<Real>(view, j.at);
  const VelocitySpin<Real> motion_i = velocity_spin_at<Real>(view, i.at),
                           motion_j = velocity_spin_at<Real>(view, j.at);
  const Vec<Real, 3> r = separation<P>(view, a, b);
  const Real squared = dot(r, r), inverse_distance = inverse_sqrt(squared),
             distance = squared * inverse_distance;
  typename Law::template Parameters<Real> p;
  Real radii, share = Real(0.5), smaller;
  if constexpr (P.uniform) {
    p = broadcast<Law::template Parameters, Real>(view.parameters);
    radii = Real(2.0 * view.radius);
    smaller = Real(view.radius);
  } else {
    radii = a.radius + b.radius;
    share = a.radius / radii;
    smaller = min(a.radius, b.radius);
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = view.kind[i.at[k]] * view.kinds + view.kind[j.at[k]];
    p = gather<Law::template Parameters, Real>(view.parameters, entry);
  }
  const Real arm_i = share * distance, arm_j = distance - arm_i;
  TouchingPair<Real> pair;
  pair.normal = inverse_distance * r;
  pair.overlap = radii - distance;
  if constexpr (!Law::acts_beyond_touch)
    pair.overlap = max(pair.overlap, Real(1e-300));  // squares that differ may have one root
  deepest = max(deepest, pair.overlap / smaller);
  pair.velocity = plus_cross(motion_j.velocity - motion_i.velocity, pair.normal,
                             arm_i * motion_i.spin + arm_j * motion_j.spin);
  pair.spin = motion_j.spin - motion_i.spin;
  pair.mean_spin = Real(0.5) * (motion_i.spin + motion_j.spin);
  const RowStarts<Real> history_rows = rows_at<contact_history_size, Real>(view.histories, contacts.at);
  auto history = load_struct<contact_history_size, Law::template History, Real>(history_rows);
  [[maybe_unused]] const auto before = history;
  const ContactAction<Real> action = Law::template act<P.rolling>(p, pair, Real(view.step), history);
  if constexpr (P.accounted) {
    const RowStarts<Real> work = rows_at<contact_account_size, Real>(view.work, contacts.at);
    account<Law, Real>(p, pair, before, history, action,
                       elastic_force_of<Law, Real>(p, pair.overlap, history), Real(view.step), count, work,
                       task);
  }
  store_struct<contact_history_size, Law::template History, Real>(history, history_rows);
  const Vec<Real, 3> turn = cross(pair.normal, action.force);
  return {action.force, arm_i * turn + action.moment, arm_j * turn - action.moment};
}

/// Loads as rows.
template <class Real>
struct LoadRows {
  alignas(64) double at[lane_count<Real>][load_size];
};

template <class Real>
void to_rows(const Vec<Real, 3>& force, const Vec<Real, 3>& moment, LoadRows<Real>& rows) {
  RowStarts<Real> starts;
  for (int k = 0; k < lane_count<Real>; ++k) starts.at[k] = rows.at[k];
  const Real none(0.0),
      n[load_size] = {force[0], force[1], force[2], moment[0], moment[1], moment[2], none, none};
  store_rows<load_size>(n, starts, 0);
}

/// Adds loads to those of a sphere of the part; on AVX-512 in one go.
template <class Real>
inline __attribute__((always_inline)) void add_row(const double* loads, std::int32_t slot,
                                                   const ContactTask& task) {
  double* row = task.loads + static_cast<std::ptrdiff_t>(slot - task.slots_begin) * load_size;
#ifdef __AVX512F__
  if constexpr (lane_count<Real> == 8) {
    _mm512_store_pd(row, _mm512_add_pd(_mm512_load_pd(row), _mm512_load_pd(loads)));
    return;
  }
#endif
  for (int c = 0; c < moment_offset + 3; ++c) row[c] += loads[c];
}

/// Adds pairs' loads to their spheres in the order of the pairs.
template <class Real>
void add_loads(const PairLoads<Real>& loads, const Slots<Real>& i, const Slots<Real>& j, int count,
               ContactTask& task) {
  LoadRows<Real> first, second;
  to_rows(loads.force, loads.first_moment, first);
  to_rows(-loads.force, loads.second_moment, second);
  for (int k = 0; k < count; ++k) {
    add_row<Real>(first.at[k], i.at[k], task);
    if (j.at[k] < task.slots_end) {
      add_row<Real>(second.at[k], j.at[k], task);
    } else {
      HaloForce& later = task.halo[task.halo_count++];
      for (int c = 0; c < 6; ++c) later.load[c] = second.at[k][c];
      later.slot = j.at[k];
    }
  }
}

/// What the touching pairs n ... n + lanes - 1 need.
template <class Real>
void fetch_touching(const ContactView& view, const ContactTask& task, int n, int touching) {
  for (int k = n; k < n + lane_count<Real> && k < touching; ++k) {
    const std::int32_t n_k = task.touching[k], i = task.inner.first[n_k], j = task.inner.second[n_k];
    fetch_line(view.histories + static_cast<std::ptrdiff_t>(task.inner.contact[n_k]) * contact_history_size);
    for (const std::int32_t sphere : {i, j}) {
      const double* motion = view.velocity_spin + static_cast<std::ptrdiff_t>(sphere) * velocity_spin_size;
      fetch_line(motion), fetch_line(motion + velocity_spin_size - 1);
    }
  }
}

template <class Law, ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN void contact_pairs(const ContactView& view, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const int touching = find_touching<Law, P, Real>(view, task);
  task.contacts += touching;
  for (int n = 0; n < touching_ahead; n += lanes) fetch_touching<Real>(view, task, n, touching);
  Real deepest(0.0);
  for (int n = 0; n < touching; n += lanes) {
    fetch_touching<Real>(view, task, n + touching_ahead, touching);
    const int count = touching - n < lanes ? touching - n : lanes;
    for (int k = count; k < lanes; ++k) task.touching[n + k] = task.touching[n];
    const std::int32_t* chosen = task.touching + n;
    const Slots<Real> contacts = slots_of<Real>(task.inner.contact, chosen);
    const Slots<Real> i = slots_of<Real>(task.inner.first, chosen),
                      j = slots_of<Real>(task.inner.second, chosen);
    add_loads(pair_loads<Law, P, Real>(view, contacts, i, j, count, task, deepest), i, j, count, task);
  }
  task.deepest = std::max(task.deepest, largest_lane(deepest));
}

}  // namespace fiberchain::dem
