#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

#include "dem/parallel/force_buffers.hpp"
#include "dem/simd/storage_layout.hpp"

BOOST_AUTO_TEST_SUITE(force_buffers_test)

namespace dem = fiberchain::dem;

namespace {

constexpr int load_size = dem::load_size;

/// Partition of 3, 5 and 2 spheres.
dem::Partition three_parts() { return dem::Partition({0, 3, 8, 10}); }

std::vector<double> rising(std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_those_of_their_spheres) {
  dem::ForceBuffers loads(three_parts(), 2);
  const std::vector<double> given = rising(10 * load_size);
  loads.set(given.data(), given.size());
  BOOST_TEST(loads.all() == given, boost::test_tools::per_element());
  for (const int k : {0, 1, 2}) {
    BOOST_TEST(loads.of(k).first == three_parts().begin(k));
    BOOST_TEST(loads.of(k).rows[0] == given[loads.of(k).first * load_size]);
    BOOST_TEST(loads.take(k, 1).rows == loads.of(k).rows);
  }
}

BOOST_AUTO_TEST_CASE(spheres_that_come_later_have_none) {
  dem::ForceBuffers loads(three_parts(), 1);
  std::vector<double> given = rising(5 * load_size);
  loads.set(given.data(), given.size());
  given.resize(10 * load_size, 0.0);
  BOOST_TEST(loads.all() == given, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_thread_gets_what_it_gave_back_last) {
  dem::ForceBuffers loads(three_parts(), 2);
  double *a = loads.take(0, 0).rows, *b = loads.take(1, 1).rows, *c = loads.take(2, 0).rows;
  BOOST_TEST((a != b && b != c && a != c));
  BOOST_TEST(std::count(b, b + 5 * load_size, 0.0) == 5 * load_size);
  loads.give_back(0, 0), loads.give_back(1, 1), loads.give_back(2, 0);
  BOOST_TEST(loads.take(1, 0).rows == c);
  BOOST_TEST(loads.take(0, 1).rows == b);
  BOOST_TEST(loads.take(2, 1).rows == a);  // from the other, which has one left
}

BOOST_AUTO_TEST_SUITE_END()
