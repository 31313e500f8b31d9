// A beam on two supports under the weights of its spheres: handbook cases, overhang, shear.
#include "reference/supported_beam.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(supported_beam_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double rigid = std::numeric_limits<double>::infinity();

void close(double value, double expected, double tolerance, const char* what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance * std::abs(expected),
             what << ": " << value << ", expected " << expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_points_are_a_beam_with_one_load) {
  const auto beam = ref::beam_on_supports({3, 0.35, 0.8, 2.3, rigid, 0, 2});
  close(beam.left, 1.2, 1e-14, "support");
  close(beam.right, 1.2, 1e-14, "support");
  close(beam.deflection[1], 0.8 * std::pow(0.7, 3) / (48 * 2.3), 1e-13, "P L^3 / 48 E I");
  const auto shears = ref::beam_on_supports({3, 0.35, 0.8, 2.3, 17.0, 0, 2});
  close(shears.deflection[1] - beam.deflection[1], 0.8 * 0.7 / (4 * 17.0), 1e-12, "P L / 4 G A");
}

BOOST_AUTO_TEST_CASE(many_points_are_a_uniform_load) {
  const int n = 2001;
  const double L = 0.63, q = 0.4, l = L / (n - 1), EI = 1.7;
  const auto ends = ref::beam_on_supports({n, l, q * l, EI, rigid, 0, n - 1});
  close(ends.deflection[n / 2], 5 * q * std::pow(L, 4) / (384 * EI), 1e-5, "5 q L^4 / 384 E I");
  // overhang a on both sides, span b: middle q b^2 (5 b^2 - 24 a^2) / 384 E I, ends q a (3 a^2 (a + 2 b) -
  // b^3) / 24 E I, and the outer halves of the end loads, P: - P a b^2 / 8 E I, P a^2 (2 a + 3 b) / 6 E I
  const double a = L / 5, b = L - 2 * a, P = q * l / 2;
  const auto over = ref::beam_on_supports({n, l, q * l, EI, rigid, 400, 1600});
  close(over.deflection[n / 2], q * b * b * (5 * b * b - 24 * a * a) / (384 * EI) - P * a * b * b / (8 * EI),
        1e-5, "overhang, middle");
  close(over.deflection[0],
        q * a * (3 * a * a * (a + 2 * b) - b * b * b) / (24 * EI) + P * a * a * (2 * a + 3 * b) / (6 * EI),
        1e-5, "overhang, end");
  close(over.deflection[n - 1], over.deflection[0], 1e-9, "symmetric");
  BOOST_TEST(over.deflection[400] == 0);
  BOOST_TEST(std::abs(over.deflection[1600]) < 1e-15);
}

BOOST_AUTO_TEST_CASE(an_unsymmetric_beam_balances) {
  const auto beam = ref::beam_on_supports({8, 0.2, 0.3, 1.1, 40.0, 1, 5});
  close(beam.left + beam.right, 8 * 0.3, 1e-14, "weight");
  close(beam.left * 0.2 + beam.right * 1.0, 8 * 0.3 * 0.7, 1e-14, "moment");
  // turned end for end
  const auto turned = ref::beam_on_supports({8, 0.2, 0.3, 1.1, 40.0, 2, 6});
  for (int i = 0; i < 8; ++i)
    BOOST_TEST(std::abs(turned.deflection[7 - i] - beam.deflection[i]) < 1e-13 * 0.3);
  BOOST_CHECK_THROW(ref::beam_on_supports({8, 0.2, 0.3, 1.1, 40.0, 5, 5}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::beam_on_supports({8, 0.2, 0.3, 1.1, 40.0, 2, 8}), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
