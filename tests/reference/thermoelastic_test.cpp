// Thermoelastic damping of a round wire: Bessel functions, the series of thermal modes and a direct solution
// of the heat equation, each against the others.
#include "reference/thermoelastic.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(thermoelastic_test)

namespace ref = fiberchain::reference;
using Complex = std::complex<double>;

namespace {

/// A made-up metal: Delta = 0.0203, D = 3.1e-5 m^2/s.
constexpr ref::ThermoelasticWire odd_wire{37e-6, 131e9, 2.3e-5, 340, 4300, 270, 36};

double diffusion_time() { return 37e-6 * 37e-6 * 4300 * 270 / 36; }

/// The part of Delta that is not relaxed, as a function of s R^2/D.
Complex unrelaxed(Complex x) {
  const Complex k = ref::thermoelastic_modulus(odd_wire)(x / diffusion_time()).value;
  return (k - 1.0) / ref::relaxation_strength(odd_wire);
}

Complex unrelaxed_by_series(Complex x, int terms) {
  Complex sum = 0;
  for (int k = 1; k <= terms; ++k) {
    const double q = ref::thermal_mode_zero(k);
    sum += ref::thermal_mode_weight(k) * x / (q * q + x);
  }
  return sum;
}

/// x (theta + rho) = (rho theta')'/rho - theta/rho^2 on 0 < rho < 1, theta' = 0 at 1, by finite volumes, and
/// 1 - 4 int theta rho^2 d rho.
Complex unrelaxed_by_volumes(Complex x, int cells) {
  const double h = 1.0 / cells;
  const auto n = static_cast<std::size_t>(cells);
  std::vector<Complex> upper(n), theta(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double rho = (static_cast<double>(i) + 0.5) * h;
    const double in = (rho - h / 2) / h;
    const double out = i + 1 == n ? 0 : (rho + h / 2) / h;
    const Complex diagonal = -in - out - h / rho - x * rho * h;
    const Complex before_upper = i == 0 ? 0 : upper[i - 1];
    const Complex before = i == 0 ? 0 : theta[i - 1];
    const Complex pivot = diagonal - in * before_upper;
    upper[i] = out / pivot;
    theta[i] = (x * rho * rho * h - in * before) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) theta[i] -= upper[i] * theta[i + 1];
  Complex moment = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double rho = (static_cast<double>(i) + 0.5) * h;
    moment += theta[i] * rho * rho * h;
  }
  return -4.0 * moment;
}

}  // namespace

