#define BOOST_TEST_MODULE stripe_loads
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

#include "dem/assembly/stripe_loads.hpp"
#include "dem/sphere_rows.hpp"

namespace dem = fiberchain::dem;

namespace {

constexpr int load_numbers = dem::load_numbers;

/// Stripes of 3, 5 and 2 spheres.
dem::Stripes three_stripes() { return dem::Stripes({0, 3, 8, 10}); }

std::vector<double> rising(std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_those_of_their_spheres) {
  dem::StripeLoads loads(three_stripes(), 2);
  const std::vector<double> given = rising(10 * load_numbers);
  loads.set(given.data(), given.size());
  BOOST_TEST(loads.all() == given, boost::test_tools::per_element());
  for (const int k : {0, 1, 2}) {
    BOOST_TEST(loads.of(k).first == three_stripes().begin(k));
    BOOST_TEST(loads.of(k).rows[0] == given[loads.of(k).first * load_numbers]);
    BOOST_TEST(loads.take(k, 1).rows == loads.of(k).rows);
  }
}

BOOST_AUTO_TEST_CASE(spheres_that_come_later_have_none) {
  dem::StripeLoads loads(three_stripes(), 1);
  std::vector<double> given = rising(5 * load_numbers);
  loads.set(given.data(), given.size());
  given.resize(10 * load_numbers, 0.0);
  BOOST_TEST(loads.all() == given, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_thread_gets_what_it_gave_back_last) {
  dem::StripeLoads loads(three_stripes(), 2);
  double *a = loads.take(0, 0).rows, *b = loads.take(1, 1).rows, *c = loads.take(2, 0).rows;
  BOOST_TEST((a != b && b != c && a != c));
  BOOST_TEST(std::count(b, b + 5 * load_numbers, 0.0) == 5 * load_numbers);
  loads.give_back(0, 0), loads.give_back(1, 1), loads.give_back(2, 0);
  BOOST_TEST(loads.take(1, 0).rows == c);
  BOOST_TEST(loads.take(0, 1).rows == b);
  BOOST_TEST(loads.take(2, 1).rows == a);  // from the other, which has one left
}
