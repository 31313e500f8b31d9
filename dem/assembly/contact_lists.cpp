#include <algorithm>

#include "dem/assembly/contact_set.hpp"

// Which pairs the loops look at, and what is kept of contacts when that changes.
namespace fiberchain::dem {
namespace {

std::size_t whole_vectors(std::size_t count, int width) { return (count + width - 1) / width * width; }

/// Of what spheres may move before one that is not listed could touch: with less left it pays to list some anew, ...
constexpr double kWorthwhile = 0.2;
/// ... all that have moved more than this.
constexpr double kStays = 0.4;

/// Part of the skin up to which a pair is looked at every step: those are chosen anew whenever one of the others might touch.
constexpr double kNear = 0.18;
/// Pairs of which near ones are chosen before more room is made for these: whole vectors.
constexpr std::int32_t kPairsAtOnce = 1024;

}  // namespace

void ContactSet::PairList::clear() {
  first.clear(), second.clear(), contact.clear();
  count = 0;
  last_stripe = -1;
}

void ContactSet::list_pairs(const SphereRows& rows, double time, Team& team) {
  std::vector<Vec<double, 3>> places(spheres());
  for (std::int64_t i = 0; i < spheres(); ++i) places[i] = rows.place(i);
  list_pairs(std::move(places), time, team);
}

void ContactSet::list_pairs(std::vector<Vec<double, 3>> places, double time, Team& team) {
  const std::vector<KeptContact> contacts = kept();
  for (Stripe& stripe : stripes_) {
    stripe.memory.reset();
    stripe.pairs.clear();
    for (NearWall& near : stripe.walls) near.count = 0;
  }
  listed_time_ = time;
  close_.list(std::move(places), team);
  renew(team);
  remember(contacts);
}

double ContactSet::follow(const SphereRows& rows, Team& team) {
  const double limit = 0.5 * close_.skin();
  const double room = limit - close_.farthest_moved(rows, team);
  if (room > kWorthwhile * limit) return room;
  close_.relist(rows, kStays * limit, team);
  renew(team);
  return (1 - kStays) * limit;
}

void ContactSet::renew(Team& team) {
  team.each(close_.stripes().count(), [&](int k, int) {
    renew_pairs(k);
    for (std::size_t w = 0; w < surroundings_.walls.size(); ++w) renew_wall(k, static_cast<int>(w));
  });
  std::vector<int> last(stripes_.size());
  for (std::size_t k = 0; k < stripes_.size(); ++k) last[k] = std::max(static_cast<int>(k), stripes_[k].pairs.last_stripe);
  reach_ = StripeReach(std::move(last));
}

/// Pairs of spheres that stayed are as they were; all others have been found anew. Both are in order.
void ContactSet::renew_pairs(int k) {
  const std::vector<ClosePair> found = close_.found(k);
  Stripe& stripe = stripes_[k];
  PairList &old = stripe.pairs, &next = stripe.next_pairs;
  next.clear();
  const std::size_t most = whole_vectors(old.count + found.size(), kernel_->width);
  for (std::vector<std::int32_t>* list : {&next.first, &next.second, &next.contact}) list->reserve(most);
  const auto append = [&](const ClosePair& pair, std::int32_t contact) {
    next.first.push_back(pair.first);
    next.second.push_back(pair.second);
    next.contact.push_back(contact);
  };
  auto f = found.begin();
  for (std::size_t p = 0; p < old.count; ++p) {
    const ClosePair pair{old.first[p], old.second[p]};
    for (; f != found.end() && *f < pair; ++f) append(*f, 0);
    const bool again = f != found.end() && *f == pair;
    if (again) ++f;
    if (again || !(close_.is_anew(pair.first) || close_.is_anew(pair.second))) {
      append(pair, old.contact[p]);
    } else if (old.contact[p] != 0) {
      stripe.memory.give_back(old.contact[p]);
    }
  }
  for (; f != found.end(); ++f) append(*f, 0);
  next.count = next.first.size();
  if (next.count > 0) next.last_stripe = close_.stripes().of(*std::ranges::max_element(next.second));
  const auto pad = static_cast<std::int32_t>(spheres());
  next.first.resize(whole_vectors(next.count, kernel_->width), pad);
  next.second.resize(next.first.size(), pad + 1);
  next.contact.resize(next.first.size(), 0);
  std::swap(old, next);
  stripe.near.is_old = true;
}

void ContactSet::NearList::make_room(std::size_t numbers) {
  const std::size_t with_rest = numbers + numbers / 8;
  for (std::vector<std::int32_t>* list : {&pair, &first, &second, &contact}) {
    if (list->size() < numbers) list->resize(with_rest);
  }
  if (touches.size() < numbers) touches.resize(with_rest);
}

double ContactSet::near_gap() const { return kNear * close_.skin(); }

void ContactSet::choose_near(Stripe& stripe, std::int32_t stripe_end, const SphereRows& rows) {
  NearList& near = stripe.near;
  const auto count = static_cast<std::int32_t>(stripe.pairs.first.size());
  std::int32_t found = 0;
  for (std::int32_t begin = 0; begin < count; begin += kPairsAtOnce) {
    near.make_room(static_cast<std::size_t>(found) + kPairsAtOnce + lanes_beyond);
    found = kernel_->near(view(stripe, rows), begin, std::min(begin + kPairsAtOnce, count), near_gap(), near.view(), found);
  }
  const auto leaving = std::count_if(near.second.begin(), near.second.begin() + found, [&](std::int32_t j) { return j >= stripe_end; });
  if (stripe.deferred.size() < static_cast<std::size_t>(leaving)) stripe.deferred.resize(leaving);
  for (; found % kernel_->width != 0; ++found) {
    near.pair[found] = near.contact[found] = 0;
    near.first[found] = static_cast<std::int32_t>(spheres()), near.second[found] = near.first[found] + 1;
    near.touches[found] = 0;
  }
  near.count = found;
  near.is_old = false, near.closer = 0;
  if (stripe.touching.size() < static_cast<std::size_t>(found) + lanes_beyond) stripe.touching.resize(found + lanes_beyond);
}

void ContactSet::renew_wall(int k, int w) {
  const Wall& wall = surroundings_.walls[w];
  NearWall &old = stripes_[k].walls[w], &next = stripes_[k].next_wall;
  const std::vector<std::int32_t>& anew = close_.listed_anew(k);
  next.slots.clear(), next.contact.clear();
  std::size_t p = 0;
  const auto append = [&](std::int32_t slot, std::int32_t contact) {
    next.slots.push_back(slot);
    next.contact.push_back(contact);
  };
  const auto take_old = [&](std::int32_t below) {
    for (; p < old.count && old.slots[p] < below; ++p) append(old.slots[p], old.contact[p]);
  };
  for (const std::int32_t i : anew) {
    take_old(i);
    const bool was = p < old.count && old.slots[p] == i;
    if (gap_to(wall, close_.places()[i], listed_time_) < radius_[i] + close_.skin()) {
      append(i, was ? old.contact[p] : 0);
    } else if (was && old.contact[p] != 0) {
      stripes_[k].memory.give_back(old.contact[p]);
    }
    p += was ? 1 : 0;
  }
  take_old(close_.stripes().end(k));
  next.count = next.slots.size();
  next.slots.resize(whole_vectors(next.count, kernel_->width), static_cast<std::int32_t>(spheres() + 2));
  next.contact.resize(next.slots.size(), 0);
  std::swap(old, next);
}

bool ContactSet::walls_moved_far(double time) const {
  return std::ranges::any_of(surroundings_.walls, [&](const Wall& wall) {
    return norm(wall.velocity) * (time - listed_time_) > 0.5 * close_.skin();
  });
}

std::vector<KeptContact> ContactSet::kept() const {
  std::vector<KeptContact> all;
  const auto before = [](const KeptContact& x, const KeptContact& y) {
    return std::pair(x.first, x.second) < std::pair(y.first, y.second);
  };
  for (const Stripe& stripe : stripes_) {
    const auto own = static_cast<std::ptrdiff_t>(all.size());
    const PairList& pairs = stripe.pairs;
    for (std::size_t p = 0; p < pairs.count; ++p) {
      if (pairs.contact[p] != 0) all.push_back(stripe.memory.at(pairs.contact[p], pairs.first[p], pairs.second[p]));
    }
    for (std::size_t w = 0; w < stripe.walls.size(); ++w) {
      const NearWall& near = stripe.walls[w];
      for (std::size_t n = 0; n < near.count; ++n) {
        if (near.contact[n] == 0) continue;
        all.push_back(stripe.memory.at(near.contact[n], near.slots[n], -1 - static_cast<std::int64_t>(w)));
      }
    }
    std::sort(all.begin() + own, all.end(), before);
  }
  return all;
}

void ContactSet::forget() {
  for (Stripe& stripe : stripes_) {
    stripe.near.is_old = true;
    stripe.memory.reset();
    std::ranges::fill(stripe.pairs.contact, 0);
    for (NearWall& near : stripe.walls) std::ranges::fill(near.contact, 0);
  }
}

void ContactSet::remember(const std::vector<KeptContact>& contacts) {
  for (const KeptContact& contact : contacts) {
    Stripe& stripe = stripes_[close_.stripes().of(contact.first)];
    stripe.near.is_old = true;
    stripe.memory.make_room(1);
    const auto put = [&](std::int32_t& number) {
      number = stripe.memory.take();
      stripe.memory.put(number, contact);
    };
    if (contact.second < 0) {
      NearWall& near = stripe.walls[static_cast<std::size_t>(-1 - contact.second)];
      const auto end = near.slots.begin() + static_cast<std::ptrdiff_t>(near.count);
      const auto at = std::lower_bound(near.slots.begin(), end, contact.first);
      if (at != end && *at == contact.first) put(near.contact[at - near.slots.begin()]);
    } else {
      PairList& pairs = stripe.pairs;
      const auto own = std::equal_range(pairs.first.begin(), pairs.first.begin() + static_cast<std::ptrdiff_t>(pairs.count), contact.first);
      for (auto p = own.first; p != own.second; ++p) {
        const std::size_t n = p - pairs.first.begin();
        if (pairs.second[n] == contact.second) put(pairs.contact[n]);
      }
    }
  }
}

}  // namespace fiberchain::dem
