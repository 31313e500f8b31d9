// The chain's own linearization in compression: numbers known, the bond's full energy by finite differences,
// limits.
#include "reference/compressed_chain.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/errors.hpp"
#include "reference/filament_buckling.hpp"

BOOST_AUTO_TEST_SUITE(compressed_chain_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Total energy of the bonds of model form with R = E I = 1, written anew for finite displacements.
double energy(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& angle,
              double nu) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double dx = x[i + 1] - x[i];
    const double dy = y[i + 1] - y[i];
    const double stretch = std::hypot(dx, dy) - 2;
    const double gamma = std::atan2(dy, dx) - (angle[i] + angle[i + 1]) / 2;
    const double bend = angle[i + 1] - angle[i];
    sum += stretch * stretch + 0.5 * (2 / (2 * (1 + nu))) * 4 * gamma * gamma + 0.25 * bend * bend;
  }
  return sum;
}

/// -dU/dvalue by differences of fourth order
template <class Energy>
double force(double& value, const Energy& all) {
  const double h = 1e-3;
  const double at = value;
  double f[4];
  const double steps[4] = {-2, -1, 1, 2};
  for (int k = 0; k < 4; ++k) {
    value = at + steps[k] * h;
    f[k] = all();
  }
  value = at;
  return -(f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * h);
}

/// Largest departure from the equations of motion of a small multiple of the mode about the compressed state,
/// by the full energy, over the largest force.
double residual(const ref::CompressedChain& chain, double number, const ref::ChainGrowthMode& mode) {
  const double strength = number / std::pow(2.0 * chain.spheres, 4);
  std::vector<double> x = ref::compressed_state(chain, number).positions;
  std::vector<double> y = mode.displacement;
  std::vector<double> angle = mode.rotation;
  const double small = 1e-4;
  for (double& each : y) each *= small;
  for (double& each : angle) each *= small;
  const auto all = [&] { return energy(x, y, angle, chain.poisson_ratio); };
  double worst = 0;
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double across = force(y[i], all) - 2 * strength * (mode.growth - chain.transverse_rate) * y[i];
    const double turning = force(angle[i], all) - 8.0 / 3 * strength * mode.growth * angle[i];
    worst = std::max({worst, std::abs(across), std::abs(turning)});
    const double rate = strength * (1 + std::abs(mode.growth));
    largest = std::max({largest, rate * std::abs(y[i]), rate * std::abs(angle[i])});
  }
  return worst / largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_thresholds_about_the_compressed_state) {
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({10, 0.3}, 1) - 128.1) < 0.06);
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({20, 0.3}, 1) - 124.62) < 0.006);
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({40, 0.3}, 1) - 123.78) < 0.006);
}

BOOST_AUTO_TEST_CASE(known_thresholds_without_stretch) {
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({10, 0.3, infinity}, 1) - 126.31) < 0.006);
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({20, 0.3, infinity}, 1) - 124.205) < 0.0005);
  BOOST_TEST(std::abs(ref::chain_buckling_threshold({40, 0.3, infinity}, 1) - 123.68) < 0.006);
}

BOOST_AUTO_TEST_CASE(known_growth_rates) {
  BOOST_TEST(std::abs(ref::chain_growth_mode({10, 0.3}, 200, 1).growth - 1.229) < 0.0006);
  BOOST_TEST(std::abs(ref::chain_growth_mode({20, 0.3}, 200, 1).growth - 1.463) < 0.0006);
  BOOST_TEST(std::abs(ref::chain_growth_mode({40, 0.3}, 200, 1).growth - 1.530) < 0.0006);
}

