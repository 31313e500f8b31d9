// Thermoelastic branches of a round wire against the radial heat equation: solved in cells, and by Bessel
// functions of complex argument.
#include "dem/material/thermoelastic.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "dem/model/errors.hpp"
#include "tests/dem/material/alternation.hpp"

BOOST_AUTO_TEST_SUITE(thermoelastic_test)

namespace dem = fiberchain::dem;
using Complex = std::complex<double>;

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double diffusivity = 2.3e-5, radius = 41e-6, strength = 3.7e-3;
const double peak = dem::thermal_peak(diffusivity, radius);

/// Of the temperature theta(r) cos(phi) at a strain r cos(phi), R = D = 1, the source -i Omega r:
/// K / K_inf = 1 - Delta 4 int theta r^2 dr. `cells` rings.
Complex modulus_in_cells(double Omega, int cells) {
  const double h = 1.0 / cells;
  const Complex s{0, Omega};
  std::vector<Complex> diagonal(cells), theta(cells);
  for (int i = 0; i < cells; ++i) {  // multiplied by r h; Thomas's elimination
    const double r = (i + 0.5) * h, inner = i, outer = i + 1 < cells ? i + 1 : 0;  // r / h at the faces
    diagonal[i] = s * r * h + inner + outer + h / r;
    theta[i] = -s * r * r * h;
    if (i == 0) continue;
    const Complex factor = inner / diagonal[i - 1];
    diagonal[i] -= factor * inner;
    theta[i] += factor * theta[i - 1];
  }
  Complex moment = 0;
  for (int i = cells - 1; i >= 0; --i) {
    if (i + 1 < cells) theta[i] += static_cast<double>(i + 1) * theta[i + 1];
    theta[i] /= diagonal[i];
    moment += theta[i] * std::pow((i + 0.5) * h, 2) * h;
  }
  return 1.0 - 4 * strength * moment;
}

/// The same exactly: theta = A I_1(z r) - r, z^2 = i Omega, theta' = 0 at the surface, so
/// K / K_inf = 1 + Delta (1 - 4 I_2 / (z (I_1 + z I_2))), I_2 / I_1 as a continued fraction.
Complex exact_modulus(double Omega) {
  const Complex z = std::sqrt(Complex{0, Omega});
  Complex ratio = 0;
  for (int order = 60 + static_cast<int>(2 * std::abs(z)); order >= 2; --order) {
    ratio = 1.0 / (2.0 * order / z + ratio);
  }
  return 1.0 + strength * (1.0 - 4.0 * ratio / (z * (1.0 + z * ratio)));
}

double omega_over_diffusion(double frequency) { return turn * frequency * radius * radius / diffusivity; }

/// Of tan delta.
double error(const dem::PronySeries& series, double frequency) {
  const Complex exact = exact_modulus(omega_over_diffusion(frequency));
  return loss_factor(series, turn * frequency) / (exact.imag() / exact.real()) - 1;
}

dem::PronySeries fitted(double over_peak, double tolerance = 0.01) {
  return dem::thermoelastic_branches(strength, diffusivity, radius, over_peak * peak, tolerance);
}

std::vector<double> extremes(const dem::PronySeries& series, double over_peak) {
  return alternating_extremes([&](double f) { return error(series, f); }, 1e-4 * peak, over_peak * peak,
                              3000);
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

}  // namespace

BOOST_AUTO_TEST_CASE(closed_form_is_that_of_the_heat_equation) {
  for (const double Omega : {0.21, 3.4, 87.0}) {
    const Complex cells = (4.0 * modulus_in_cells(Omega, 2000) - modulus_in_cells(Omega, 1000)) / 3.0;
    BOOST_TEST(std::abs(cells - exact_modulus(Omega)) < 1e-8 * strength);
  }
}

BOOST_AUTO_TEST_CASE(all_thermal_modes_are_the_closed_form) {
  const dem::PronySeries modes = dem::thermal_modes(strength, diffusivity, radius, 2000);
  BOOST_TEST(unrelaxed_modulus(modes) - 1 == strength, boost::test_tools::tolerance(1e-10));
  for (const double over_peak : {1e-3, 0.3, 1.0, 17.0, 1e3, 1e5}) {
    const Complex exact = exact_modulus(omega_over_diffusion(over_peak * peak));
    const Complex sum = complex_modulus(modes, {0, turn * over_peak * peak});
    BOOST_TEST(sum.imag() == exact.imag(), boost::test_tools::tolerance(1e-8));
    BOOST_TEST(std::abs(sum - exact) < 1e-9 * strength);
  }
}

BOOST_AUTO_TEST_CASE(surface_is_insulated_in_every_mode) {
  const dem::PronySeries modes = dem::thermal_modes(strength, diffusivity, radius, 700);
  for (std::size_t k = 1; k <= modes.size(); ++k) {
    const double q = radius / std::sqrt(diffusivity * modes[k - 1].time);
    BOOST_TEST(std::abs(q - (static_cast<double>(k) - 0.25) * std::numbers::pi) < 0.52);  // none is left out
    const double slope = std::cyl_bessel_j(0, q) - std::cyl_bessel_j(1, q) / q;
    BOOST_TEST(std::abs(slope) * std::sqrt(q) < 1e-12 * q, k << ": " << slope);
  }
}

