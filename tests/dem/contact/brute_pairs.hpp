#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "dem/contact/contact_law.hpp"
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

/// A list of spheres of any sizes, in parts of as many each.
inline dem::NeighborList list_of(const dem::SphereSet& set, double skin, int parts,
                                 dem::InstructionSet instructions) {
  const bool periodic = dem::norm(set.period) > 0;
  return {set, skin, dem::even_partition(static_cast<std::int32_t>(set.radius.size()), parts),
          dem::law_of({}).kernel({false, periodic, false, false}, instructions)};
}

/// Moves all spheres at random by at most half of step(sphere) along each axis.
template <class Random, class Step>
void jiggle(std::vector<dem::Vec<double, 3>>& positions, dem::SphereStorage& rows, Random& random,
            const Step& step) {
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int c = 0; c < 3; ++c)
      rows.position_row(static_cast<std::int64_t>(i))[c] = positions[i][c] +=
          step(static_cast<int>(i)) * (uniform(random) - 0.5);
  }
}

}  // namespace listed
