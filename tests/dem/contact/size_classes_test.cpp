// Spheres of many sizes: their neighbors, and what a search for them looks at, against brute force.
#include "dem/contact/size_classes.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/contact/contact_law.hpp"
#include "tests/dem/contact/brute_pairs.hpp"

BOOST_AUTO_TEST_SUITE(size_classes_test)

namespace dem = fiberchain::dem;

namespace {

using Vec3 = dem::Vec<double, 3>;
using listed::brute_pairs;
using listed::Pairs;
using listed::updated;

/// Sizes of 1 to 100, as many spheres of each factor, or one of 100 among many of 1.
double radius_of(int trial, int sphere, double any) {
  constexpr double largest = 0.15;
  if (trial < 4) return largest * std::pow(100, -any);
  return sphere == 400 ? largest : largest / 100;
}

}  // namespace

BOOST_AUTO_TEST_CASE(neighbor_pairs_of_sizes_1_to_100_are_those_of_brute_force) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int n = 600;
  for (const int trial : {0, 1, 2, 3, 4, 5}) {
    const bool periodic = trial % 2 == 1;
    dem::SphereSet set{{}, {}, periodic ? Vec3{0.62, 0, 0.9} : Vec3{}};
    std::vector<Vec3> positions;
    for (int s = 0; s < n; ++s) {
      const double wide = trial < 4 ? 1 : 0.3;
      positions.push_back(wide * Vec3{uniform(random) - 0.3, 0.7 * uniform(random), 0.9 * uniform(random)});
      set.radius.push_back(radius_of(trial, s, uniform(random)));
      set.fiber.push_back(s / 5);
    }
    const int parts = 1 + 3 * trial;
    dem::ThreadPool pool(1 + trial % 3);
    const auto instructions = trial < 2 ? dem::InstructionSet::scalar : dem::best_instruction_set();
    dem::NeighborList list = listed::list_of(set, 0.004, parts, instructions);
    list.build(positions, pool);
    Pairs pairs = updated({}, list, parts);
    BOOST_TEST(pairs.size() > 30u);
    BOOST_REQUIRE((pairs == brute_pairs(list)));
    // the small ones move, the large ones, all, a few by far
    dem::SphereStorage rows(n, false);
    for (int round = 0; round < 80; ++round) {
      listed::jiggle(positions, rows, random, [&](int i) {
        const bool large = set.radius[i] > 0.05, moves = round % 3 == 2 || large == (round % 3 == 1);
        return round % 40 == 39 && i % 9 == 0 ? 0.9 : moves ? 0.01 : 0.0001;
      });
      list.update(rows, 0.002, pool);
      pairs = updated(pairs, list, parts);
      BOOST_REQUIRE((pairs == brute_pairs(list)));
    }
  }
}

BOOST_AUTO_TEST_CASE(radii_of_a_class_are_within_a_factor_of_two) {
  for (const double largest : {1.0, 0.3, 7e-5}) {
    for (double radius = largest, factor = 1; factor < 1e4; factor *= 1.07, radius = largest / factor) {
      const int k = dem::size_class(radius, largest);
      BOOST_TEST(radius <= std::ldexp(largest, -k) * (1 + 1e-12));
      BOOST_TEST(radius > std::ldexp(largest, -k - 1) * (1 - 1e-12));
    }
    BOOST_TEST(dem::size_class(1e-9 * largest, largest) == dem::most_size_classes - 1);
  }
}

// Rows of cells hold all that is near, no cell twice, and little else.
BOOST_AUTO_TEST_CASE(rows_of_cells_hold_what_brute_force_finds_within_a_distance) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> uniform(0, 1);
  const dem::Box box{{-1, 2, 0}, {0.5, 3, 0.7}};
  const Vec3 length = box.high - box.low;
  const double edge = 0.06, diagonal = 2 * std::sqrt(3) * edge;  // no cell is twice as long
  for (const Vec3& period : {Vec3{}, Vec3{0, 1, 0}, length}) {
    const dem::CellGeometry cells(box, period, edge, 1e6);
    std::vector<Vec3> points;
    for (int n = 0; n < 2000; ++n) {
      Vec3 point;
      for (int c = 0; c < 3; ++c) point[c] = box.low[c] + length[c] * (1.2 * uniform(random) - 0.1);
      points.push_back(point);
    }
    for (int n = 0; n < 300; ++n) {
      const Vec3& place = points[n];
      const double distance = 0.5 * std::pow(uniform(random), 2);
      std::vector<int> visits(cells.count(), 0);
      BOOST_TEST(cells.rows_within(place, distance, [&](std::int32_t first, std::int32_t last) {
        for (std::int32_t cell = first; cell <= last; ++cell) ++visits[cell];
        return true;
      }));
      BOOST_TEST(*std::ranges::max_element(visits) == 1);
      bool all = true, few = true;
      for (const Vec3& point : points) {
        Vec3 r = point - place;
        double outside = 0;  // of the box: counted for the cells at its border
        for (int c = 0; c < 3; ++c) {
          if (period[c] > 0) {
            r[c] -= period[c] * std::round(r[c] / period[c]);
          } else {
            for (const Vec3& x : {point, place})
              outside = std::max({outside, box.low[c] - x[c], x[c] - box.high[c]});
          }
        }
        const int visited = visits[cells.index(point)];
        all = all && (visited == 1 || dem::norm(r) > distance);
        // spans of a whole period are not cut to a ball
        if (outside == 0 && 2 * (distance + edge) < 0.7 - 2 * edge)
          few = few && (visited == 0 || dem::norm(r) < distance + diagonal);
      }
      BOOST_TEST(all);
      BOOST_TEST(few);
    }
  }
}

// What is looked at around a small sphere does not depend on the largest.
BOOST_AUTO_TEST_CASE(candidates_do_not_depend_on_the_largest_body) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int n = 4000;
  constexpr double radius = 0.01, skin = 0.006;
  std::vector<Vec3> positions;
  for (int i = 0; i < n; ++i) positions.push_back({uniform(random), uniform(random), uniform(random)});
  const auto candidates = [&](double largest) {
    dem::SphereSet set{std::vector<double>(n, radius), std::vector<std::int32_t>(n, 0), {}};
    set.radius[0] = largest;
    dem::SizeClasses classes(set, skin);
    classes.sort(classes.all(), set, positions);
    std::int64_t all = 0;
    for (int i = 1; i < n; ++i) {
      for (int k = 0; k <= classes.of(i); ++k) {
        dem::SlotRange runs[dem::SortedCells::most_runs];
        const int count = classes.cells(k).runs_around(positions[i], runs);
        for (int r = 0; r < count; ++r) all += runs[r].end - runs[r].begin;
      }
    }
    return static_cast<double>(all) / (n - 1);
  };
  const double alone = candidates(radius);
  BOOST_TEST(alone > 1);
  BOOST_TEST(alone < 0.01 * n);
  for (const double largest : {3 * radius, 30 * radius, 300 * radius}) {
    const double beside = candidates(largest);
    BOOST_TEST(beside > alone - 1);
    BOOST_TEST(beside < alone + 2);
  }
}

BOOST_AUTO_TEST_SUITE_END()
