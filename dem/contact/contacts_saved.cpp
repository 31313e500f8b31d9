#include <algorithm>

#include "dem/contact/contacts.hpp"

// Contacts one by one: saved, restored, reported.
namespace fiberchain::dem {

std::vector<ContactPlace> Contacts::places() const {
  std::vector<ContactPlace> all;
  each_place([&](const ContactPlace& place) { all.push_back(place); });
  std::ranges::sort(all, [](const ContactPlace& a, const ContactPlace& b) {
    return a.part != b.part ? a.part < b.part : a.key < b.key;
  });
  return all;
}

std::vector<SavedContact> Contacts::saved() const {
  std::vector<SavedContact> all;
  for (const ContactPlace& place : places()) all.push_back(saved(place));
  return all;
}

void Contacts::reorder_rows(const std::vector<std::int32_t>& new_row, const SphereStorage& rows, double time,
                            ThreadPool& pool) {
  std::vector<SavedContact> contacts = saved();
  for (SavedContact& c : contacts) {
    c.key.first.number = new_row[c.key.first.number];
    if (!is_of_fiber(c.key.second)) continue;
    c.key.second.number = new_row[c.key.second.number];
    // bodies are known by their new rows already
    for (Primitive* body : {&c.key.first, &c.key.second}) *body = fiber_bodies_.primitive(body->number);
    if (c.key.first.number > c.key.second.number) exchange_bodies(c);
  }
  for (auto& [key, share] : shares_before_) {
    for (Primitive* body : {&key.first, &key.second}) {
      if (is_of_fiber(*body)) *body = fiber_bodies_.primitive(new_row[body->number]);
    }
    if (is_of_fiber(key.second) && key.first.number > key.second.number) std::swap(key.first, key.second);
  }
  std::ranges::sort(shares_before_);
  std::ranges::sort(contacts, {}, &SavedContact::key);
  clear();
  rebuild_neighbor_list(rows, time, pool);
  restore(contacts);
}

void Contacts::exchange_bodies(SavedContact& contact) const {
  std::swap(contact.key.first, contact.key.second);
  law_->exchange_bodies(contact.history);
  // of the account: forces and moments on the first body
  for (int n = 1; n < 7; ++n) contact.work[n] = -contact.work[n];
}

double Contacts::cross_part_fraction() const {
  std::size_t across = 0, all = 0;
  for (const Part& part : parts_) across += part.pairs.across, all += part.pairs.count;
  return all > 0 ? static_cast<double>(across) / static_cast<double>(all) : 0;
}

double Contacts::cross_part_fraction(const std::vector<std::int32_t>& new_row) const {
  std::size_t across = 0, all = 0;
  for (const Part& part : parts_) {
    all += part.pairs.count;
    for (std::size_t p = 0; p < part.pairs.count; ++p)
      across += parts().of(new_row[part.pairs.first[p]]) != parts().of(new_row[part.pairs.second[p]]) ? 1 : 0;
  }
  return all > 0 ? static_cast<double>(across) / static_cast<double>(all) : 0;
}

void Contacts::clear() {
  for (Part& part : parts_) {
    part.inner.stale = true;
    part.histories.reset();
    std::ranges::fill(part.pairs.contact, 0);
    for (std::size_t w = 0; w < part.walls.size(); ++w) {
      std::ranges::fill(part.walls[w].contact, 0);
      if (is_mesh(w)) part.walls[w] = {};
      if (has_ridges(w)) part.ridges[w].contacts().clear();
    }
  }
}

void Contacts::restore(const std::vector<SavedContact>& contacts) {
  for (const SavedContact& contact : contacts) {
    const std::int64_t first = contact.key.first.number, second = contact.key.second.number;
    Part& part = parts_[neighbors_.parts().of(static_cast<std::int32_t>(first))];
    part.inner.stale = true;
    if (is_facet(contact.key.second) && !is_sphere(contact.key.first)) {
      put_ridge_contact(part, contact);
      continue;
    }
    if (is_facet(contact.key.second) && is_mesh(second)) {
      put_mesh_contact(part, contact);
      continue;
    }
    part.histories.reserve(1);
    const auto put = [&](std::int32_t& number) {
      number = part.histories.take();
      part.histories.put(number, contact);
    };
    if (is_facet(contact.key.second)) {
      WallNeighbors& neighbors = part.walls[second];
      const auto end = neighbors.slots.begin() + static_cast<std::ptrdiff_t>(neighbors.count);
      const auto at = std::lower_bound(neighbors.slots.begin(), end, first);
      if (at != end && *at == first) put(neighbors.contact[at - neighbors.slots.begin()]);
    } else {
      PairList& pairs = part.pairs;
      const auto own = std::equal_range(
          pairs.first.begin(), pairs.first.begin() + static_cast<std::ptrdiff_t>(pairs.count), first);
      for (auto p = own.first; p != own.second; ++p) {
        const std::size_t n = p - pairs.first.begin();
        if (pairs.second[n] == second) put(pairs.contact[n]);
      }
    }
  }
}

const double* Contacts::parameters_of(const SavedContact& c) const {
  const std::size_t kind = kind_of_sphere_[c.key.first.number], size = law_->parameters_size;
  if (is_facet(c.key.second)) return wall_parameters(c.key.second.number, kind);
  return pair_parameters_.data() + (kind * bodies_.size() + kind_of_sphere_[c.key.second.number]) * size;
}

TouchingPair<double> Contacts::pair_at(const SavedContact& c, const std::vector<Wall>& walls,
                                       const SphereStorage& rows, double time, double& arm,
                                       Vec<double, 3>& center) const {
  if (fiber_bodies_.smooth && is_of_fiber(c.key.second)) return fiber_pair_at(c, rows, arm, center);
  if (!is_sphere(c.key.first)) return ridge_pair_at(c, walls, rows, time, arm, center);
  const std::int64_t first = c.key.first.number, second = c.key.second.number;
  center = rows.position(first);
  const Vec<double, 3> x = rows.position(first), v = rows.velocity(first), w = rows.spin(first);
  Vec<double, 3> other_velocity{}, other_spin{};
  TouchingPair<double> pair{};
  double other_arm = 0;
  if (is_facet(c.key.second)) {
    const Wall& wall = walls[second];
    const WallPose pose = pose_at(wall, time);
    const WallVelocity motion = velocity_at(wall, time - 0.5 * step_);
    const NearestPoint<double> nearest = is_mesh(second)
                                             ? mesh_at(wall, second, pose).nearest_of_feature(c.key.slot, x)
                                             : wall.shape.moved(pose).nearest(x);
    pair.normal = nearest.direction;
    arm = nearest.distance;
    other_velocity = motion.velocity + cross(motion.spin, x + arm * pair.normal - pose.center_now());
    other_spin = motion.spin;
  } else {
    const Vec<double, 3> r = nearest_image(periods_, rows.position(second) - x);
    pair.normal = (1 / norm(r)) * r;
    arm = norm(r) * radius_[first] / (radius_[first] + radius_[second]);
    other_arm = norm(r) - arm;
    other_velocity = rows.velocity(second);
    other_spin = rows.spin(second);
  }
  pair.overlap = law_->overlap(c.history);
  pair.velocity = other_velocity - v - cross(arm * w + other_arm * other_spin, pair.normal);
  pair.spin = other_spin - w;
  pair.mean_spin = 0.5 * (w + other_spin);
  return pair;
}

template <class History>
std::vector<ContactState> Contacts::forces(const std::vector<Wall>& walls, const SphereStorage& rows,
                                           double time, double step, const History& history_before) const {
  std::vector<ContactState> all;
  for (const SavedContact& now : saved()) {
    double arm;
    Vec<double, 3> center;
    const TouchingPair<double> pair = pair_at(now, walls, rows, time, arm, center);
    SavedContact before = history_before(now);
    if (fiber_bodies_.smooth) set_shares(before, now);
    const ContactAction<double> action = law_->act(parameters_of(now), pair, step, before.history);
    all.push_back({now.key, pair.overlap, center + arm * pair.normal, pair.normal, action.force});
  }
  return all;
}

std::vector<ContactState> Contacts::states(const SphereStorage& rows, double time) const {
  return forces(domain_.walls, rows, time, 0, [](const SavedContact& now) { return now; });
}

std::vector<ContactState> Contacts::last_forces(ContactMemory before, const SphereStorage& rows,
                                                double time) const {
  std::ranges::sort(before.contacts, {}, &SavedContact::key);
  return forces(before.walls, rows, time, step_, [&](const SavedContact& now) {
    const auto found = std::ranges::lower_bound(before.contacts, now.key, {}, &SavedContact::key);
    const bool was = found != before.contacts.end() && found->key == now.key;
    if (was) return *found;
    // nothing is remembered of one that has begun, unless it goes on with another's history
    return fiber_bodies_.smooth ? handed_on(now.key, before.contacts) : SavedContact{now.key};
  });
}

}  // namespace fiberchain::dem
