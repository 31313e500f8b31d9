#include "dem/contact/ridge_neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dem/contact/laws/smooth_hertz.hpp"
#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {
namespace {

/// Cosine of the angle by which a contact turns at most as its history is handed on.
constexpr double ridge_turn_cosine = 0.866;

}  // namespace

SegmentNodes<double> nodes_in_mesh(const FiberBodies& bodies, const SphereStorage& rows,
                                   const MeshShape& mesh, std::int32_t body) {
  return bodies.nodes(body, [&](std::int64_t sphere) { return mesh.to_mesh(rows.position(sphere)); });
}

void RidgeContacts::clear() {
  bodies.clear(), features.clear(), contact.clear(), places.clear(), shares.clear(), nearest.clear();
  count = 0;
}

void RidgeContacts::insert(std::int32_t body, std::int32_t feature, std::int32_t number) {
  std::size_t at = 0;
  while (at < count && std::pair(bodies[at], features[at]) < std::pair(body, feature)) ++at;
  const auto offset = static_cast<std::ptrdiff_t>(at);
  bodies.insert(bodies.begin() + offset, body);
  features.insert(features.begin() + offset, feature);
  contact.insert(contact.begin() + offset, number);
  ++count;
}

void RidgeNeighbors::clear() { list_.clear(), edges_.clear(); }

bool RidgeNeighbors::has(std::int32_t body) const {
  return std::ranges::binary_search(list_, body, {}, &Listed::body);
}

void RidgeNeighbors::update(const std::vector<std::int32_t>& rebuilt, const FindRidges& find,
                            RidgeNeighbors& scratch) {
  scratch.clear();
  const auto append = [&](Listed listed, std::span<const std::int32_t> edges) {
    listed.begin = scratch.edges_.size();
    scratch.edges_.insert(scratch.edges_.end(), edges.begin(), edges.end());
    listed.end = scratch.edges_.size();
    scratch.list_.push_back(listed);
  };
  std::size_t p = 0;
  const auto keep_until = [&](std::int32_t body) {
    for (; p < list_.size() && list_[p].body < body; ++p)
      append(list_[p], std::span(edges_).subspan(list_[p].begin, list_[p].end - list_[p].begin));
  };
  for (const std::int32_t body : rebuilt) {
    keep_until(body);
    if (p < list_.size() && list_[p].body == body) ++p;
    asked_.clear();
    find(body, asked_);
    if (!asked_.empty()) append({body, 0, 0}, asked_);
  }
  if (!list_.empty()) keep_until(list_.back().body + 1);
  std::swap(list_, scratch.list_);
  std::swap(edges_, scratch.edges_);
}

void RidgeNeighbors::look(Listed& listed, const RidgeMoment& moment) {
  found_.clear();
  const SegmentNodes<double> segment = nodes_in_mesh(moment.bodies, moment.rows, moment.mesh, listed.body);
  const double gone =
      std::max(norm(segment.begin - listed.looked_at[0]), norm(segment.end - listed.looked_at[1]));
  if (gone < listed.clearance) return;
  const TriangleMesh& mesh = *moment.mesh.mesh;
  const double least = find_ridge_points(mesh, moment.ridges, moment.mesh.sides,
                                         std::span(edges_).subspan(listed.begin, listed.end - listed.begin),
                                         segment, segment.radius, found_);
  listed.looked_at[0] = segment.begin, listed.looked_at[1] = segment.end;
  listed.clearance = least - (1 + 1e-9) * segment.radius;
  if (found_.empty()) return;
  std::size_t first[2];
  for (const int n : {0, 1})
    first[n] = near_node(n == 0 ? listed.body : moment.bodies.end[listed.body], ends_[n]);
  share_out(mesh, segment, {ends_[0], ends_[1]}, found_);
  for (const int n : {0, 1}) {
    for (std::size_t k = 0; k < ends_[n].size(); ++k) {
      const std::int32_t row = near_[first[n] + k].row;
      if (row < 0) continue;
      node_rows_.shares[row] = std::min(node_rows_.shares[row], ends_[n][k].share);
    }
  }
}

std::size_t RidgeNeighbors::near_node(std::int32_t node, std::vector<NodeContact>& all) const {
  all.clear();
  const auto first = std::ranges::lower_bound(near_, node, {}, &NearNode::node);
  for (auto at = first; at != near_.end() && at->node == node; ++at) all.push_back(at->contact);
  return first - near_.begin();
}