BOOST_AUTO_TEST_CASE(first_mode) {
  BOOST_TEST(peak * radius * radius / diffusivity == 0.539529, boost::test_tools::tolerance(1e-6));
  const dem::PronySeries one = dem::thermal_modes(strength, diffusivity, radius, 1);
  BOOST_TEST(turn * peak * one[0].time == 1, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(one[0].strength / strength == 0.987428, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(fewest_branches_with_the_least_largest_error) {
  struct Case {
    double over_peak;
    std::size_t branches;
    double error;
  };
  for (const Case& expected : {Case{1, 1, 1.085e-4},
                               {10, 2, 7.82e-5},
                               {1e2, 2, 5.738e-3},
                               {1e3, 3, 2.506e-3},
                               {1e4, 3, 4.02e-3},
                               {1e5, 3, 4.61e-3}}) {
    const dem::PronySeries series = fitted(expected.over_peak);
    check(series);
    BOOST_TEST(series.size() == expected.branches);
    const std::vector<double> found = extremes(series, expected.over_peak);
    BOOST_TEST(largest(found) == expected.error, boost::test_tools::tolerance(5e-3));
    BOOST_TEST(found.size() == 2 * expected.branches + 1);
    for (const double e : found) BOOST_TEST(e == largest(found), boost::test_tools::tolerance(5e-3));
  }
}

BOOST_AUTO_TEST_CASE(literal_modes_need_many_more) {
  dem::PronySeries modes = dem::thermal_modes(strength, diffusivity, radius, 15);
  BOOST_TEST(largest(extremes(modes, 1e4)) < 0.01);
  modes.pop_back();
  BOOST_TEST(largest(extremes(modes, 1e4)) > 0.01);
}

BOOST_AUTO_TEST_CASE(tolerances_are_kept) {
  for (const double tolerance : {1.0, 0.1, 0.03, 0.01, 0.003, 0.001}) {
    for (const double over_peak : {1e-3, 0.4, 3.0, 27.0, 5e2, 3e4, 1e6}) {
      const dem::PronySeries series = fitted(over_peak, tolerance);
      BOOST_TEST(largest(extremes(series, over_peak)) < 1.02 * tolerance, over_peak << ", " << tolerance);
      BOOST_TEST(series.size() <= 5);
    }
  }
  BOOST_TEST(largest(extremes(fitted(1e9), 1e8)) < 0.0051);
}

BOOST_AUTO_TEST_CASE(from_a_data_sheet) {
  const dem::ThermalProperties properties{1.31e-5, 305, 447, 57};
  const double E = 2.07e11, density = 7910;
  BOOST_TEST(
      dem::relaxation_strength(properties, E, density) == 2.07e11 * 1.31e-5 * 1.31e-5 * 305 / (7910 * 447.0),
      boost::test_tools::tolerance(1e-14));
  BOOST_TEST(dem::thermal_diffusivity(properties, density) == 57 / (7910 * 447.0),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(senseless_values_are_refused) {
  const dem::ThermalProperties steel{1.31e-5, 305, 447, 57};
  for (const double bad : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    BOOST_CHECK_THROW(dem::relaxation_strength(steel, bad, 7910), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::relaxation_strength(steel, 2e11, bad), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::relaxation_strength({1e-5, bad, 447, 57}, 2e11, 7910), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::relaxation_strength({1e-5, 305, bad, 57}, 2e11, 7910), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::thermal_diffusivity({1e-5, 305, 447, bad}, 7910), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::thermal_peak(bad, 1e-3), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::thermal_peak(1e-5, bad), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::thermoelastic_branches(1e-3, 1e-5, 1e-3, bad), dem::InvalidInput);
    BOOST_CHECK_THROW(dem::thermoelastic_branches(1e-3, 1e-5, 1e-3, 10, bad), dem::InvalidInput);
  }
  BOOST_CHECK_THROW(dem::relaxation_strength({0.1, 305, 447, 57}, 2e11, 7910), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::relaxation_strength({NAN, 305, 447, 57}, 2e11, 7910), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::thermoelastic_branches(-1e-3, 1e-5, 1e-3, 10), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::thermoelastic_branches(1.1, 1e-5, 1e-3, 10), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::thermal_modes(1e-3, 1e-5, 1e-3, 0), dem::InvalidInput);
  BOOST_TEST(dem::relaxation_strength({0, 305, 447, 57}, 2e11, 7910) == 0);
  BOOST_TEST(dem::thermoelastic_branches(0, 1e-5, 1e-3, 10).empty());
}

BOOST_AUTO_TEST_SUITE_END()
