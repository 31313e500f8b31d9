#include "dem/assembly/close_list.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Times that spheres are listed anew before the grid is fitted to them again.
constexpr int kGridLasts = 64;

}  // namespace

CloseList::CloseList(SphereSet spheres, double skin, int stripes)
    : spheres_(std::move(spheres)), skin_(skin), stripes_(stripes) {
  for (Stripe& stripe : stripes_) stripe.found.resize(stripes);
}

void CloseList::list(const std::vector<Vec<double, 3>>& places, Team& team) {
  listed_.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) listed_[i] = {places[i], spheres_.radius[i]};
  anew_.assign(places.size(), 1);
  for (int k = 0; k < stripes(); ++k) {
    stripes_[k].anew.clear();
    for (std::int32_t i = stripe_begin(k), end = stripe_begin(k + 1); i < end; ++i) stripes_[k].anew.push_back(i);
  }
  check_finite();
  make_grid();
  search_all(team);
}

double CloseList::farthest_moved(const SphereRows& rows, Team& team) const {
  std::vector<double> squared(stripes_.size(), 0);
  team.each(static_cast<int>(stripes()), [&](int k, int) {
    double farthest = 0;
    for (std::int32_t i = stripe_begin(k), end = stripe_begin(k + 1); i < end; ++i) {
      const Vec<double, 3> moved = rows.place(i) - listed_[i].place;
      farthest = std::max(farthest, dot(moved, moved));
    }
    squared[k] = farthest;
  });
  return std::sqrt(*std::ranges::max_element(squared));
}

void CloseList::relist(const SphereRows& rows, double distance, Team& team) {
  team.each(static_cast<int>(stripes()), [&](int k, int) {
    std::vector<std::int32_t>& anew = stripes_[k].anew;
    anew.clear();
    for (std::int32_t i = stripe_begin(k), end = stripe_begin(k + 1); i < end; ++i) {
      const Vec<double, 3> place = rows.place(i), moved = place - listed_[i].place;
      anew_[i] = dot(moved, moved) > distance * distance ? 1 : 0;
      if (anew_[i] == 0) continue;
      anew.push_back(i);
      listed_[i].place = place;
    }
  });
  check_finite();
  if (++since_grid_ >= kGridLasts) {
    make_grid();
  } else {
    for (const Stripe& stripe : stripes_) {
      for (const std::int32_t i : stripe.anew) grid_->move(i, listed_[i].place);
    }
  }
  search_all(team);
}

void CloseList::check_finite() const {
  for (const Stripe& stripe : stripes_) {
    for (const std::int32_t i : stripe.anew) {
      const Vec<double, 3>& x = listed_[i].place;
      if (!std::isfinite(x[0] + x[1] + x[2])) {
        throw InvalidInput(fmt::format("the position of sphere {} is not finite", i));
      }
    }
  }
}

void CloseList::make_grid() {
  const double reach = 2 * *std::ranges::max_element(spheres_.radius) + skin_;
  for (const double period : spheres_.period.c) {
    if (period > 0 && period < 3 * reach) {
      throw InvalidInput(fmt::format("period = {:g} m is not allowed: it must be at least {:g} m, three times what spheres see "
                                     "of each other", period, 3 * reach));
    }
  }
  Box box{listed_[0].place, listed_[0].place};
  for (const ListedSphere& sphere : listed_) {
    const Vec<double, 3>& x = sphere.place;
    for (int c = 0; c < 3; ++c) box.low[c] = std::min(box.low[c], x[c]), box.high[c] = std::max(box.high[c], x[c]);
  }
  for (int c = 0; c < 3; ++c) {
    if (spheres_.period[c] > 0) box.low[c] = 0;
  }
  grid_.emplace(box, spheres_.period, reach, 64.0 * static_cast<double>(listed_.size()) + 64);
  for (const ListedSphere& sphere : listed_) grid_->add(sphere.place);
  since_grid_ = 0;
}

void CloseList::search_all(Team& team) {
  const bool periodic = std::ranges::any_of(spheres_.period.c, [](double p) { return p > 0; });
  team.each(static_cast<int>(stripes()), [&](int k, int) { periodic ? search<true>(k) : search<false>(k); });
}

template <bool periodic>
void CloseList::search(int stripe) {
  Stripe& own = stripes_[stripe];
  for (auto& pairs : own.found) pairs.clear();
  for (const std::int32_t i : own.anew) {
    const ListedSphere self = listed_[i];
    grid_->around(self.place, [&, listed = listed_.data()](std::int32_t j) {
      const ListedSphere& other = listed[j];
      Vec<double, 3> r = other.place - self.place;
      for (int c = 0; periodic && c < 3; ++c) {
        const double period = spheres_.period[c];
        if (period > 0) r[c] -= period * std::nearbyint(r[c] / period);
      }
      const double reach = self.radius + other.radius + skin_;
      if (!(dot(r, r) < reach * reach) || j == i) return true;
      if (j < i && anew_[j] != 0) return true;  // found from there
      const ClosePair pair{std::min(i, j), std::max(i, j)};
      const bool bonded = pair.second == pair.first + 1 && spheres_.fiber[i] == spheres_.fiber[j];
      if (!bonded) own.found[pair.first == i ? stripe : stripe_of(j)].push_back(pair);
      return true;
    });
  }
}

std::vector<ClosePair> CloseList::found(int stripe) const {
  std::vector<ClosePair> pairs;
  for (const Stripe& from : stripes_) pairs.insert(pairs.end(), from.found[stripe].begin(), from.found[stripe].end());
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace fiberchain::dem
