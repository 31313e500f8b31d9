#include "dem/contact/neighbor_list.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// For all spheres of some runs.
void make_room(std::span<const SlotRange> runs, std::vector<std::int32_t>& near) {
  std::size_t most = 0;
  for (const SlotRange& run : runs) most += run.end - run.begin;
  if (near.size() < most) near.resize(2 * most);
}

}  // namespace

NeighborList::NeighborList(SphereSet spheres, double skin, Partition parts, const ContactKernel& kernel)
    : spheres_(std::move(spheres)),
      skin_(skin),
      parts_(std::move(parts)),
      searches_(parts_.count()),
      incoming_(parts_.count()),
      kernel_(&kernel),
      periods_(periodic_box(spheres_.period)),
      sorted_(spheres_, skin) {}

void NeighborList::build(std::vector<Vec<double, 3>> positions, ThreadPool& pool) {
  reference_positions_ = std::move(positions);
  rebuilt_.assign(reference_positions_.size(), 1);
  for (int k = 0; k < parts_.count(); ++k) {
    searches_[k].rebuilt.clear();
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) searches_[k].rebuilt.push_back(i);
  }
  check_finite();
  check_minimum_image(spheres_.period, 2 * *std::ranges::max_element(spheres_.radius) + skin_);
  sorted_.sort(sorted_.all(), spheres_, reference_positions_);
  staying_ = 0;
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
  const auto bit_of = [&](std::int32_t i) { return 1u << sorted_.of(i); };
  pool.parallel_for(parts_.count(), [&](int k, int) {
    Search& own = searches_[k];
    own.rebuilt.clear();
    own.strayed = own.staying = 0;
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) {
      const Vec<double, 3> position = rows.position(i), moved = position - reference_positions_[i];
      rebuilt_[i] = dot(moved, moved) > distance * distance ? 1 : 0;
      if (rebuilt_[i] == 0) {
        own.staying |= bit_of(i);
        continue;
      }
      own.rebuilt.push_back(i);
      reference_positions_[i] = position;
      if (!sorted_.move(i, position)) own.strayed |= bit_of(i);
    }
  });
  check_finite();
  std::uint32_t strayed = 0;
  staying_ = 0;
  for (const Search& own : searches_) strayed |= own.strayed, staying_ |= own.staying;
  sorted_.sort(strayed, spheres_, reference_positions_);
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

struct NeighborList::Scratch {
  /// Runs around a cell: neighbors along a fiber are often in one.
  struct Around {
    std::int32_t cell = -1;
    int count = 0;
    SlotRange runs[SortedCells::most_runs];
  };
  std::vector<Around> around;  ///< of each class
  std::vector<SlotRange> within;
  std::vector<std::int32_t> near;  ///< spheres
};

template <class Found>
void NeighborList::query(std::int32_t i, int size_class, const SlotRange* runs, int count, Scratch& scratch,
                         const Found& found) const {
  NeighborQuery query{};
  query.periods = periods_;
  std::copy_n(reference_positions_[i].c, 3, query.x);
  query.reach = spheres_.radius[i] + skin_;
  query.sphere = i, query.fiber = spheres_.fiber[i];
  const std::int32_t near =
      kernel_->query_neighbors(sorted_.cells(size_class).view(), runs, count, query, scratch.near.data());
  for (std::int32_t n = 0; n < near; ++n) found(scratch.near[n]);
}

template <class Found>
void NeighborList::search_near(std::int32_t i, int size_class, Scratch& scratch, const Found& found) const {
  const SortedCells& cells = sorted_.cells(size_class);
  Scratch::Around& around = scratch.around[size_class];
  const std::int32_t cell = cells.cell_of(reference_positions_[i]);
  if (cell != around.cell) {
    around.cell = cell;
    around.count = cells.runs_around(reference_positions_[i], around.runs);
    make_room({around.runs, static_cast<std::size_t>(around.count)}, scratch.near);
  }
  if (around.count > 0) query(i, size_class, around.runs, around.count, scratch, found);
}

template <class Found>
void NeighborList::search_within(std::int32_t i, int size_class, Scratch& scratch, const Found& found) const {
  const double distance = sorted_.reach_into(size_class, spheres_.radius[i] + skin_);
  sorted_.cells(size_class).runs_within(reference_positions_[i], distance, scratch.within);
  make_room(scratch.within, scratch.near);
  query(i, size_class, scratch.within.data(), static_cast<int>(scratch.within.size()), scratch, found);
}

/// A pair of one class is found from its lower sphere, one of two from the smaller; where that one is not
/// searched, from the other.
void NeighborList::search(int part) {
  Search& own = searches_[part];
  own.own.clear(), own.earlier.clear();
  Scratch scratch;
  scratch.around.resize(sorted_.count());
  const std::int32_t begin = parts_.begin(part);
  for (const std::int32_t i : own.rebuilt) {
    const auto add = [&](std::int32_t j) {
      if (j > i) {
        own.own.push_back({i, j});
      } else {
        (j >= begin ? own.own : own.earlier).push_back({j, i});
      }
    };
    const auto add_lower = [&](std::int32_t j) {
      if (j > i || rebuilt_[j] == 0) add(j);
    };
    const auto add_smaller = [&](std::int32_t j) {
      if (rebuilt_[j] == 0) add(j);
    };
    const int size_class = sorted_.of(i);
    for (int k = 0; k < size_class; ++k) search_near(i, k, scratch, add);
    search_near(i, size_class, scratch, add_lower);
    for (int k = size_class + 1; k < sorted_.count(); ++k) {
      if ((staying_ >> k & 1) != 0) search_within(i, k, scratch, add_smaller);
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
