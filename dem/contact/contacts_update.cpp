#include <algorithm>

#include "dem/contact/contacts.hpp"

// Which pairs the loops look at, and what is saved of contacts when that changes.
namespace fiberchain::dem {
namespace {

std::size_t whole_vectors(std::size_t count, int width) { return (count + width - 1) / width * width; }

/// Of what spheres may move before one that is not rebuilt could touch: with less left it pays to list some
/// rebuilt, ...
constexpr double kWorthwhile = 0.2;
/// ... all that have moved more than this.
constexpr double kStays = 0.4;

/// Part of the skin up to which a pair is snapshot at every step: those are chosen rebuilt whenever one of
/// the others might touch.
constexpr double kNear = 0.18;
/// Pairs of which near ones are chosen before more room is made for these: whole vectors.
constexpr std::int32_t kPairsAtOnce = 1024;

}  // namespace

void Contacts::PairList::clear() {
  first.clear(), second.clear(), contact.clear();
  count = 0;
  last_part = -1;
}

void Contacts::rebuild_neighbor_list(const SphereStorage& rows, double time, ThreadPool& pool) {
  std::vector<Vec<double, 3>> position_radius(spheres());
  for (std::int64_t i = 0; i < spheres(); ++i) position_radius[i] = rows.position(i);
  rebuild_neighbor_list(std::move(position_radius), time, pool);
}

void Contacts::rebuild_neighbor_list(std::vector<Vec<double, 3>> position_radius, double time,
                                     ThreadPool& pool) {
  const std::vector<SavedContact> contacts = saved();
  for (Part& part : parts_) {
    part.histories.reset();
    part.pairs.clear();
    for (WallNeighbors& near : part.walls) near.count = 0;
  }
  reference_time_ = time;
  close_.list(std::move(position_radius), pool);
  renew(pool);
  restore(contacts);
}

double Contacts::follow(const SphereStorage& rows, ThreadPool& pool) {
  const double limit = 0.5 * skin_;
  const double room = limit - close_.farthest_moved(rows, pool);
  if (room > kWorthwhile * limit) return room;
  close_.update(rows, kStays * limit, pool);
  renew(pool);
  return (1 - kStays) * limit;
}

void Contacts::renew(ThreadPool& pool) {
  pool.each(close_.parts().count(), [&](int k, int) {
    renew_pairs(k);
    for (std::size_t w = 0; w < domain_.walls.size(); ++w) renew_wall(k, static_cast<int>(w));
  });
  std::vector<int> last(parts_.size());
  for (std::size_t k = 0; k < parts_.size(); ++k)
    last[k] = std::max(static_cast<int>(k), parts_[k].pairs.last_part);
  reach_ = PartDependencies(std::move(last));
}

/// Pairs of spheres that stayed are as they were; all others have been found rebuilt. Both are in order.
void Contacts::renew_pairs(int k) {
  const std::vector<Pair> found = close_.found(k);
  Part& part = parts_[k];
  PairList &old = part.pairs, &next = part.next_pairs;
  next.clear();
  const std::size_t most = whole_vectors(old.count + found.size(), kernel_->width);
  for (std::vector<std::int32_t>* list : {&next.first, &next.second, &next.contact}) list->reserve(most);
  const auto append = [&](const Pair& pair, std::int32_t contact) {
    next.first.push_back(pair.first);
    next.second.push_back(pair.second);
    next.contact.push_back(contact);
  };
  auto f = found.begin();
  for (std::size_t p = 0; p < old.count; ++p) {
    const Pair pair{old.first[p], old.second[p]};
    for (; f != found.end() && *f < pair; ++f) append(*f, 0);
    const bool again = f != found.end() && *f == pair;
    if (again) ++f;
    if (again || !(close_.is_rebuilt(pair.first) || close_.is_rebuilt(pair.second))) {
      append(pair, old.contact[p]);
    } else if (old.contact[p] != 0) {
      part.histories.give_back(old.contact[p]);
    }
  }
  for (; f != found.end(); ++f) append(*f, 0);
  next.count = next.first.size();
  if (next.count > 0) next.last_part = close_.parts().of(*std::ranges::max_element(next.second));
  const auto pad = static_cast<std::int32_t>(spheres());
  next.first.resize(whole_vectors(next.count, kernel_->width), pad);
  next.second.resize(next.first.size(), pad + 1);
  next.contact.resize(next.first.size(), 0);
  std::swap(old, next);
  part.near.stale = true;
}

void Contacts::InnerPairList::reserve(std::size_t numbers) {
  const std::size_t with_rest = numbers + numbers / 8;
  for (std::vector<std::int32_t>* list : {&pair, &first, &second, &contact}) {
    if (list->size() < numbers) list->resize(with_rest);
  }
  if (touches.size() < numbers) touches.resize(with_rest);
}

double Contacts::inner_cutoff() const { return law_reach_ + kNear * skin_; }

void Contacts::prune(Part& part, std::int32_t part_end, const SphereStorage& rows) {
  InnerPairList& near = part.near;
  const auto count = static_cast<std::int32_t>(part.pairs.first.size());
  std::int32_t found = 0;
  for (std::int32_t begin = 0; begin < count; begin += kPairsAtOnce) {
    near.reserve(static_cast<std::size_t>(found) + kPairsAtOnce + lanes_beyond);
    found = kernel_->near(view(part, rows), begin, std::min(begin + kPairsAtOnce, count), inner_cutoff(),
                          near.view(), found);
  }
  const auto leaving = std::count_if(near.second.begin(), near.second.begin() + found,
                                     [&](std::int32_t j) { return j >= part_end; });
  if (part.halo.size() < static_cast<std::size_t>(leaving)) part.halo.resize(leaving);
  for (; found % kernel_->width != 0; ++found) {
    near.pair[found] = near.contact[found] = 0;
    near.first[found] = static_cast<std::int32_t>(spheres()), near.second[found] = near.first[found] + 1;
    near.touches[found] = 0;
  }
  near.count = found;
  near.stale = false, near.displacement_since = 0;
  if (part.touching.size() < static_cast<std::size_t>(found) + lanes_beyond)
    part.touching.resize(found + lanes_beyond);
}

void Contacts::renew_wall(int k, int w) {
  const Wall& wall = domain_.walls[w];
  WallNeighbors &old = parts_[k].walls[w], &next = parts_[k].next_wall;
  const std::vector<std::int32_t>& rebuilt = close_.rebuilt(k);
  next.slots.clear(), next.contact.clear();
  std::size_t p = 0;
  const auto append = [&](std::int32_t slot, std::int32_t contact) {
    next.slots.push_back(slot);
    next.contact.push_back(contact);
  };
  const auto take_old = [&](std::int32_t below) {
    for (; p < old.count && old.slots[p] < below; ++p) append(old.slots[p], old.contact[p]);
  };
  for (const std::int32_t i : rebuilt) {
    take_old(i);
    const bool was = p < old.count && old.slots[p] == i;
    if (gap_to(wall, close_.position_radius()[i], reference_time_) < radius_[i] + close_.skin()) {
      append(i, was ? old.contact[p] : 0);
    } else if (was && old.contact[p] != 0) {
      parts_[k].histories.give_back(old.contact[p]);
    }
    p += was ? 1 : 0;
  }
  take_old(close_.parts().end(k));
  next.count = next.slots.size();
  next.slots.resize(whole_vectors(next.count, kernel_->width), static_cast<std::int32_t>(spheres() + 2));
  next.contact.resize(next.slots.size(), 0);
  std::swap(old, next);
}

bool Contacts::walls_moved_far(double time) const {
  return std::ranges::any_of(domain_.walls, [&](const Wall& wall) {
    return norm(wall.velocity) * (time - reference_time_) > 0.5 * skin_;
  });
}

std::vector<SavedContact> Contacts::saved() const {
  std::vector<SavedContact> all;
  for (const Part& part : parts_) {
    const auto own = static_cast<std::ptrdiff_t>(all.size());
    const PairList& pairs = part.pairs;
    for (std::size_t p = 0; p < pairs.count; ++p) {
      if (pairs.contact[p] != 0) {
        all.push_back(part.histories.at(
            pairs.contact[p], {sphere_primitive(pairs.first[p]), sphere_primitive(pairs.second[p])}));
      }
    }
    for (std::size_t w = 0; w < part.walls.size(); ++w) {
      const WallNeighbors& near = part.walls[w];
      for (std::size_t n = 0; n < near.count; ++n) {
        if (near.contact[n] == 0) continue;
        all.push_back(part.histories.at(near.contact[n], {sphere_primitive(near.slots[n]),
                                                          facet_primitive(static_cast<std::int64_t>(w))}));
      }
    }
    std::ranges::sort(all.begin() + own, all.end(), {}, &SavedContact::key);
  }
  return all;
}

void Contacts::clear() {
  for (Part& part : parts_) {
    part.near.stale = true;
    part.histories.reset();
    std::ranges::fill(part.pairs.contact, 0);
    for (WallNeighbors& near : part.walls) std::ranges::fill(near.contact, 0);
  }
}

void Contacts::restore(const std::vector<SavedContact>& contacts) {
  for (const SavedContact& contact : contacts) {
    const std::int64_t first = contact.key.first.number, second = contact.key.second.number;
    Part& part = parts_[close_.parts().of(static_cast<std::int32_t>(first))];
    part.near.stale = true;
    part.histories.reserve(1);
    const auto put = [&](std::int32_t& number) {
      number = part.histories.take();
      part.histories.put(number, contact);
    };
    if (is_facet(contact.key.second)) {
      WallNeighbors& near = part.walls[second];
      const auto end = near.slots.begin() + static_cast<std::ptrdiff_t>(near.count);
      const auto at = std::lower_bound(near.slots.begin(), end, first);
      if (at != end && *at == first) put(near.contact[at - near.slots.begin()]);
    } else {
      PairList& pairs = part.pairs;
      const auto own = std::equal_range(
          pairs.first.begin(), pairs.first.begin() + static_cast<std::ptrdiff_t>(pairs.count), first);
      for (auto p = own.first; p != own.second; ++p) {
        const std::size_t n = p - pairs.first.begin();
        if (pairs.second[n] == second) put(pairs.contact[n]);
      }
    }
  }
}

}  // namespace fiberchain::dem
