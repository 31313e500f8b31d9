#include "dem/contact/neighbor_list.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Displacement of a sphere since it was sorted that the cells allow, over its reach.
constexpr double kSlack = 0.5;

}  // namespace

NeighborList::NeighborList(SphereSet spheres, double skin, Partition parts, const ContactKernel& kernel)
    : spheres_(std::move(spheres)),
      skin_(skin),
      parts_(std::move(parts)),
      searches_(parts_.count()),
      incoming_(parts_.count()),
      kernel_(&kernel) {}

void NeighborList::build(std::vector<Vec<double, 3>> positions, ThreadPool& pool) {
  reference_positions_ = std::move(positions);
  rebuilt_.assign(reference_positions_.size(), 1);
  for (int k = 0; k < parts_.count(); ++k) {
    searches_[k].rebuilt.clear();
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) searches_[k].rebuilt.push_back(i);
  }
  check_finite();
  sort();
  search(pool);
}

double NeighborList::farthest_moved(const SphereStorage& rows, ThreadPool& pool) const {
  std::vector<double> squared(searches_.size(), 0);
  pool.parallel_for(parts_.count(), [&](int k, int) {
    double farthest = 0;
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) {
      const Vec<double, 3> moved = rows.position(i) - reference_positions_[i];
      farthest = std::max(farthest, dot(moved, moved));
    }
    squared[k] = farthest;
  });
  return std::sqrt(*std::ranges::max_element(squared));
}

void NeighborList::update(const SphereStorage& rows, double distance, ThreadPool& pool) {
  std::vector<std::uint8_t> strayed(searches_.size(), 0);
  pool.parallel_for(parts_.count(), [&](int k, int) {
    std::vector<std::int32_t>& rebuilt = searches_[k].rebuilt;
    rebuilt.clear();
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) {
      const Vec<double, 3> position = rows.position(i), moved = position - reference_positions_[i];
      rebuilt_[i] = dot(moved, moved) > distance * distance ? 1 : 0;
      if (rebuilt_[i] == 0) continue;
      rebuilt.push_back(i);
      reference_positions_[i] = position;
      sorted_->move(i, position);
      if (!(sorted_->distance_from_first(i, position) <= slack_)) strayed[k] = 1;
    }
  });
  check_finite();
  if (std::ranges::count(strayed, 1) > 0) sort();
  search(pool);
}

void NeighborList::check_finite() const {
  for (const Search& search : searches_) {
    for (const std::int32_t i : search.rebuilt) {
      const Vec<double, 3>& x = reference_positions_[i];
      if (!std::isfinite(x[0] + x[1] + x[2])) {
        throw InvalidInput(fmt::format("the position of sphere {} is not finite", i));
      }
    }
  }
}

void NeighborList::sort() {
  const double reach = 2 * *std::ranges::max_element(spheres_.radius) + skin_;
  check_minimum_image(spheres_.period, reach);
  Box box = box_around(reference_positions_);
  for (int c = 0; c < 3; ++c) {
    if (spheres_.period[c] > 0) box.low[c] = 0;
  }
  slack_ = kSlack * reach;
  const CellGeometry cells(box, spheres_.period, reach + slack_,
                           64.0 * static_cast<double>(reference_positions_.size()) + 64);
  sorted_.emplace(cells, reference_positions_, spheres_.radius, spheres_.fiber);
}

void NeighborList::search(ThreadPool& pool) {
  pool.parallel_for(parts_.count(), [&](int k, int) { search(k); });
  collect_incoming();
}

/// A part has pairs of a few neighboring parts only: one pass over these runs is linear in the parts.
void NeighborList::collect_incoming() {
  for (auto& incoming : incoming_) incoming.clear();
  for (int k = 0; k < parts_.count(); ++k) {
    const std::vector<Pair>& pairs = searches_[k].earlier;
    for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
      const int part = parts_.of(pairs[begin].first);
      const Pair behind{parts_.end(part), 0};
      end = static_cast<std::size_t>(
          std::lower_bound(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end(), behind) -
          pairs.begin());
      incoming_[part].push_back({k, begin, end});
    }
  }
}

void NeighborList::search(int part) {
  Search& own = searches_[part];
  own.own.clear(), own.earlier.clear();
  const SortedSpheres all = sorted_->view();
  NeighborQuery query{};
  query.periods = periodic_box(spheres_.period);
  SlotRange runs[SortedCells::most_runs];
  int count = 0;
  std::int32_t last_cell = -1;
  std::vector<std::int32_t> near;
  const std::int32_t begin = parts_.begin(part);
  for (const std::int32_t i : own.rebuilt) {
    const Vec<double, 3>& position = reference_positions_[i];
    if (const std::int32_t cell = sorted_->cell_of(position); cell != last_cell) {
      last_cell = cell;
      count = sorted_->runs_around(position, runs);
      std::size_t most = 0;
      for (int k = 0; k < count; ++k) most += runs[k].end - runs[k].begin;
      if (near.size() < most) near.resize(2 * most);
    }
    std::copy_n(position.c, 3, query.x);
    query.reach = spheres_.radius[i] + skin_;
    query.sphere = i, query.fiber = spheres_.fiber[i];
    const std::int32_t found = kernel_->query_neighbors(all, runs, count, query, near.data());
    for (std::int32_t n = 0; n < found; ++n) {
      const std::int32_t j = near[n];
      if (j > i) {
        own.own.push_back({i, j});
      } else if (rebuilt_[j] == 0) {  // otherwise found from there
        (j >= begin ? own.own : own.earlier).push_back({j, i});
      }
    }
  }
  std::ranges::sort(own.earlier);
}

std::vector<Pair> NeighborList::found(int part) const {
  std::vector<Pair> pairs = searches_[part].own;
  for (const Incoming& from : incoming_[part]) {
    const auto first = searches_[from.part].earlier.begin();
    pairs.insert(pairs.end(), first + static_cast<std::ptrdiff_t>(from.begin),
                 first + static_cast<std::ptrdiff_t>(from.end));
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace fiberchain::dem