BOOST_AUTO_TEST_CASE(zeros_of_the_bessel_slope) {
  // mpmath.besseljzero(1, k, derivative=1)
  constexpr std::array<double, 5> zeros{1.8411837813406593, 5.33144277352503264, 8.53631636634628583,
                                        11.7060049025920641, 14.8635886339090331};
  for (int k = 1; k <= 5; ++k) {
    BOOST_TEST(ref::thermal_mode_zero(k) == zeros[static_cast<std::size_t>(k - 1)],
               boost::test_tools::tolerance(1e-14));
  }
  BOOST_TEST(ref::thermal_mode_zero(40) == 124.871300582387884, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(weights_add_up_to_one) {
  // what is left out beyond N is near 8/(3 pi^4 N^3)
  double sum = 0;
  for (int k = 1; k <= 300; ++k) sum += ref::thermal_mode_weight(k);
  const double rest = 8 / (3 * std::pow(std::numbers::pi, 4) * std::pow(300.25, 3));
  BOOST_TEST(std::abs(1 - sum - rest) < 0.01 * rest);
  BOOST_TEST_MESSAGE("weights " << ref::thermal_mode_weight(1) << ", " << ref::thermal_mode_weight(2));
  BOOST_TEST(ref::thermal_mode_weight(1) > 0.98);
}

BOOST_AUTO_TEST_CASE(closed_form_in_other_hands) {
  // mpmath's besseli with 30 digits
  struct Row {
    Complex x, value;
  };
  const std::array<Row, 5> rows{{{{-0.02, 0.3}, {0.00194307664139340732, 0.0878451906151236952}},
                                 {{-0.5, 3.39}, {0.499900089275159586, 0.573171930161371187}},
                                 {{-7, 330}, {0.999752397669869589, 0.0116598609210860714}},
                                 {{-900, 33900}, {1.00000265806253698, 0.000117476555399543021}},
                                 {{0, 3.39e8}, {0.999999999999546829, 1.17989568758861794e-8}}}};
  const double delta = ref::relaxation_strength(odd_wire);
  for (const Row& row : rows) {
    const Complex got = unrelaxed(row.x);
    BOOST_TEST(std::abs(got.real() - row.value.real()) < 1e-15 / delta * 3);
    BOOST_TEST(got.imag() == row.value.imag(), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(closed_form_is_the_sum_of_the_thermal_modes) {
  // 4000 modes leave out less than the 8/(3 pi^4 4000^3) = 4e-13 of the weights
  for (const Complex x : {Complex{0, 0.02}, Complex{-0.3, 3.4}, Complex{2, 45}, Complex{-100, 3.4e4}}) {
    BOOST_TEST(std::abs(unrelaxed(x) - unrelaxed_by_series(x, 4000)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(closed_form_solves_the_heat_equation) {
  for (const Complex x : {Complex{0, 0.1}, Complex{-0.4, 3.4}, Complex{0, 60}, Complex{-20, 900}}) {
    const Complex exact = unrelaxed(x);
    const double coarse = std::abs(unrelaxed_by_volumes(x, 300) - exact) / std::abs(exact);
    const double fine = std::abs(unrelaxed_by_volumes(x, 600) - exact) / std::abs(exact);
    BOOST_TEST(fine < 3e-5);
    BOOST_TEST(coarse > 3 * fine);
    BOOST_TEST(coarse < 5 * fine);
  }
}

BOOST_AUTO_TEST_CASE(limits_of_slow_and_fast_bending) {
  // slow: 7/24 s R^2/D; fast: loss 4 D/(omega R^2) (1 - sqrt(D/(2 omega R^2)))
  BOOST_TEST(std::abs(unrelaxed({0, 1e-4}) - Complex(0, 7e-4 / 24)) < 1e-8);
  const double x = 1e7;
  BOOST_TEST(unrelaxed({0, x}).imag() == 4 / x * (1 - 1 / std::sqrt(2 * x)),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(unrelaxed({0, x}).imag() != 4 / x, boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(slope_is_the_derivative) {
  const ref::ComplexModulus k = ref::thermoelastic_modulus(odd_wire);
  for (const Complex x : {Complex{-0.05, 0.4}, Complex{-1, 30}}) {
    const Complex s = x / diffusion_time();
    const double h = 1e-4 * std::abs(s);
    const Complex difference = (k(s + h).value - k(s - h).value) / (2 * h);
    BOOST_TEST(std::abs(difference - k(s).slope) < 1e-6 * std::abs(difference));
  }
  const Complex start = k(0).slope;
  BOOST_TEST(std::abs(start - k({0, 1e-7 / diffusion_time()}).slope) < 1e-6 * std::abs(start));
}

BOOST_AUTO_TEST_CASE(strength_and_peak_from_the_data_sheet) {
  BOOST_TEST(ref::relaxation_strength(odd_wire) == 131e9 * 2.3e-5 * 2.3e-5 * 340 / (4300.0 * 270),
             boost::test_tools::tolerance(1e-14));
  const double d = ref::thermal_diffusivity(odd_wire);
  BOOST_TEST(d == 36.0 / (4300 * 270), boost::test_tools::tolerance(1e-14));
  const double f0 = ref::thermoelastic_peak(odd_wire);
  BOOST_TEST(f0 * 37e-6 * 37e-6 / d == 0.5395, boost::test_tools::tolerance(1e-4));
  const ref::PronySeries zener = ref::zener_series(odd_wire);
  BOOST_TEST(zener.size() == 1U);
  const double omega = 2 * std::numbers::pi * f0;
  BOOST_TEST(omega * zener[0].time == 1, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(zener[0].strength == ref::relaxation_strength(odd_wire));
}

BOOST_AUTO_TEST_CASE(zener_against_the_exact_loss) {
  // K''/Delta over x/(1 + x^2), x = f/f_0
  const auto ratio = [](double x) {
    const double q = ref::thermal_mode_zero(1);
    return unrelaxed({0, x * q * q}).imag() * (1 + x * x) / x;
  };
  for (const double x : {1e-2, 1.0, 1e2, 1e4})
    BOOST_TEST_MESSAGE("exact over Zener at " << x << ": " << ratio(x));
  BOOST_TEST(std::abs(ratio(1e-2) - 0.9887) < 1e-4);
  BOOST_TEST(std::abs(ratio(1) - 0.9900) < 1e-4);
  BOOST_TEST(ratio(1e4) > 1.16);
  BOOST_TEST(ratio(1e4) < 1.18);
}

BOOST_AUTO_TEST_CASE(terms_for_one_percent) {
  for (const double x : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
    const int terms = ref::thermoelastic_terms(x, 0.01);
    BOOST_TEST_MESSAGE("f/f0 " << x << ": " << terms << " terms for 1 %");
    const double q = ref::thermal_mode_zero(1);
    const Complex at{0, x * q * q};
    const double exact = unrelaxed(at).imag();
    BOOST_TEST(std::abs(unrelaxed_by_series(at, terms).imag() / exact - 1) <= 0.01);
    if (terms > 1) BOOST_TEST(std::abs(unrelaxed_by_series(at, terms - 1).imag() / exact - 1) > 0.01);
  }
}

BOOST_AUTO_TEST_CASE(modes_of_a_wire) {
  // the exact modulus and 20 thermal modes give nearly the same roots, first to fifth mode, below to above
  // the peak
  for (const double aspect : {13.0, 130.0, 1300.0}) {
    const ref::UniformBeam beam = ref::wire_beam(odd_wire, aspect * 2 * 37e-6);
    BOOST_TEST(beam.bending == 131e9 * std::numbers::pi * std::pow(37e-6, 4) / 4,
               boost::test_tools::tolerance(1e-13));
    const auto exact =
        ref::complex_beam_modes(beam, ref::thermoelastic_modulus(odd_wire), ref::ChainEnds::clamped_free, 5);
    const auto series = ref::complex_beam_modes(
        beam, ref::complex_modulus(ref::thermoelastic_series(odd_wire, 20)), ref::ChainEnds::clamped_free, 5);
    for (std::size_t k = 0; k < 5; ++k) {
      const ref::FreeDecay& decay = exact[k].decay;
      BOOST_TEST_MESSAGE("f/f0 " << decay.frequency / (2 * std::numbers::pi) /
                                        ref::thermoelastic_peak(odd_wire)
                                 << ": zeta " << decay.damping << ", less tan delta/2 " << decay.difference);
      BOOST_TEST(series[k].decay.damping == decay.damping, boost::test_tools::tolerance(3e-3));
      BOOST_TEST(series[k].decay.damping != decay.damping, boost::test_tools::tolerance(1e-11));
      BOOST_TEST(std::abs(decay.difference) < 0.01 * decay.damping);
    }
  }
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  ref::ThermoelasticWire wire = odd_wire;
  wire.conductivity = 0;
  BOOST_CHECK_THROW(ref::thermoelastic_modulus(wire), ref::InvalidArgument);
  wire = odd_wire;
  wire.expansion = NAN;
  BOOST_CHECK_THROW(ref::relaxation_strength(wire), ref::InvalidArgument);
  wire = odd_wire;
  wire.expansion = -2.3e-5;
  BOOST_TEST(ref::relaxation_strength(wire) == ref::relaxation_strength(odd_wire));
  BOOST_CHECK_THROW(ref::thermal_mode_zero(0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::thermoelastic_series(odd_wire, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::thermoelastic_terms(-1, 0.01), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::wire_beam(odd_wire, 0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
