// Neighbor lists, and what parts make of them, against all pairs compared one by one.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/inner_pairs.hpp"
#include "dem/contact/neighbor_list.hpp"
#include "dem/contact/pair_list.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/simd/lane_count.hpp"
#include "tests/dem/contact/brute_pairs.hpp"

BOOST_AUTO_TEST_SUITE(neighbor_list_test)

namespace dem = fiberchain::dem;

namespace {

using Vec3 = dem::Vec<double, 3>;
using listed::brute_pairs;
using listed::Pairs;
using listed::updated;

}  // namespace

BOOST_AUTO_TEST_CASE(neighbor_pairs_are_those_of_brute_force) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int n = 1200, parts = 7;
  for (const int trial : {0, 1, 2, 3}) {
    const bool periodic = trial % 2 == 1;
    dem::SphereSet set{{}, {}, periodic ? Vec3{0.9, 0, 0.8} : Vec3{}};
    std::vector<Vec3> positions;
    for (int s = 0; s < n; ++s) {
      positions.push_back({3 * uniform(random) - 1, uniform(random), 1.7 * uniform(random)});
      set.radius.push_back(0.03 + 0.03 * uniform(random));
      set.fiber.push_back(s / 12);
    }
    dem::ThreadPool pool(2);
    const auto instructions = trial < 2 ? dem::InstructionSet::scalar : dem::best_instruction_set();
    dem::NeighborList list = listed::list_of(set, 0.007, parts, instructions);
    list.build(positions, pool);
    Pairs pairs = updated({}, list, parts);
    BOOST_TEST(pairs.size() > 400u);
    BOOST_TEST((pairs == brute_pairs(list)));
    // spheres go far and near, out of the box that they began in too; cells are sorted again at times
    dem::SphereStorage rows(n, false);
    for (int round = 0; round < 150; ++round) {
      listed::jiggle(positions, rows, random, [&](int i) {
        return i % 3 == 0 ? 0.02 : round % 50 == 0 ? 0.7 : 0.0005;
      });
      if (round % 5 != 0) continue;
      const double farthest = list.farthest_moved(rows, pool);
      list.update(rows, 0.004, pool);
      BOOST_TEST(farthest > 0.004);
      BOOST_TEST(list.farthest_moved(rows, pool) <= 0.004);
      pairs = updated(pairs, list, parts);
      BOOST_REQUIRE((pairs == brute_pairs(list)));
    }
  }
}

namespace {

/// Spheres at random in a box of sides 1, of one radius or of many, with pads behind them.
struct RandomSpheres {
  dem::SphereStorage rows;
  std::vector<std::int32_t> kind;
  dem::PeriodicBox periods;
  double radius = 0.031;

  RandomSpheres(int count, const dem::ContactPhysics& physics, std::mt19937& random)
      : rows(count, false),
        kind(count + dem::SphereStorage::pads, 0),
        periods(dem::periodic_box(physics.periodic ? Vec3{1, 0, 1} : Vec3{})) {
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < 3; ++c) rows.position_row(i)[c] = uniform(random);
      rows.position_row(i)[dem::radius_offset] = physics.uniform ? radius : radius * (0.5 + uniform(random));
    }
    for (int c = 0; c < 3; ++c) rows.position_row(count + 1)[c] = c == 1 ? 1e3 : 0.5;
  }

  double gap(std::int32_t i, std::int32_t j) const {
    Vec3 r = rows.position(j) - rows.position(i);
    for (int c = 0; c < 3; ++c) {
      if (periods.length[c] > 0) r[c] -= std::round(r[c]);
    }
    return dem::norm(r) - rows.radius(i) - rows.radius(j);
  }

  dem::ContactView view(dem::PairList& pairs) {
    dem::ContactView view{};
    view.position_radius = rows.position_radius.data();
    view.velocity_spin = rows.velocity_spin.data();
    view.kind = kind.data();
    view.radius = radius;
    view.first = pairs.first.data(), view.second = pairs.second.data(), view.contact = pairs.contact.data();
    view.kinds = 1;
    view.periods = periods;
    return view;
  }
};

