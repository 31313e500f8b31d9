// Whether a sphere fits among others of many sizes, against all of them compared one by one.
#include "dem/insertion/insertion_grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(insertion_grid_test)

namespace dem = fiberchain::dem;

namespace {

using Vec3 = dem::Vec<double, 3>;

bool is_free(const dem::PlacedSpheres& all, const Vec3& period, double gap, const Vec3& center,
             double radius) {
  for (std::size_t i = 0; i < all.radius.size(); ++i) {
    Vec3 r = all.position[i] - center;
    for (int c = 0; c < 3; ++c) {
      if (period[c] > 0) r[c] -= period[c] * std::round(r[c] / period[c]);
    }
    if (dem::norm(r) < radius + all.radius[i] + gap) return false;
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_free_among_sizes_of_1_to_100_is_what_brute_force_finds) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(0, 1);
  const dem::Box box{{-1, 0, 2}, {2, 1, 3.3}};
  constexpr double largest = 0.2;
  for (const Vec3& period : {Vec3{}, Vec3{0.9, 0, 0}, Vec3{3, 1, 1.3}}) {
    for (const double gap : {0.0, 0.03, -0.001}) {
      dem::InsertionGrid grid(box, period, largest, gap, 300);
      dem::PlacedSpheres placed;
      int free = 0;
      constexpr int tried = 3000;
      for (int n = 0; n < tried; ++n) {
        // in the box and somewhat beyond it, the largest not always first
        const Vec3 at{3.4 * uniform(random) - 1.2, 1.2 * uniform(random) - 0.1, 1.7 * uniform(random) + 1.8};
        const double radius = largest * std::pow(100, -uniform(random));
        const bool fits = grid.free(at, radius);
        BOOST_REQUIRE(fits == is_free(placed, period, gap, at, radius));
        if (!fits) continue;
        ++free;
        grid.add(at, radius);
        placed.position.push_back(at), placed.radius.push_back(radius);
      }
      BOOST_TEST(free > 100);
      BOOST_TEST(free < tried - 500);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
