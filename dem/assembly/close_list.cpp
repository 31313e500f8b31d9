#include "dem/assembly/close_list.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

/// How far spheres may go from where they were sorted, in parts of what they see.
constexpr double kSlack = 0.5;

}  // namespace

CloseList::CloseList(SphereSet spheres, double skin, Stripes stripes, const ContactKernel& kernel)
    : spheres_(std::move(spheres)), skin_(skin), stripes_(std::move(stripes)), searches_(stripes_.count()), kernel_(&kernel) {
  for (Search& search : searches_) search.found.resize(searches_.size());
}

void CloseList::list(std::vector<Vec<double, 3>> places, Team& team) {
  places_ = std::move(places);
  anew_.assign(places_.size(), 1);
  for (int k = 0; k < stripes_.count(); ++k) {
    searches_[k].anew.clear();
    for (std::int32_t i = stripes_.begin(k); i < stripes_.end(k); ++i) searches_[k].anew.push_back(i);
  }
  check_finite();
  sort();
  search(team);
}

double CloseList::farthest_moved(const SphereRows& rows, Team& team) const {
  std::vector<double> squared(searches_.size(), 0);
  team.each(stripes_.count(), [&](int k, int) {
    double farthest = 0;
    for (std::int32_t i = stripes_.begin(k); i < stripes_.end(k); ++i) {
      const Vec<double, 3> moved = rows.place(i) - places_[i];
      farthest = std::max(farthest, dot(moved, moved));
    }
    squared[k] = farthest;
  });
  return std::sqrt(*std::ranges::max_element(squared));
}

void CloseList::relist(const SphereRows& rows, double distance, Team& team) {
  std::vector<std::uint8_t> strayed(searches_.size(), 0);
  team.each(stripes_.count(), [&](int k, int) {
    std::vector<std::int32_t>& anew = searches_[k].anew;
    anew.clear();
    for (std::int32_t i = stripes_.begin(k); i < stripes_.end(k); ++i) {
      const Vec<double, 3> place = rows.place(i), moved = place - places_[i];
      anew_[i] = dot(moved, moved) > distance * distance ? 1 : 0;
      if (anew_[i] == 0) continue;
      anew.push_back(i);
      places_[i] = place;
      sorted_->move(i, place);
      if (!(sorted_->distance_from_first(i, place) <= slack_)) strayed[k] = 1;
    }
  });
  check_finite();
  if (std::ranges::count(strayed, 1) > 0) sort();
  search(team);
}

void CloseList::check_finite() const {
  for (const Search& search : searches_) {
    for (const std::int32_t i : search.anew) {
      const Vec<double, 3>& x = places_[i];
      if (!std::isfinite(x[0] + x[1] + x[2])) {
        throw InvalidInput(fmt::format("the position of sphere {} is not finite", i));
      }
    }
  }
}

void CloseList::sort() {
  const double reach = 2 * *std::ranges::max_element(spheres_.radius) + skin_;
  check_periods(spheres_.period, reach);
  Box box = box_around(places_);
  for (int c = 0; c < 3; ++c) {
    if (spheres_.period[c] > 0) box.low[c] = 0;
  }
  slack_ = kSlack * reach;
  const Cells cells(box, spheres_.period, reach + slack_, 64.0 * static_cast<double>(places_.size()) + 64);
  sorted_.emplace(cells, places_, spheres_.radius, spheres_.fiber);
}

void CloseList::search(Team& team) {
  team.each(stripes_.count(), [&](int k, int) { search(k); });
}

void CloseList::search(int stripe) {
  Search& own = searches_[stripe];
  for (auto& pairs : own.found) pairs.clear();
  const SortedSpheres all = sorted_->view();
  Asking asking{};
  asking.periods = periods_of(spheres_.period);
  SlotRange runs[CellRuns::most_runs];
  int count = 0;
  std::int32_t last_cell = -1;
  std::vector<std::int32_t> near;
  const std::int32_t begin = stripes_.begin(stripe);
  for (const std::int32_t i : own.anew) {
    const Vec<double, 3>& place = places_[i];
    if (const std::int32_t cell = sorted_->cell_of(place); cell != last_cell) {
      last_cell = cell;
      count = sorted_->runs_around(place, runs);
      std::size_t room = 0;
      for (int k = 0; k < count; ++k) room += runs[k].end - runs[k].begin;
      if (near.size() < room) near.resize(2 * room);
    }
    std::copy_n(place.c, 3, asking.x);
    asking.reach = spheres_.radius[i] + skin_;
    asking.sphere = i, asking.fiber = spheres_.fiber[i];
    const std::int32_t found = kernel_->search(all, runs, count, asking, near.data());
    for (std::int32_t n = 0; n < found; ++n) {
      const std::int32_t j = near[n];
      if (j > i) {
        own.found[stripe].push_back({i, j});
      } else if (anew_[j] == 0) {  // otherwise found from there
        own.found[j >= begin ? stripe : stripes_.of(j)].push_back({j, i});
      }
    }
  }
}

std::vector<ClosePair> CloseList::found(int stripe) const {
  std::vector<ClosePair> pairs;
  for (const Search& from : searches_) pairs.insert(pairs.end(), from.found[stripe].begin(), from.found[stripe].end());
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace fiberchain::dem
