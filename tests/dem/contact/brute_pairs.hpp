#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "dem/contact/neighbor_list.hpp"

namespace listed {

namespace dem = fiberchain::dem;

using Pairs = std::vector<dem::Pair>;

/// All neighbor pairs, compared one by one.
inline Pairs brute_pairs(const dem::NeighborList& list) {
  Pairs pairs;
  const dem::SphereSet& all = list.spheres();
  const auto n = static_cast<std::int32_t>(all.radius.size());
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = i + 1; j < n; ++j) {
      dem::Vec<double, 3> r = list.reference_positions()[j] - list.reference_positions()[i];
      for (int c = 0; c < 3; ++c) {
        if (all.period[c] > 0) r[c] -= all.period[c] * std::round(r[c] / all.period[c]);
      }
      if (dem::norm(r) >= all.radius[i] + all.radius[j] + list.skin() ||
          (j == i + 1 && all.fiber[i] == all.fiber[j]))
        continue;
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Pairs after an update: those of spheres that were not rebuilt, and what was found.
inline Pairs updated(const Pairs& before, const dem::NeighborList& list, int parts) {
  Pairs pairs;
  for (const dem::Pair& pair : before) {
    if (!list.is_rebuilt(pair.first) && !list.is_rebuilt(pair.second)) pairs.push_back(pair);
  }
  for (int k = 0; k < parts; ++k) {
    for (const dem::Pair& pair : list.found(k)) {
      BOOST_TEST(list.parts().of(pair.first) == k);
      pairs.push_back(pair);
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace listed
