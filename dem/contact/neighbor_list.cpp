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

NeighborList::NeighborList(SphereSet bounds, double skin, Partition parts, const ContactKernel& kernel,
                           const FiberBodies& bodies)
    : NeighborList(std::move(bounds), skin, std::move(parts), kernel) {
  bodies_ = &bodies;
  spheres_.radius = bodies.radius;
}

SegmentNodes<double> NeighborList::reference_nodes(std::int32_t i) const {
  return bodies_->nodes(i, [&](std::int64_t sphere) { return reference_positions_[sphere]; });
}

/// Returns whether it is larger than it was sorted.
bool NeighborList::set_middle(std::int32_t i) {
  constexpr double larger = 1.02;  // than it is, so that a segment that is drawn out a little stays sorted
  if (bodies_->is_none(i)) {
    middles_[i] = reference_positions_[i];
    return false;
  }
  const Vec<double, 3>&begin = reference_positions_[i], &end = reference_positions_[bodies_->end[i]];
  middles_[i] = 0.5 * (begin + end);
  const double bound = 0.5 * norm(end - begin) + bodies_->radius[i];
  if (bound > bodies_->bound[i])
    throw InvalidInput(
        fmt::format("the segment behind sphere {} is drawn out to {:g} m", i, norm(end - begin)));
  if (bound <= spheres_.radius[i]) return false;
  spheres_.radius[i] = std::min(larger * bound, bodies_->bound[i]);
  return true;
}

bool NeighborList::are_close(std::int32_t i, std::int32_t j) const {
  if (bodies_->is_none(j)) return false;
  if (spheres_.fiber[i] == spheres_.fiber[j] && std::abs(i - j) <= bodies_->apart[i]) return false;
  const SegmentNodes<double> a = reference_nodes(i);
  SegmentNodes<double> b = reference_nodes(j);
  const Vec<double, 3> r = middles_[j] - middles_[i], nearest = nearest_image(periods_, r),
                       shift = nearest - r;
  const double reach = a.radius + b.radius + skin_;
  // the other's middle is no farther than from one of its ends
  const Vec<double, 3> d = a.end - a.begin;
  const double along = std::clamp(dot(nearest, d) / std::max(dot(d, d), 1e-290), -0.5, 0.5);
  const Vec<double, 3> beside = nearest - along * d;
  const double most = reach + spheres_.radius[j] - b.radius;
  if (dot(beside, beside) > most * most) return false;
  b.begin = b.begin + shift, b.end = b.end + shift;
  const ClosestPlaces<double> at = closest_places(a, b);
  const Vec<double, 3> between = separation(a, b, at.first, at.second);
  return dot(between, between) < reach * reach;
}

bool NeighborList::has_moved(const SphereStorage& rows, std::int32_t i, double distance) const {
  const Vec<double, 3> moved = rows.position(i) - reference_positions_[i];
  return dot(moved, moved) > distance * distance;
}

void NeighborList::build(std::vector<Vec<double, 3>> positions, ThreadPool& pool) {
  reference_positions_ = std::move(positions);
  rebuilt_.assign(reference_positions_.size(), 1);
  for (int k = 0; k < parts_.count(); ++k) {
    searches_[k].rebuilt.clear();
    for (std::int32_t i = parts_.begin(k); i < parts_.end(k); ++i) searches_[k].rebuilt.push_back(i);
  }
  check_finite();
  if (bodies_ != nullptr) {
    middles_.resize(reference_positions_.size());
    for (std::int32_t i = 0; i < std::ssize(middles_); ++i) set_middle(i);
  }
  check_minimum_image(spheres_.period, 2 * *std::ranges::max_element(spheres_.radius) + skin_);
  sorted_.sort(sorted_.all(), spheres_, places());
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
      const bool moved = has_moved(rows, i, distance);
      // a segment whose end has moved; that is of the same part and comes next
      const bool end_moved =
          bodies_ != nullptr && bodies_->end[i] > i && has_moved(rows, bodies_->end[i], distance);
      rebuilt_[i] = moved || end_moved ? 1 : 0;
      if (rebuilt_[i] == 0) {
        own.staying |= bit_of(i);
        continue;
      }
      own.rebuilt.push_back(i);
      if (moved) reference_positions_[i] = rows.position(i);
      if (bodies_ == nullptr && !sorted_.move(i, reference_positions_[i])) own.strayed |= bit_of(i);
    }
  });
  check_finite();
  if (bodies_ != nullptr) {
    for (Search& own : searches_) {
      for (const std::int32_t i : own.rebuilt) {
        const bool larger = set_middle(i);
        if (!sorted_.move(i, middles_[i]) || larger) own.strayed |= bit_of(i);
      }
    }
  }
  std::uint32_t strayed = 0;
  staying_ = 0;
  for (const Search& own : searches_) strayed |= own.strayed, staying_ |= own.staying;
  sorted_.sort(strayed, spheres_, places());
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
  std::copy_n(places()[i].c, 3, query.x);
  query.reach = spheres_.radius[i] + skin_;
  query.sphere = i, query.fiber = spheres_.fiber[i];
  const std::int32_t near =
      kernel_->query_neighbors(sorted_.cells(size_class).view(), runs, count, query, scratch.near.data());
  for (std::int32_t n = 0; n < near; ++n) {
    if (bodies_ == nullptr || are_close(i, scratch.near[n])) found(scratch.near[n]);
  }
}

template <class Found>
void NeighborList::search_near(std::int32_t i, int size_class, Scratch& scratch, const Found& found) const {
  const SortedCells& cells = sorted_.cells(size_class);
  Scratch::Around& around = scratch.around[size_class];
  const std::int32_t cell = cells.cell_of(places()[i]);
  if (cell != around.cell) {
    around.cell = cell;
    around.count = cells.runs_around(places()[i], around.runs);
    make_room({around.runs, static_cast<std::size_t>(around.count)}, scratch.near);
  }
  if (around.count > 0) query(i, size_class, around.runs, around.count, scratch, found);
}

template <class Found>
void NeighborList::search_within(std::int32_t i, int size_class, Scratch& scratch, const Found& found) const {
  const double distance = sorted_.reach_into(size_class, spheres_.radius[i] + skin_);
  sorted_.cells(size_class).runs_within(places()[i], distance, scratch.within);
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
    if (bodies_ != nullptr && bodies_->is_none(i)) continue;
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