/// So many different pairs of neighbors in numbering, padded; every seventh has a contact.
dem::PairList some_pairs(int count, int spheres, int width) {
  dem::PairList pairs;
  for (int first = 0, apart = 1; pairs.first.size() < static_cast<std::size_t>(count); ++first) {
    if (first + apart >= spheres) first = 0, ++apart;
    pairs.first.push_back(first), pairs.second.push_back(first + apart);
    pairs.contact.push_back(pairs.first.size() % 7 == 3 ? static_cast<std::int32_t>(pairs.first.size()) : 0);
  }
  pairs.count = pairs.first.size();
  while (pairs.first.size() % width != 0)
    pairs.first.push_back(spheres), pairs.second.push_back(spheres + 1), pairs.contact.push_back(0);
  return pairs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(inner_pairs_are_those_of_brute_force) {
  std::mt19937 random(11);
  constexpr int spheres = 61;
  for (int combination = 0; combination < dem::contact_combinations; ++combination) {
    const dem::ContactPhysics physics = dem::contact_physics(combination);
    for (const dem::InstructionSet set : dem::available_instruction_sets()) {
      const dem::ContactKernel& kernel = dem::law_of({}).kernel(physics, set);
      dem::InnerPairList inner;
      // none, less than a vector, more than are looked at at once; cutoffs that rise and fall
      for (const auto& [count, cutoff] :
           std::map<int, double>{{0, 0.1}, {3, 0.5}, {1023, 0.2}, {1769, 0.07}}) {
        RandomSpheres all(spheres, physics, random);
        dem::PairList pairs = some_pairs(count, spheres, kernel.width);
        inner.stale = true, inner.displacement_since = 1;
        inner.prune(all.view(pairs), static_cast<std::int32_t>(pairs.first.size()), cutoff, kernel, spheres);
        BOOST_TEST(!inner.stale);
        BOOST_TEST(inner.displacement_since == 0);
        std::vector<std::int32_t> expected;
        std::size_t halo = 0;
        for (std::int32_t p = 0; p < count; ++p) {
          if (all.gap(pairs.first[p], pairs.second[p]) >= cutoff && pairs.contact[p] == 0) continue;
          expected.push_back(p);
          halo += pairs.second[p] >= 37 ? 1 : 0;
        }
        BOOST_TEST(inner.halo_count(37) == halo);
        BOOST_TEST(static_cast<std::size_t>(inner.count) ==
                   dem::whole_vectors(expected.size(), kernel.width));
        BOOST_TEST_REQUIRE(static_cast<std::size_t>(inner.count) >= expected.size());
        bool same = true;
        for (std::size_t n = 0; n < expected.size(); ++n) {
          const std::int32_t p = expected[n], touches = pairs.contact[p] != 0 ? 1 : 0;
          same = same && inner.pair[n] == p && inner.first[n] == pairs.first[p] &&
                 inner.second[n] == pairs.second[p] && inner.contact[n] == pairs.contact[p] &&
                 inner.touches[n] == touches;
        }
        for (auto n = static_cast<std::int32_t>(expected.size()); n < inner.count; ++n) {
          same = same && inner.first[n] == spheres && inner.second[n] == spheres + 1 &&
                 inner.contact[n] == 0 && inner.touches[n] == 0;
        }
        BOOST_TEST(same);
      }
    }
  }
}

/// Spheres come and go at a wall: the neighbors are those within reach, contacts stay with the sphere that
/// has them, and every history of a sphere that has gone is free again.
BOOST_AUTO_TEST_CASE(wall_neighbors_are_those_of_brute_force) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int begin = 13, end = 110, width = 8, pad = 200;
  std::vector<double> height(end, 1);
  dem::WallNeighbors neighbors, scratch;
  dem::ContactHistories histories;
  std::map<std::int32_t, std::int32_t> contact_of;
  for (int round = 0; round < 300; ++round) {
    std::vector<std::int32_t> rebuilt;
    for (std::int32_t i = begin; i < end; ++i) {
      if (round > 0 && uniform(random) > 0.15) continue;
      rebuilt.push_back(i);
      height[i] = uniform(random);
    }
    const auto is_near = [&](std::int32_t i) { return height[i] < 0.3; };
    histories.reserve(1);
    const std::int32_t all_numbers = static_cast<std::int32_t>(histories.free.size()) - 1;
    neighbors.update(rebuilt, is_near, histories, width, pad, scratch);
    std::erase_if(contact_of, [&](const auto& entry) { return !is_near(entry.first); });
    std::vector<std::int32_t> slots, contact;
    for (std::int32_t i = begin; i < end; ++i) {
      if (!is_near(i)) continue;
      slots.push_back(i);
      contact.push_back(contact_of.contains(i) ? contact_of.at(i) : 0);
    }
    BOOST_TEST_REQUIRE(neighbors.count == slots.size());
    BOOST_TEST_REQUIRE(histories.free_count == all_numbers - static_cast<std::int32_t>(contact_of.size()));
    slots.resize(dem::whole_vectors(slots.size(), width), pad), contact.resize(slots.size(), 0);
    BOOST_TEST((neighbors.slots == slots && neighbors.contact == contact));
    for (std::size_t n = 0; n < neighbors.count; ++n) {  // some begin to touch
      if (neighbors.contact[n] != 0 || uniform(random) > 0.2) continue;
      histories.reserve(1);
      neighbors.contact[n] = contact_of[neighbors.slots[n]] = histories.take();
    }
  }
}

