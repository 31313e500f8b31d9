#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/trajectory/h5md.hpp"
#include "tests/dem/trajectory/frames.hpp"

// Frames as they are written and come back.
namespace fiberchain::test {

using namespace fiberchain::dem;

inline const TrajectoryHeader kHeader{
    .author = "A. Tester",
    .creator_version = "1.2.3",
    .provenance = {{"command", "fiberchain run x.yaml"}, {"commit", "abc"}}};

inline void check_equal(const Vec<double, 3>& found, const Vec<double, 3>& expected, double tolerance) {
  for (int k = 0; k < 3; ++k)
    BOOST_TEST(std::abs(found[k] - expected[k]) <= tolerance * std::abs(expected[k]));
}

/// Radii, box, step, time to the bit; what is rounded to its rounding.
inline void check_equal(const TrajectoryFrame& found, const TrajectoryFrame& expected) {
  constexpr double kFloat = 6e-8;
  BOOST_TEST(found.time == expected.time);
  BOOST_TEST(found.step == expected.step);
  check_equal(found.low, expected.low, 0);
  check_equal(found.high, expected.high, 1e-15);  // stored as the low corner and the edges
  for (int k = 0; k < 3; ++k) BOOST_TEST(found.periodic[k] == expected.periodic[k]);
  BOOST_TEST(found.radius == expected.radius, boost::test_tools::per_element());
  BOOST_TEST(found.fiber == expected.fiber, boost::test_tools::per_element());
  BOOST_REQUIRE(found.position.size() == expected.position.size());
  BOOST_REQUIRE(found.velocity.size() == expected.velocity.size());
  for (std::size_t i = 0; i < expected.position.size(); ++i) {
    check_equal(found.position[i], expected.position[i], 7.3e-12);
    check_equal(found.velocity[i], expected.velocity[i], kFloat);
  }
  BOOST_REQUIRE(found.bonds.size() == expected.bonds.size());
  for (std::size_t i = 0; i < expected.bonds.size(); ++i) {
    BOOST_TEST(found.bonds[i].first == expected.bonds[i].first);
    check_equal(found.bonds[i].force, expected.bonds[i].force, kFloat);
    BOOST_CHECK_CLOSE_FRACTION(found.bonds[i].bending_angle, expected.bonds[i].bending_angle, kFloat);
  }
}

inline void write_frames(TrajectoryWriter& writer, std::int64_t first, std::int64_t last) {
  for (std::int64_t step = first; step <= last; step += 10)
    writer.append(bent_fibers(3, 7, step), {{"height", 0.1 * static_cast<double>(step)}});
}

}  // namespace fiberchain::test