BOOST_AUTO_TEST_CASE(modes_move_as_the_full_energy_says) {
  for (const ref::CompressedChain& chain :
       {ref::CompressedChain{13, 0.17}, {10, 0.3}, {6, -0.4, 1, 0.5}, {3, 0.5, 1, 0}}) {
    for (const double number : {60.0, 137.0, 410.0}) {
      for (int mode = 0; mode <= std::min(4, chain.spheres - 2); ++mode) {
        const auto found = ref::chain_growth_mode(chain, number, mode);
        BOOST_TEST(residual(chain, number, found) < 1e-4,
                   "N " << chain.spheres << " mode " << mode << " at " << number);
        const ref::ChainGrowthMode wrong{found.growth + 0.01 * (1 + std::abs(found.growth)),
                                         found.displacement, found.rotation};
        BOOST_TEST(residual(chain, number, wrong) > 1e-3);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(modes_have_their_parity_and_no_translation) {
  for (const int n : {9, 14}) {
    for (int mode = 0; mode <= 5; ++mode) {
      const auto found = ref::chain_growth_mode({n, 0.21}, 300, mode);
      const double sign = mode % 2 == 1 ? 1 : -1;
      double sum = 0;
      for (std::size_t i = 0; i < found.displacement.size(); ++i) {
        const std::size_t j = found.displacement.size() - 1 - i;
        BOOST_TEST(std::abs(found.displacement[i] - sign * found.displacement[j]) < 1e-9);
        BOOST_TEST(std::abs(found.rotation[i] + sign * found.rotation[j]) < 1e-9);
        sum += found.displacement[i];
      }
      BOOST_TEST(std::abs(sum) < 1e-9);
      BOOST_TEST(found.displacement.back() == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(compressed_state_balances) {
  const ref::CompressedChain chain{13, 0.17};
  const double number = 140;
  const auto state = ref::compressed_state(chain, number);
  const double strength = number / std::pow(26.0, 4);
  for (std::size_t i = 0; i < 13; ++i) {
    const double right = i < 12 ? state.forces[i] : 0;
    const double left = i > 0 ? state.forces[i - 1] : 0;
    BOOST_TEST(std::abs(right - left - 2 * strength * state.positions[i]) < 1e-15);
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const double spacing = state.positions[i + 1] - state.positions[i];
    BOOST_TEST(2 * (spacing - 2) == state.forces[i], boost::test_tools::tolerance(1e-10));
    BOOST_TEST(state.forces[i] < 0);
  }
  const auto rigid = ref::compressed_state({13, 0.17, infinity}, number);
  BOOST_TEST(rigid.positions.front() == -12);
  BOOST_TEST(rigid.forces[6] / state.forces[6] > 1);  // the stretching chain has moved into slower flow
  BOOST_TEST(rigid.forces[6] / state.forces[6] < 1.02);
}

BOOST_AUTO_TEST_CASE(stiffening_the_stretch_tends_to_the_constraint) {
  const double limit = ref::chain_buckling_threshold({11, 0.3, infinity}, 1);
  const auto off = [&](double factor) {
    return ref::chain_buckling_threshold({11, 0.3, factor}, 1) / limit - 1;
  };
  BOOST_TEST(off(1) > 0.005);
  BOOST_TEST(off(10) / off(100) == 10, boost::test_tools::tolerance(0.05));
  BOOST_TEST(std::abs(off(1e6)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(many_spheres_tend_to_the_filament_at_second_order) {
  for (const int mode : {1, 2, 3}) {
    const auto off = [&](int n) {
      return ref::chain_buckling_threshold({n, 0.24}, mode) / ref::buckling_threshold(mode) - 1;
    };
    const double order = std::log2(off(31) / off(62));
    BOOST_TEST(order > 1.9, "mode " << mode);
    BOOST_TEST(order < 2.1, "mode " << mode);
  }
  const auto chain = ref::chain_growth_mode({90, 0.3, infinity}, 200, 1);
  const auto y = ref::filament_deflection(ref::filament_mode(200, 1).coefficients, {0.0, 89.0 / 180});
  // middle (between spheres 44 and 45) against the end
  BOOST_TEST(chain.displacement[44] == y[0] / y[1], boost::test_tools::tolerance(0.01));
  const auto across = [](double q) {
    return ref::chain_buckling_threshold({60, 0.3, infinity, q}, 1) / ref::buckling_threshold(1, q);
  };
  BOOST_TEST(across(0.5) == 1, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(across(0) == 1, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(stiff_chain_turns_as_a_jeffery_particle) {
  // rotation in the principal axes of planar extension grows at 2 Lambda
  for (const int n : {3, 10, 37}) {
    const double growth = ref::chain_growth_mode({n, 0.3, infinity}, 1e-2, 0).growth;
    BOOST_TEST(growth == 2 * ref::free_draining_bretherton(n), boost::test_tools::tolerance(1e-4));
  }
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({2, 0.3}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({301, 0.3}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({9, 0.6}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({9, -1}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({9, 0.3, 0}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({9, 0.3}, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_buckling_threshold({3, 0.3}, 2), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_growth_mode({9, 0.3}, 0, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_growth_mode({9, 0.3}, not_a_number, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_growth_mode({9, 0.3}, 200, -1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::chain_growth_mode({9, 0.3}, 200, 8), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::compressed_state({9, 0.3, 1, -1}, 200), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
