#pragma once

#include "dem/contact/lanes/gather.hpp"
#include "dem/contact/view.hpp"
#include "dem/motion/lanes/flatten.hpp"
#include "dem/motion/lanes/transpose.hpp"

// The contact loop: distances of all close pairs, then the law for those that touch, as many at a time as there are lanes.
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

template <int N, class Real>
RowStarts<Real, const double> rows_at(const double* rows, const std::int32_t* slots) {
  RowStarts<Real, const double> starts;
  for (int k = 0; k < lane_count<Real>; ++k) starts.at[k] = rows + static_cast<std::ptrdiff_t>(slots[k]) * N;
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
  Real n[position_numbers];
  load_rows<position_numbers>(rows_at<position_numbers, Real>(view.position, slots), 0, n);
  return {{n[0], n[1], n[2]}, n[3]};
}

template <class Real>
struct Motions {
  Vec<Real, 3> velocity, spin;
};

template <class Real>
Motions<Real> motions_at(const ContactView& view, const std::int32_t* slots) {
  Real n[motion_numbers];
  load_rows<motion_numbers>(rows_at<motion_numbers, Real>(view.motion, slots), 0, n);
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

/// The nearest image of a separation in a periodic cell.
template <ContactPhysics P, class Real>
Vec<Real, 3> nearest_image(const ContactView& view, Vec<Real, 3> r) {
  if constexpr (P.periodic) {
    for (int c = 0; c < 3; ++c) r[c] = r[c] - Real(view.period[c]) * nearest(r[c] * Real(view.inverse_period[c]));
  }
  return r;
}

/// Fetches a row ahead of its use: which rows pairs need is known long before, but not to the processor.
template <int N>
inline __attribute__((always_inline)) void fetch_row(const double* rows, std::ptrdiff_t row) {
  __builtin_prefetch(rows + row * N, 1, 3);
  if constexpr (N % 8 != 0 && 8 % N != 0) __builtin_prefetch(rows + row * N + N - 1, 1, 3);
}

/// Numbers of pairs ahead that rows are fetched.
inline constexpr int pairs_ahead = 48, touching_ahead = 24;

/// Pairs of the task that touch go into its list; those that no longer do are marked.
template <ContactPhysics P, class Real>
int find_touching(const ContactView& view, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  int count = 0;
  for (std::int32_t p = task.begin; p < task.end; p += lanes) {
    if (p + pairs_ahead + lanes <= task.end) {
      for (int k = 0; k < lanes; ++k) fetch_row<position_numbers>(view.position, view.second[p + pairs_ahead + k]);
    }
    const Balls<Real> a = balls_at<Real>(view, view.first + p), b = balls_at<Real>(view, view.second + p);
    const Vec<Real, 3> r = nearest_image<P, Real>(view, b.center - a.center);
    const Real reach = P.uniform ? Real(2.0 * view.position[3]) : a.radius + b.radius;
    unsigned touching = less_mask(dot(r, r), reach * reach);
    unsigned ended = flag_mask<Real>(view.touched + p) & ~touching;
    for (; touching != 0; touching &= touching - 1) task.touching[count++] = p + __builtin_ctz(touching);
    for (; ended != 0; ended &= ended - 1) view.touched[p + __builtin_ctz(ended)] = 0;
  }
  return count;
}

template <class Real>
ContactParameters<Real> broadcast(const ContactParameters<double>& p) {
  ContactParameters<Real> result;
  const double* in = reinterpret_cast<const double*>(&p);
  Real* out = reinterpret_cast<Real*>(&result);
  for (std::size_t n = 0; n < sizeof(p) / sizeof(double); ++n) out[n] = Real(in[n]);
  return result;
}

/// Parameters of the pairs' kinds.
template <class Real>
ContactParameters<Real> gather_parameters(const ContactParameters<double>* table, const std::int32_t* entry) {
  constexpr int numbers = sizeof(ContactParameters<double>) / sizeof(double);
  std::int32_t index[lane_count<Real>];
  for (int k = 0; k < lane_count<Real>; ++k) index[k] = entry[k] * numbers;
  ContactParameters<Real> result;
  Real* out = reinterpret_cast<Real*>(&result);
  const double* in = reinterpret_cast<const double*>(table);
  for (int n = 0; n < numbers; ++n) out[n] = gather_lanes<Real>(in + n, index);
  return result;
}

/// What one pair gives to its two spheres.
template <class Real>
struct PairLoads {
  Vec<Real, 3> force, first_moment, second_moment;  ///< force on the first
};

template <class Real>
double summed(const Real& value, int count) {
  double numbers[lane_count<Real>], sum = 0;
  store_lanes(value, numbers);
  for (int k = 0; k < count; ++k) sum += numbers[k];
  return sum;
}

/// Tangential springs of a contact [J].
template <class Real>
Real spring_energy(const ContactParameters<Real>& p, const ContactHistory<Real>& h) {
  using std::max;
  using std::sqrt;
  const Real stiffness = max(p.tangential * sqrt(max(h.overlap, Real(0.0))), Real(1e-300));
  return select(h.overlap > Real(0.0), Real(0.5) * dot(h.spring, h.spring) / stiffness, Real(0.0));
}

/// Energies of the step. A kick with a force takes force times the mean of the velocities before and after it: the one
/// before is at hand, the one after comes with the next step, which corrects this one by what its row keeps.
template <class Real>
void book(const ContactParameters<Real>& p, const TouchingPair<Real>& pair, const ContactHistory<Real>& before,
          const ContactHistory<Real>& after, const ContactAction<Real>& action, const Real& dt, int count,
          const RowStarts<Real>& work, ContactTask& task) {
  using std::sqrt;
  const Real opening = dot(pair.velocity, pair.normal);
  const Real push = Real(0.0) - dot(action.force, pair.normal);
  const Real dashpot = p.normal * pair.overlap * sqrt(pair.overlap) - push;
  const Vec<Real, 3> slip = pair.velocity - opening * pair.normal, drag = action.force + push * pair.normal;
  Real kept[work_numbers];
  load_rows<work_numbers>(work, 0, kept);
  const auto held = before.overlap > Real(0.0);
  const auto of_step_before = [&](const Real& power_now) { return select(held, Real(0.5) * dt * power_now, Real(0.0)); };
  const Vec<Real, 3> last_drag{kept[1], kept[2], kept[3]};
  const Real normal = dashpot * opening, sliding = dot(drag, slip), rolling = dot(action.moment, pair.spin);
  task.book.normal_dashpot += summed<Real>(dt * normal + of_step_before(kept[0] * (opening - before.opening)), count);
  task.book.sliding += summed<Real>(dt * sliding + of_step_before(dot(last_drag, slip) - kept[7]) -
                                        (spring_energy(p, after) - spring_energy(p, before)), count);
  task.book.rolling += summed<Real>(dt * rolling, count);
  task.power.normal_dashpot += summed<Real>(normal, count);
  task.power.sliding += summed<Real>(sliding, count);
  task.power.rolling += summed<Real>(rolling, count);
  const Real keep[work_numbers] = {dashpot, drag[0], drag[1], drag[2], Real(0.0), Real(0.0), Real(0.0), sliding};
  store_rows<work_numbers>(keep, work, 0);
}

/// What contacts remember; nothing of those that did not touch a step before.
template <class Real>
ContactHistory<Real> remembered(const RowStarts<Real>& memory, const std::uint8_t* touched, const std::int32_t* entries) {
  double on[lane_count<Real>];
  for (int k = 0; k < lane_count<Real>; ++k) on[k] = touched[entries[k]];
  const Real was = load_lanes<Real>(on);
  Real n[memory_numbers];
  load_rows<memory_numbers>(memory, 0, n);
  const auto held = was > Real(0.0);
  const Real zero(0.0);
  return {{select(held, n[0], zero), select(held, n[1], zero), select(held, n[2], zero)}, select(held, n[3], zero),
          select(held, n[4], zero)};
}

template <class Real>
void keep(const ContactHistory<Real>& history, const RowStarts<Real>& memory) {
  const Real n[memory_numbers] = {history.spring[0], history.spring[1], history.spring[2], history.overlap, history.opening,
                                  Real(0.0)};
  store_rows<memory_numbers>(n, memory, 0);
}

/// The law for the pairs touching[0 ... lanes - 1], of which `count` count.
template <ContactPhysics P, class Real>
PairLoads<Real> pair_loads(const ContactView& view, const std::int32_t* pairs, const Slots<Real>& i,
                           const Slots<Real>& j, int count, ContactTask& task) {
  using std::sqrt;
  constexpr int lanes = lane_count<Real>;
  const Balls<Real> a = balls_at<Real>(view, i.at), b = balls_at<Real>(view, j.at);
  const Vec<Real, 3> r = nearest_image<P, Real>(view, b.center - a.center);
  const Real distance = sqrt(dot(r, r));
  ContactParameters<Real> p;
  Real reach, share = Real(0.5);
  if constexpr (P.uniform) {
    p = broadcast<Real>(view.parameters[0]);
    reach = Real(2.0 * view.position[3]);
  } else {
    reach = a.radius + b.radius;
    share = a.radius / reach;
    std::int32_t entry[lanes];
    for (int k = 0; k < lanes; ++k) entry[k] = view.kind[i.at[k]] * view.kinds + view.kind[j.at[k]];
    p = gather_parameters<Real>(view.parameters, entry);
  }
  const Motions<Real> motion_i = motions_at<Real>(view, i.at), motion_j = motions_at<Real>(view, j.at);
  const Real arm_i = share * distance, arm_j = distance - arm_i;
  TouchingPair<Real> pair;
  pair.normal = (Real(1.0) / distance) * r;
  pair.overlap = reach - distance;
  pair.velocity = motion_j.velocity - motion_i.velocity - cross(arm_i * motion_i.spin + arm_j * motion_j.spin, pair.normal);
  pair.spin = motion_j.spin - motion_i.spin;
  pair.mean_spin = Real(0.5) * (motion_i.spin + motion_j.spin);
  RowStarts<Real> memory;
  for (int k = 0; k < lanes; ++k) memory.at[k] = view.memory + static_cast<std::ptrdiff_t>(pairs[k]) * memory_numbers;
  ContactHistory<Real> history = remembered<Real>(memory, view.touched, pairs);
  [[maybe_unused]] const ContactHistory<Real> before = history;
  const ContactAction<Real> action = contact_action<P.rolling>(p, pair, Real(view.step), history);
  if constexpr (P.booked) {
    RowStarts<Real> work;
    for (int k = 0; k < lanes; ++k) work.at[k] = view.work + static_cast<std::ptrdiff_t>(pairs[k]) * work_numbers;
    book(p, pair, before, history, action, Real(view.step), count, work, task);
  }
  keep<Real>(history, memory);
  for (int k = 0; k < count; ++k) view.touched[pairs[k]] = 1;
  const Vec<Real, 3> turn = cross(pair.normal, action.force);
  return {action.force, arm_i * turn + action.moment, arm_j * turn - action.moment};
}

/// Force and moment as rows.
template <class Real>
struct LoadRows {
  alignas(64) double at[lane_count<Real>][8];
};

template <class Real>
void to_rows(const Vec<Real, 3>& force, const Vec<Real, 3>& moment, LoadRows<Real>& rows) {
  RowStarts<Real> starts;
  for (int k = 0; k < lane_count<Real>; ++k) starts.at[k] = rows.at[k];
  const Real n[load_numbers] = {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
  store_rows<load_numbers>(n, starts, 0);
}

/// target += row; on AVX-512 in one go.
template <class Real>
inline __attribute__((always_inline)) void add_row(const double* row, double* target) {
#ifdef __AVX512F__
  if constexpr (lane_count<Real> == 8) {
    const __m512d sum = _mm512_add_pd(_mm512_loadu_pd(target), _mm512_load_pd(row));
    _mm512_mask_storeu_pd(target, (1u << load_numbers) - 1u, sum);
    return;
  }
#endif
  for (int c = 0; c < load_numbers; ++c) target[c] += row[c];
}

/// Adds pairs' loads to their spheres in the order of the pairs.
template <class Real>
void add_loads(const ContactView& view, const PairLoads<Real>& loads, const Slots<Real>& i, const Slots<Real>& j,
               int count, ContactTask& task) {
  LoadRows<Real> first, second;
  to_rows(loads.force, loads.first_moment, first);
  to_rows(-loads.force, loads.second_moment, second);
  for (int k = 0; k < count; ++k) {
    add_row<Real>(first.at[k], view.force + static_cast<std::ptrdiff_t>(i.at[k]) * load_numbers);
    if (j.at[k] < task.slots_end) {
      add_row<Real>(second.at[k], view.force + static_cast<std::ptrdiff_t>(j.at[k]) * load_numbers);
    } else {
      DeferredForce& later = task.deferred[task.deferred_count++];
      for (int c = 0; c < load_numbers; ++c) later.load[c] = second.at[k][c];
      later.slot = j.at[k];
    }
  }
}

/// What the touching pairs n ... n + lanes - 1 need.
template <class Real>
void fetch_touching(const ContactView& view, const ContactTask& task, int n, int touching) {
  for (int k = n; k < n + lane_count<Real> && k < touching; ++k) {
    const std::int32_t pair = task.touching[k], i = view.first[pair], j = view.second[pair];
    fetch_row<memory_numbers>(view.memory, pair);
    for (const std::int32_t sphere : {i, j}) {
      fetch_row<motion_numbers>(view.motion, sphere);
      fetch_row<load_numbers>(view.force, sphere);
    }
  }
}

template <ContactPhysics P, class Real>
FIBERCHAIN_FLATTEN void contact_pairs(const ContactView& view, ContactTask& task) {
  constexpr int lanes = lane_count<Real>;
  const int touching = find_touching<P, Real>(view, task);
  task.contacts += touching;
  for (int n = 0; n < touching_ahead; n += lanes) fetch_touching<Real>(view, task, n, touching);
  for (int n = 0; n < touching; n += lanes) {
    fetch_touching<Real>(view, task, n + touching_ahead, touching);
    std::int32_t pairs[lanes];
    const int count = touching - n < lanes ? touching - n : lanes;
    for (int k = 0; k < lanes; ++k) pairs[k] = task.touching[n + (k < count ? k : 0)];
    const Slots<Real> i = slots_of<Real>(view.first, pairs), j = slots_of<Real>(view.second, pairs);
    add_loads(view, pair_loads<P, Real>(view, pairs, i, j, count, task), i, j, count, task);
  }
}

}  // namespace fiberchain::dem
