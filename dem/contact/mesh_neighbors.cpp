#include "dem/contact/mesh_neighbors.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "dem/contact/walk_rebuilt.hpp"
#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {
namespace {

/// How much farther than touching inner triangles may be, over the radius: with more they are many, with less
/// chosen often.
constexpr double inner_margin = 0.02;
/// How far from where a place was not flat, or flat not so far, it is tried again, over the radius.
constexpr double flat_tried_again = 0.002;
/// A way is a sum: over the radius, what it may be off by round-off, with much to spare.
constexpr double slack = 1e-7;
/// Cosine of the angle by which a contact turns at most as its history is handed on from feature to feature.
constexpr double handed_on_cosine = 0.866;

/// By how many spheres triangles are fetched before they are looked at.
constexpr std::size_t ahead = 5;

constexpr double whenever = -std::numeric_limits<double>::infinity();

/// Fetches what is read of some triangles soon. Inlined before the compiler asks what a function does: one
/// that only fetches does nothing, and its calls are dropped.
inline __attribute__((always_inline)) void fetch(const TriangleMesh& mesh,
                                                 std::span<const std::int32_t> triangles) {
  for (const std::int32_t t : triangles) {
    const auto* plane = reinterpret_cast<const char*>(&mesh.planes[t]);
    __builtin_prefetch(plane), __builtin_prefetch(plane + sizeof(TrianglePlane) - 1);
    __builtin_prefetch(&mesh.edges_of[t]);
  }
}

}  // namespace

void MeshNeighbors::List::clear() {
  slots.clear(), triangles.clear(), inner.clear(), inner_count.clear();
  chosen_at.clear(), clearance.clear(), flat.clear(), asleep_until.clear();
  begin.assign(1, 0);
}

void MeshNeighbors::List::append(std::int32_t slot, std::span<const std::int32_t> near) {
  slots.push_back(slot);
  triangles.insert(triangles.end(), near.begin(), near.end());
  inner.resize(triangles.size());
  begin.push_back(triangles.size());
  inner_count.push_back(-1);
  chosen_at.emplace_back(), clearance.push_back(0), flat.emplace_back();
  asleep_until.push_back(whenever);
}

void MeshNeighbors::List::append(const List& other, std::size_t n) {
  append(other.slots[n], other.triangles_of(n));
  std::copy_n(other.inner.begin() + static_cast<std::ptrdiff_t>(other.begin[n]),
              std::max(other.inner_count[n], 0), inner.end() - std::ssize(other.triangles_of(n)));
  inner_count.back() = other.inner_count[n];
  chosen_at.back() = other.chosen_at[n], clearance.back() = other.clearance[n], flat.back() = other.flat[n];
  asleep_until.back() = other.asleep_until[n];
}

std::span<const std::int32_t> MeshNeighbors::List::triangles_of(std::size_t n) const {
  return std::span(triangles).subspan(begin[n], begin[n + 1] - begin[n]);
}

std::span<const std::int32_t> MeshNeighbors::List::inner_of(std::size_t n) const {
  return std::span(inner).subspan(begin[n], std::max(inner_count[n], 0));
}

void MeshNeighbors::clear() { list_.clear(); }

bool MeshNeighbors::has(std::int32_t sphere) const { return std::ranges::binary_search(list_.slots, sphere); }

void MeshNeighbors::update(const std::vector<std::int32_t>& rebuilt, const FindTriangles& find,
                           MeshNeighbors& scratch) {
  List& next = scratch.list_;
  next.clear();
  const auto keep = [&](std::size_t p) { next.append(list_, p); };
  walk_rebuilt(list_.slots, rebuilt, keep, [&](std::int32_t i, std::optional<std::size_t>) {
    asked_.clear();
    find(i, asked_);
    if (asked_.empty()) return;
    std::ranges::sort(asked_);
    next.append(i, asked_);
  });
  std::swap(list_, next);
}

void MeshNeighbors::choose_inner(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center,
                                 double reach, double margin) {
  double least = std::numeric_limits<double>::infinity();
  const double within = reach + margin;
  std::int32_t* to = list_.inner.data() + list_.begin[n];
  for (const std::int32_t t : list_.triangles_of(n)) {
    double squared = squared_distance_bound(mesh, t, center);
    if (squared < within * within) squared = closest_point(mesh, t, center).squared;
    least = std::min(least, squared);
    if (squared < within * within) *to++ = t;
  }
  list_.inner_count[n] = static_cast<std::int32_t>(to - (list_.inner.data() + list_.begin[n]));
  list_.clearance[n] = std::sqrt(least) - reach;
}

