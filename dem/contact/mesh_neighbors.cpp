#include "dem/contact/mesh_neighbors.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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

void MeshNeighbors::clear() {
  slots_.clear(), triangles_.clear(), inner_.clear(), inner_count_.clear();
  inner_until_.clear(), asleep_until_.clear();
  begin_.assign(1, 0);
}

bool MeshNeighbors::has(std::int32_t sphere) const {
  return std::binary_search(slots_.begin(), slots_.end(), sphere);
}

void MeshNeighbors::append(std::int32_t slot, std::span<const std::int32_t> triangles) {
  slots_.push_back(slot);
  triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
  begin_.push_back(triangles_.size());
  inner_count_.push_back(0);
  inner_until_.push_back(whenever), asleep_until_.push_back(whenever);
}

void MeshNeighbors::update(const std::vector<std::int32_t>& rebuilt, const FindTriangles& find,
                           MeshNeighbors& next) {
  next.clear();
  std::size_t p = 0;
  const auto keep = [&] {
    // inner triangles are chosen anew: at most once for each list
    next.append(slots_[p], std::span(triangles_).subspan(begin_[p], begin_[p + 1] - begin_[p]));
    next.asleep_until_.back() = asleep_until_[p];
    ++p;
  };
  for (const std::int32_t i : rebuilt) {
    while (p < slots_.size() && slots_[p] < i) keep();
    if (p < slots_.size() && slots_[p] == i) ++p;
    asked_.clear();
    find(i, asked_);
    if (asked_.empty()) continue;
    std::ranges::sort(asked_);
    next.append(i, asked_);
  }
  while (p < slots_.size()) keep();
  next.inner_.resize(next.triangles_.size());
  std::swap(slots_, next.slots_), std::swap(begin_, next.begin_);
  std::swap(triangles_, next.triangles_), std::swap(inner_, next.inner_);
  std::swap(inner_count_, next.inner_count_);
  std::swap(inner_until_, next.inner_until_), std::swap(asleep_until_, next.asleep_until_);
}

double MeshNeighbors::choose_inner(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center,
                                   double within) {
  double least = std::numeric_limits<double>::infinity();
  std::int32_t* to = inner_.data() + begin_[n];
  for (std::size_t k = begin_[n]; k < begin_[n + 1]; ++k) {
    const double squared = closest_point(mesh, triangles_[k], center).squared;
    least = std::min(least, squared);
    if (squared < within * within) *to++ = triangles_[k];
  }
  inner_count_[n] = static_cast<std::int32_t>(to - (inner_.data() + begin_[n]));
  return std::sqrt(least);
}

void MeshNeighbors::look(std::size_t n, const MeshMoment& moment, const Vec<double, 3>& center, double radius,
                         bool held) {
  const TriangleMesh& mesh = *moment.mesh.mesh;
  const double reach = radius + moment.gap, margin = inner_margin * radius,
               awake = moment.moved - slack * radius;
  if (!(moment.moved < inner_until_[n])) {
    const double least = choose_inner(n, mesh, center, reach + margin);
    inner_until_[n] = awake + margin;
    if (inner_count_[n] == 0) {
      inner_until_[n] = asleep_until_[n] = awake + (least - reach);
      found_.contacts.clear();
      return;
    }
  }
  const std::span<const std::int32_t> inner(inner_.data() + begin_[n], inner_count_[n]);
  const double least = find_mesh_contacts(mesh, moment.mesh.sides, inner, center, reach, held, found_);
  asleep_until_[n] = std::min(inner_until_[n], awake + (least - reach));
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
  for (std::size_t n = 0; n < slots_.size(); ++n) {
    if (moment.moved < asleep_until_[n]) continue;
    const std::int32_t slot = slots_[n];
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
