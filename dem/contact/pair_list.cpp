#include "dem/contact/pair_list.hpp"

#include <algorithm>
#include <utility>

#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {

void PairList::clear() {
  first.clear(), second.clear(), contact.clear();
  count = 0;
  reached.clear();
  across = 0;
}

void PairList::find_reached(const Partition& parts, int own) {
  std::vector<std::uint8_t> is_reached(static_cast<std::size_t>(parts.count()), 0);
  for (std::size_t p = 0; p < count; ++p) {
    const int other = parts.of(second[p]);
    if (other != own) is_reached[other] = 1, ++across;
  }
  for (int k = own + 1; k < parts.count(); ++k) {
    if (is_reached[k] != 0) reached.push_back(k);
  }
}

void PairList::update(const NeighborList& list, int part, ContactHistories& histories, int width,
                      std::int32_t pad, PairList& next) {
  const std::vector<Pair> found = list.found(part);
  next.clear();
  const std::size_t most = whole_vectors(count + found.size(), width);
  for (std::vector<std::int32_t>* numbers : {&next.first, &next.second, &next.contact})
    numbers->reserve(most);
  const auto append = [&](const Pair& pair, std::int32_t number) {
    next.first.push_back(pair.first);
    next.second.push_back(pair.second);
    next.contact.push_back(number);
  };
  auto f = found.begin();
  for (std::size_t p = 0; p < count; ++p) {
    const Pair pair{first[p], second[p]};
    for (; f != found.end() && *f < pair; ++f) append(*f, 0);
    const bool again = f != found.end() && *f == pair;
    if (again) ++f;
    if (again || !(list.is_rebuilt(pair.first) || list.is_rebuilt(pair.second))) {
      append(pair, contact[p]);
    } else if (contact[p] != 0) {
      histories.give_back(contact[p]);
    }
  }
  for (; f != found.end(); ++f) append(*f, 0);
  next.count = next.first.size();
  next.find_reached(list.parts(), part);
  next.first.resize(whole_vectors(next.count, width), pad);
  next.second.resize(next.first.size(), pad + 1);
  next.contact.resize(next.first.size(), 0);
  std::swap(*this, next);
}

}  // namespace fiberchain::dem