void MeshNeighbors::choose(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center,
                           double reach, double margin) {
  list_.chosen_at[n] = center;
  list_.flat[n] =
      flat_place(mesh, list_.triangles_of(n), center, reach, std::numeric_limits<double>::infinity());
  list_.inner_count[n] = -1, list_.clearance[n] = 0;
  if (!(list_.flat[n].margin > margin)) choose_inner(n, mesh, center, reach, margin);
}

std::optional<double> MeshNeighbors::find_flat(std::size_t n, const MeshMoment& moment,
                                               const Vec<double, 3>& center, double reach) {
  const FlatPlace& flat = list_.flat[n];
  const Vec<double, 3> way = center - flat.center;
  const double gone_squared = dot(way, way);
  if (!(gone_squared < flat.margin * flat.margin)) return {};
  const double height = height_over(flat, center);
  if (!is_told_by(flat, moment.mesh.sides, height, reach)) return {};
  found_.contacts.clear();
  const double clear_for = std::abs(height) - reach;
  if (clear_for >= 0) return std::min(clear_for, flat.margin - std::sqrt(gone_squared));
  found_.contacts.push_back(contact_at(flat, height));
  return clear_for;
}

double MeshNeighbors::look(std::size_t n, const MeshMoment& moment, const Vec<double, 3>& center,
                           double radius, bool held) {
  const TriangleMesh& mesh = *moment.mesh.mesh;
  const double reach = radius + moment.gap, margin = inner_margin * radius;
  if (const auto clear_for = find_flat(n, moment, center, reach)) return *clear_for;
  double gone = norm(center - list_.chosen_at[n]);
  const auto is_clear = [&] { return gone < list_.clearance[n]; };
  if (list_.inner_count[n] < 0 || (!(gone < margin) && !is_clear())) {
    choose(n, mesh, center, reach, margin);
    gone = 0;
    if (const auto clear_for = find_flat(n, moment, center, reach)) return *clear_for;
    if (list_.inner_count[n] < 0) choose_inner(n, mesh, center, reach, margin);
  }
  found_.contacts.clear();
  if (is_clear()) return list_.clearance[n] - gone;
  if (norm(center - list_.flat[n].center) > flat_tried_again * radius) {
    list_.flat[n] = flat_place(mesh, list_.inner_of(n), center, reach, margin - gone);
    if (const auto clear_for = find_flat(n, moment, center, reach)) return *clear_for;
  }
  const double least =
      find_mesh_contacts(mesh, moment.mesh.sides, list_.inner_of(n), center, reach, held, found_);
  return std::min(least - reach, margin - gone);  // others were farther than the margin
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
    MeshContact& own = all_.emplace_back();
    own.direction = mesh.to_space(contact.direction), own.distance = contact.distance;
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
  awake_.clear();
  for (std::size_t n = 0; n < list_.slots.size(); ++n) {
    if (!(moment.moved < list_.asleep_until[n])) awake_.push_back(n);
  }
  for (std::size_t k = 0; k < awake_.size(); ++k) {
    if (k + ahead < awake_.size()) {
      const std::size_t later = awake_[k + ahead];
      __builtin_prefetch(moment.rows.position_radius.data() + list_.slots[later] * position_radius_size);
      if (list_.flat[later].margin == 0) fetch(*moment.mesh.mesh, list_.inner_of(later));
    }
    const std::size_t n = awake_[k];
    const std::int32_t slot = list_.slots[n];
    give_back_until(slot);
    const std::size_t from = p;
    bool held = false;
    for (; p < last_.count && last_.slots[p] == slot; ++p)
      held = held || (last_.contact[p] != 0 && !moment.mesh.mesh->is_rim(last_.features[p]));
    const Vec<double, 3> center = moment.mesh.to_mesh(moment.rows.position(slot));
    const double radius = moment.rows.radius(slot), clear_for = look(n, moment, center, radius, held);
    list_.asleep_until[n] = moment.moved - slack * radius + clear_for;
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
