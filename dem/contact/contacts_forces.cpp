#include <algorithm>
#include <cmath>

#include "dem/contact/contacts.hpp"
#include "dem/contact/wall_view.hpp"

// Forces and moments of all contacts at a step.
namespace fiberchain::dem {

std::size_t Contacts::most_new_contacts(const Part& part) const {
  std::size_t sum = part.inner.count;
  for (const WallNeighbors& neighbors : part.walls) sum += neighbors.count;
  return sum;
}

SegmentView Contacts::view(Part& part, const SphereStorage& rows) {
  SegmentView view{};
  view.position_radius = rows.position_radius.data();
  view.velocity_spin = rows.velocity_spin.data();
  view.kind = kind_of_sphere_.data();
  view.radius = radius_[0];
  view.first = part.pairs.first.data();
  view.second = part.pairs.second.data();
  view.periods = periods_;
  view.contact = part.pairs.contact.data();
  view.histories = part.histories.rows.data();
  view.work = part.histories.work.data();
  view.parameters = pair_parameters_.data();
  view.kinds = static_cast<std::int32_t>(bodies_.size());
  view.step = step_;
  view.reach = law_reach_;
  if (!fiber_bodies_.smooth) return view;
  view.nodes = fiber_bodies_.view();
  view.pair_count = static_cast<std::int32_t>(part.pairs.count);
  view.stride = static_cast<std::ptrdiff_t>(part.segment_places.size() / 4);
  std::int32_t* lists[4];
  for (int n = 0; n < 4; ++n) lists[n] = part.segment_pairs.data() + n * view.stride;
  view.near = lists[0], view.begun = lists[1], view.ended = lists[2], view.source = lists[3];
  view.places = part.segment_places.data();
  return view;
}

void Contacts::reserve_segments(Part& part) const {
  const std::size_t pairs = static_cast<std::size_t>(part.inner.count) + lanes_beyond;
  if (part.segment_pairs.size() >= 4 * pairs) return;
  const std::size_t with_rest = pairs + pairs / 8;
  part.segment_pairs.resize(4 * with_rest);
  part.segment_places = LaneArray(4 * with_rest);
}

WallView Contacts::wall_view(int w, WallNeighbors& neighbors, double time) const {
  return wall_view_at(domain_.walls[w], shapes_[w], neighbors, wall_parameters(w, 0), time, step_);
}

void Contacts::touch_walls(Part& part, const ContactView& contacts, double time, ContactTask& task) {
  const double time_before = (std::round(time / step_) - 1) * step_;  // to the bit, as the step before had it
  for (std::size_t w = 0; w < part.walls.size(); ++w) {
    part.wall_loads[w] = {};
    if (!is_active(domain_.walls[w], time)) continue;
    std::fill_n(task.wall_force, 3, 0.0), std::fill_n(task.wall_moment, 3, 0.0);
    if (has_ridges(w)) {
      touch_ridges(part, w, contacts, time, task);
    } else {
      kernel_->wall(contacts, wall_view(static_cast<int>(w), part.walls[w], time), task);
    }
    for (int c = 0; c < 3; ++c) {
      part.wall_loads[w].force[c] = task.wall_force[c];
      part.wall_loads[w].moment[c] = task.wall_moment[c];
    }
    if (time > 0 && !is_active(domain_.walls[w], time_before)) part.wall_brought[w] += brought_by(w, part);
  }
}

void Contacts::work_out(int k, const SphereStorage& rows, double time, LoadRange loads) {
  Part& part = parts_[k];
  const std::int32_t begin = parts().begin(k), end = parts().end(k);
  if (part.inner.stale) prune(part, end, rows);
  for (std::size_t w = 0; w < part.walls.size(); ++w) {
    if (!is_active(domain_.walls[w], time)) drop(w, part);
  }
  if (!mesh_poses_.empty()) find_mesh_contacts(part, rows, time);
  if (!ridges_.empty()) find_ridge_contacts(part, rows, time);
  part.histories.reserve(most_new_contacts(part));
  const SegmentView contacts = view(part, rows);
  ContactTask task{.inner = part.inner.view(),
                   .inner_count = part.inner.count,
                   .slots_begin = begin,
                   .slots_end = end,
                   .loads = loads.rows,
                   .touching = part.touching.data(),
                   .free = part.histories.free.data(),
                   .free_count = part.histories.free_count,
                   .halo = part.halo.data(),
                   .halo_count = 0,
                   .contacts = 0,
                   .account = part.sums.account,
                   .power = {},
                   .wall_force = {},
                   .wall_moment = {},
                   .deepest = part.deepest};
  kernel_->pairs(contacts, task);
  touch_walls(part, contacts, time, task);
  part.histories.free_count = task.free_count;
  part.deepest = task.deepest;
  part.sums = {.contacts = task.contacts, .account = task.account, .power = task.power};
  sort_halo(k, task.halo_count);
}

void Contacts::sort_halo(int k, std::int32_t count) {
  Part& part = parts_[k];
  for (const int target : reach_.reached(k)) part.halo_of_part[target].clear();
  for (std::int32_t n = 0; n < count; ++n) part.halo_of_part[parts().of(part.halo[n].slot)].push_back(n);
}

void Contacts::work_out(const SphereStorage& rows, double time, ForceBuffers& loads, ThreadPool& pool) {
  pool.parallel_for(parts().count(),
                    [&](int k, int thread) { work_out(k, rows, time, loads.take(k, thread)); });
  pool.parallel_for(parts().count(), [&](int k, int) { reduce_halo_forces(k, loads.of(k)); });
  end_forces(time);
}

void Contacts::reduce_halo_forces(int k, LoadRange loads) {
  for (const int from : reach_.dependencies(k)) {
    const Part& other = parts_[from];
    for (const std::int32_t n : other.halo_of_part[k]) {
      const HaloForce& later = other.halo[n];
      double* load = loads.rows + (later.slot - loads.first) * load_size;
      for (int c = 0; c < 6; ++c) load[c] += later.load[c];
    }
  }
}

double Contacts::deepest() const { return std::ranges::max_element(parts_, {}, &Part::deepest)->deepest; }

void Contacts::set_deepest(double overlap) {
  for (Part& part : parts_) part.deepest = 0;
  parts_[0].deepest = overlap;
}

std::int64_t Contacts::touching() const {
  std::int64_t sum = 0;
  for (const Part& part : parts_) sum += part.sums.contacts;
  return sum;
}

}  // namespace fiberchain::dem
