#include "dem/contact/mesh_neighbors.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "dem/contact/walk_rebuilt.hpp"
#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {
namespace {

/// How much farther than touching inner triangles may be, over the radius: with more they are many, with less
/// chosen often.
constexpr double inner_margin = 0.03;
/// A way is a sum: over the radius, what it may be off by round-off, with much to spare.
constexpr double slack = 1e-7;
/// Cosine of the angle by which a contact turns at most as its history is handed on from feature to feature.
constexpr double handed_on_cosine = 0.866;

constexpr double whenever = -std::numeric_limits<double>::infinity();

}  // namespace

void MeshNeighbors::List::clear() {
  slots.clear(), triangles.clear(), inner.clear(), inner_count.clear();
  inner_until.clear(), asleep_until.clear();
  begin.assign(1, 0);
}

void MeshNeighbors::List::append(std::int32_t slot, std::span<const std::int32_t> near) {
  slots.push_back(slot);
  triangles.insert(triangles.end(), near.begin(), near.end());
  begin.push_back(triangles.size());
  inner_count.push_back(0);
  inner_until.push_back(whenever), asleep_until.push_back(whenever);
}

std::span<const std::int32_t> MeshNeighbors::List::triangles_of(std::size_t n) const {
  return std::span(triangles).subspan(begin[n], begin[n + 1] - begin[n]);
}

void MeshNeighbors::clear() { list_.clear(); }

bool MeshNeighbors::has(std::int32_t sphere) const { return std::ranges::binary_search(list_.slots, sphere); }

void MeshNeighbors::update(const std::vector<std::int32_t>& rebuilt, const FindTriangles& find,
                           MeshNeighbors& scratch) {
  List& next = scratch.list_;
  next.clear();
  const auto keep = [&](std::size_t p) {
    // inner triangles are chosen anew: at most once for each list
    next.append(list_.slots[p], list_.triangles_of(p));
    next.asleep_until.back() = list_.asleep_until[p];
  };
  walk_rebuilt(list_.slots, rebuilt, keep, [&](std::int32_t i, std::optional<std::size_t>) {
    asked_.clear();
    find(i, asked_);
    if (asked_.empty()) return;
    std::ranges::sort(asked_);
    next.append(i, asked_);
  });
  next.inner.resize(next.triangles.size());
  std::swap(list_, next);
}

double MeshNeighbors::choose_inner(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center,
                                   double within) {
  double least = std::numeric_limits<double>::infinity();
  std::int32_t* to = list_.inner.data() + list_.begin[n];
  for (const std::int32_t t : list_.triangles_of(n)) {
    const double squared = closest_point(mesh, t, center).squared;
    least = std::min(least, squared);
    if (squared < within * within) *to++ = t;
  }
  list_.inner_count[n] = static_cast<std::int32_t>(to - (list_.inner.data() + list_.begin[n]));
  return std::sqrt(least);
}

void MeshNeighbors::look(std::size_t n, const MeshMoment& moment, const Vec<double, 3>& center, double radius,
                         bool held) {
  const TriangleMesh& mesh = *moment.mesh.mesh;
  const double reach = radius + moment.gap, margin = inner_margin * radius,
               awake = moment.moved - slack * radius;
  if (!(moment.moved < list_.inner_until[n])) {
    const double least = choose_inner(n, mesh, center, reach + margin);
    list_.inner_until[n] = awake + margin;
    if (list_.inner_count[n] == 0) {
      list_.inner_until[n] = list_.asleep_until[n] = awake + (least - reach);
      found_.contacts.clear();
      return;
    }
  }
  const std::span<const std::int32_t> inner(list_.inner.data() + list_.begin[n], list_.inner_count[n]);
  const double least = find_mesh_contacts(mesh, moment.mesh.sides, inner, center, reach, held, found_);
  list_.asleep_until[n] = std::min(list_.inner_until[n], awake + (least - reach));
}

std::int32_t MeshNeighbors::handed_on(const TriangleMesh& mesh, const MeshContact& contact,
                                      const Vec<double, 3>& center, std::size_t from, std::size_t to) {
  std::size_t best = to;
  double closest = handed_on_cosine;
  for (std::size_t p = from; p < to; ++p) {
    if (last_.contact[p] == 0) continue;
    const double cosine =
        dot(direction_of(mesh, closest_on_feature(mesh, last_.features[p], center)), contact.direction);
    if (cosine > closest) closest = cosine, best = p;
  }
  return best < to ? std::exchange(last_.contact[best], 0) : 0;
}

void MeshNeighbors::add_found(const MeshShape& mesh, std::int32_t slot, const Vec<double, 3>& center,
                              std::size_t from, std::size_t to, WallNeighbors& contacts,
                              ContactHistories& histories) {
  const std::size_t first = contacts.slots.size();
  std::size_t p = from;
  for (const MeshContact& contact : found_.contacts) {
    while (p < to && last_.features[p] < contact.feature) ++p;
    const bool same = p < to && last_.features[p] == contact.feature;
    contacts.slots.push_back(slot);
    contacts.features.push_back(contact.feature);
    contacts.contact.push_back(same ? std::exchange(last_.contact[p], 0) : 0);
    all_.push_back({contact.feature, mesh.to_space(contact.direction), contact.distance});
  }
  for (std::size_t n = first; n < contacts.slots.size() && from < to; ++n) {
    if (contacts.contact[n] == 0)
      contacts.contact[n] = handed_on(*mesh.mesh, found_.contacts[n - first], center, from, to);
  }
  for (p = from; p < to; ++p) {
    if (last_.contact[p] != 0) histories.give_back(last_.contact[p]);
  }
}

void MeshNeighbors::find_contacts(const MeshMoment& moment, int width, std::int32_t pad,
                                  WallNeighbors& contacts, ContactHistories& histories) {
  std::swap(last_, contacts);
  contacts.slots.clear(), contacts.contact.clear(), contacts.features.clear();
  all_.clear();
  std::size_t p = 0;
  const auto give_back_until = [&](std::int32_t slot) {
    for (; p < last_.count && last_.slots[p] < slot; ++p) {
      if (last_.contact[p] != 0) histories.give_back(last_.contact[p]);
    }
  };
  for (std::size_t n = 0; n < list_.slots.size(); ++n) {
    if (moment.moved < list_.asleep_until[n]) continue;
    const std::int32_t slot = list_.slots[n];
    give_back_until(slot);
    const std::size_t from = p;
    bool held = false;
    for (; p < last_.count && last_.slots[p] == slot; ++p)
      held = held || (last_.contact[p] != 0 && !moment.mesh.mesh->is_rim(last_.features[p]));
    const Vec<double, 3> center = moment.mesh.to_mesh(moment.rows.position(slot));
    look(n, moment, center, moment.rows.radius(slot), held);
    add_found(moment.mesh, slot, center, from, p, contacts, histories);
  }
  give_back_until(std::numeric_limits<std::int32_t>::max());
  contacts.count = contacts.slots.size();
  const std::size_t padded = whole_vectors(contacts.count, width);
  contacts.slots.resize(padded, pad), contacts.contact.resize(padded, 0), contacts.features.resize(padded, 0);
  contacts.nearest.assign(4 * padded, 0.0);
  for (std::size_t n = 0; n < all_.size(); ++n) {
    for (int c = 0; c < 3; ++c) contacts.nearest[c * padded + n] = all_[n].direction[c];
    contacts.nearest[3 * padded + n] = all_[n].distance;
  }
}

}  // namespace fiberchain::dem