/// The pairs of a part after updates, with contacts that stay while their pair does.
BOOST_AUTO_TEST_CASE(pairs_of_parts_are_those_of_brute_force) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int n = 301, parts = 3, width = 4;
  dem::SphereSet set{std::vector<double>(n, 0.04), {}, Vec3{0, 1.1, 0}};
  std::vector<Vec3> positions;
  for (int i = 0; i < n; ++i) {
    set.fiber.push_back(i / 7);
    positions.push_back({uniform(random), 1.1 * uniform(random), uniform(random)});
  }
  dem::ThreadPool pool(2);
  dem::NeighborList list(set, 0.02, dem::even_partition(n, parts),
                         dem::law_of({}).kernel({true, true, false, false}, dem::best_instruction_set()));
  list.build(positions, pool);
  dem::PairList pairs[parts], scratch;
  dem::ContactHistories histories[parts];
  std::map<dem::Pair, std::int32_t> contact_of;
  dem::SphereStorage rows(n, false);
  for (int round = 0; round < 60; ++round) {
    Pairs all;
    bool same = true;
    for (int k = 0; k < parts; ++k) {
      histories[k].reserve(1);
      pairs[k].update(list, k, histories[k], width, n, scratch);
      BOOST_TEST(pairs[k].first.size() == dem::whole_vectors(pairs[k].count, width));
      std::set<int> reached;
      std::size_t across = 0;
      for (std::size_t p = 0; p < pairs[k].count; ++p) {
        const dem::Pair pair{pairs[k].first[p], pairs[k].second[p]};
        same = same && list.parts().of(pair.first) == k;
        if (const int other = list.parts().of(pair.second); other != k) reached.insert(other), ++across;
        const auto touching = contact_of.find(pair);
        same = same && pairs[k].contact[p] == (touching == contact_of.end() ? 0 : touching->second);
        all.push_back(pair);
      }
      BOOST_TEST((pairs[k].reached == std::vector<int>(reached.begin(), reached.end())));
      BOOST_TEST(pairs[k].across == across);
    }
    BOOST_REQUIRE((all == brute_pairs(list)));
    std::erase_if(contact_of,
                  [&](const auto& entry) { return !std::ranges::binary_search(all, entry.first); });
    for (int k = 0; k < parts; ++k) {
      for (std::size_t p = 0; p < pairs[k].count; ++p) {
        if (pairs[k].contact[p] != 0 || uniform(random) > 0.1) continue;
        histories[k].reserve(1);
        pairs[k].contact[p] = contact_of[{pairs[k].first[p], pairs[k].second[p]}] = histories[k].take();
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int c = 0; c < 3; ++c)
        rows.position_row(i)[c] = positions[i][c] += (i % 4 == 0 ? 0.05 : 0.002) * (uniform(random) - 0.5);
    }
    list.update(rows, 0.006, pool);
  }
  BOOST_TEST(contact_of.size() > 50u);
}

BOOST_AUTO_TEST_SUITE_END()