void RidgeNeighbors::sort_nodes(const RidgeMoment& moment, ContactHistories& histories) {
  WallNeighbors& list = moment.nodes;
  near_.clear();
  const std::size_t row = list.nearest.size() / 4;
  std::size_t kept = 0;
  for (std::size_t n = 0; n < list.count; ++n) {
    const std::int32_t node = list.slots[n];
    const auto number = [&](std::size_t c) -> double& { return list.nearest[c * row + n]; };
    const Vec<double, 3> direction = moment.mesh.into_mesh({number(0), number(1), number(2)}),
                         place = moment.mesh.to_mesh(moment.rows.position(node));
    const double distance = number(3);
    const bool touches = distance < moment.rows.radius(node);
    near_.push_back({node,
                     touches ? static_cast<std::int32_t>(kept) : -1,
                     {list.features[n], direction, place + distance * direction, distance}});
    if (!touches) {
      if (list.contact[n] != 0) histories.give_back(list.contact[n]);
      continue;
    }
    list.slots[kept] = node, list.features[kept] = list.features[n], list.contact[kept] = list.contact[n];
    for (std::size_t c = 0; c < 4; ++c) list.nearest[c * row + kept] = number(c);
    ++kept;
  }
  for (std::size_t n = kept; n < list.count; ++n) list.contact[n] = 0;
  list.count = kept;
}

void RidgeNeighbors::begin_rows(const RidgeMoment& moment, ContactHistories& histories) {
  WallNeighbors& list = moment.nodes;
  const std::size_t padded = list.slots.size();
  node_rows_.bodies.assign(padded, 0);
  node_rows_.places.assign(padded, 0), node_rows_.shares.assign(padded, 1);
  for (std::size_t n = 0; n < padded; ++n) {
    if (n >= list.count) {
      node_rows_.bodies[n] = node_rows_.bodies[0];
      list.nearest[3 * padded + n] = 1e30;
      continue;
    }
    // the last node of a fiber is the end of a segment
    const std::int32_t node = list.slots[n];
    const bool last = moment.bodies.is_none(node);
    node_rows_.bodies[n] = last ? node - 1 : node, node_rows_.places[n] = last ? 1 : 0;
    if (list.contact[n] != 0) continue;
    histories.reserve(1);
    list.contact[n] = histories.take();
    histories.put(list.contact[n], {});
  }
}

void RidgeNeighbors::add_found(std::int32_t body, const RidgeMoment& moment) {
  for (RidgePoint point : found_) {
    if (point.share < least_share) continue;
    contacts_.bodies.push_back(body);
    contacts_.features.push_back(point.feature);
    contacts_.contact.push_back(0);
    contacts_.places.push_back(point.place);
    contacts_.shares.push_back(point.share);
    point.direction = moment.mesh.to_space(point.direction);
    all_.push_back(point);
  }
}

Vec<double, 3> RidgeNeighbors::direction_of(const RidgeContacts& from, std::size_t n,
                                            const RidgeMoment& moment) const {
  const SegmentNodes<double> segment = nodes_in_mesh(moment.bodies, moment.rows, moment.mesh, from.bodies[n]);
  return moment.mesh.to_space(ridge_point(*moment.mesh.mesh, from.features[n], segment).direction);
}

std::int32_t RidgeNeighbors::ended_like(std::size_t n, const RidgeMoment& moment) {
  std::size_t best = last_.count;
  double closest = ridge_turn_cosine;
  for (std::size_t p = 0; p < last_.count; ++p) {
    if (last_.contact[p] == 0 || last_.bodies[p] != contacts_.bodies[n]) continue;
    const double cosine = dot(direction_of(last_, p, moment), all_[n].direction);
    if (cosine > closest) closest = cosine, best = p;
  }
  return best < last_.count ? std::exchange(last_.contact[best], 0) : 0;
}

std::int32_t RidgeNeighbors::lender(std::size_t n, const RidgeMoment& moment,
                                    const ContactHistories& histories) const {
  std::int32_t best = 0;
  double deepest = 0;
  const auto consider = [&](std::int32_t contact) {
    if (contact == 0) return;
    const double depth = histories.rows.data()[static_cast<std::ptrdiff_t>(contact) * contact_history_size +
                                               SmoothHertz::sqrt_overlap_at];
    if (depth > deepest) deepest = depth, best = contact;
  };
  const std::int32_t body = contacts_.bodies[n];
  const WallNeighbors& nodes = moment.nodes;
  const std::size_t row = nodes.nearest.size() / 4;
  for (std::size_t k = 0; k < nodes.count; ++k) {
    if (nodes.slots[k] != body && nodes.slots[k] != moment.bodies.end[body]) continue;
    const Vec<double, 3> direction{nodes.nearest[k], nodes.nearest[row + k], nodes.nearest[2 * row + k]};
    if (dot(direction, all_[n].direction) > ridge_turn_cosine) consider(nodes.contact[k]);
  }
  const auto beside = [&](const RidgeContacts& some) {
    for (std::size_t p = 0; p < some.count; ++p) {
      if (some.contact[p] == 0 || std::abs(some.bodies[p] - body) > 1) continue;
      const Vec<double, 3> direction =
          &some == &contacts_ ? all_[p].direction : direction_of(some, p, moment);
      if (dot(direction, all_[n].direction) > ridge_turn_cosine) consider(some.contact[p]);
    }
  };
  beside(contacts_), beside(last_);
  return best;
}

void RidgeNeighbors::keep_histories(const RidgeMoment& moment, ContactHistories& histories) {
  std::size_t p = 0;
  const auto key = [](const RidgeContacts& from, std::size_t n) {
    return std::pair(from.bodies[n], from.features[n]);
  };
  for (std::size_t n = 0; n < contacts_.count; ++n) {
    while (p < last_.count && key(last_, p) < key(contacts_, n)) ++p;
    if (p < last_.count && key(last_, p) == key(contacts_, n))
      contacts_.contact[n] = std::exchange(last_.contact[p], 0);
  }
  for (std::size_t n = 0; n < contacts_.count; ++n) {
    if (contacts_.contact[n] == 0) contacts_.contact[n] = ended_like(n, moment);
  }
  std::vector<std::pair<std::size_t, std::int32_t>> begun;  // of contacts that were there: not of one another
  for (std::size_t n = 0; n < contacts_.count; ++n) {
    if (contacts_.contact[n] == 0) begun.emplace_back(n, lender(n, moment, histories));
  }
  for (const auto& [n, from] : begun) {
    SavedContact history{};
    if (from != 0) {
      history = histories.at(from, {});
      history.history[SmoothHertz::rolling_power_at] = 0;
      history.history[SmoothHertz::share_less_one_at] = -1;
      std::fill_n(history.work, contact_account_size, 0.0);
    }
    histories.reserve(1);
    contacts_.contact[n] = histories.take();
    histories.put(contacts_.contact[n], history);
  }
  for (std::size_t n = 0; n < last_.count; ++n) {
    if (last_.contact[n] != 0) histories.give_back(last_.contact[n]);
  }
}

void RidgeNeighbors::find_contacts(const RidgeMoment& moment, int width, ContactHistories& histories) {
  std::swap(last_, contacts_);
  contacts_.clear(), all_.clear();
  sort_nodes(moment, histories);
  begin_rows(moment, histories);
  for (Listed& listed : list_) {
    look(listed, moment);
    add_found(listed.body, moment);
  }
  contacts_.count = contacts_.bodies.size();
  if (contacts_.count + last_.count == 0) return;
  keep_histories(moment, histories);
  const std::size_t padded = whole_vectors(contacts_.count, width);
  contacts_.nearest.assign(4 * padded, 0.0);
  for (std::size_t n = 0; n < padded; ++n) {
    // pads have no direction and touch nothing
    contacts_.nearest[3 * padded + n] = n < all_.size() ? all_[n].distance : 1e30;
    for (int c = 0; c < 3 && n < all_.size(); ++c) contacts_.nearest[c * padded + n] = all_[n].direction[c];
  }
  for (std::vector<std::int32_t>* numbers : {&contacts_.bodies, &contacts_.features})
    numbers->resize(padded, numbers->empty() ? 0 : numbers->front());
  contacts_.contact.resize(padded, 0);
  contacts_.places.resize(padded, 0), contacts_.shares.resize(padded, 0);
}

}  // namespace fiberchain::dem
