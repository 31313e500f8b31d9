// Damping of the fiber: the marched chain against its linear modes, the paper's statements, the damped
// Elastica.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "compare/damping/references.hpp"
#include "compare/damping/table.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/first_mode_filter.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "tests/compare/elastica_error.hpp"

BOOST_AUTO_TEST_SUITE(damping_test)

using namespace fiberchain;
using compare::DampingCase;
using compare::DampingPoint;
using std::numbers::pi;

namespace {

DampingPoint point(const DampingCase& asked) {
  compare::DampingOptions options;
  options.elastica = false;
  return compare::damping_points({asked}, options).front();
}

}  // namespace

BOOST_AUTO_TEST_CASE(marched_damping_at_vanishing_load_is_that_of_the_linear_chain) {
  for (const int aspect_ratio : {5, 13, 24}) {
    for (const double nu : {-0.1, 0.17, 0.43}) {
      for (const double damping : {0.01, 0.6, 3.0}) {
        for (const auto bond : {dem::BondModel::paper, dem::BondModel::corrected}) {
          const DampingPoint p = point({.aspect_ratio = aspect_ratio,
                                        .poisson_ratio = nu,
                                        .load = 1e-5,
                                        .bond_damping = damping,
                                        .bond = bond});
          BOOST_TEST_CONTEXT("r_f " << aspect_ratio << " nu " << nu << " xi_b " << damping) {
            BOOST_TEST(std::abs(p.damping / p.damping_modes - 1) < 2e-4);
            BOOST_TEST(std::abs(p.frequency / p.frequency_modes - 1) < 1e-4);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(closed_form_is_within_a_quarter_percent_from_aspect_ratio_5) {
  for (const int aspect_ratio : {5, 8, 13, 60}) {
    for (const double nu : {0.0, 0.17, 0.49}) {
      const double modes = reference::first_bending_mode(
                               compare::linear_chain_of({.aspect_ratio = aspect_ratio, .poisson_ratio = nu}))
                               .damping;
      const double off = reference::first_bending_damping(aspect_ratio, 1.0) / modes - 1;
      BOOST_TEST(std::abs(off) < 0.0025);
    }
  }
}

BOOST_AUTO_TEST_CASE(numbers_of_the_papers_figures) {
  BOOST_TEST(std::abs(point({.aspect_ratio = 8, .load = 0.01}).damping - 0.010885) < 1e-6);
  BOOST_TEST(std::abs(point({.aspect_ratio = 10, .load = 0.01}).damping - 0.007132) < 1e-6);
  // peaks 1..10 after the release, r_f = 10, xi_b = 1
  const double load[] = {0.05, 0.76, 1.46, 2.17}, found[] = {0.00715, 0.00703, 0.00679, 0.00650};
  for (int i = 0; i < 4; ++i) BOOST_TEST(std::abs(point({.load = load[i]}).damping_paper - found[i]) < 6e-6);
  // the point of release among the peaks: 5 to 9 % high
  const double with_release = point({.load = 0.05, .peaks = {0, 4}}).damping_paper / 0.0071324 - 1;
  BOOST_TEST(with_release > 0.05);
  BOOST_TEST(with_release < 0.0925);
}

BOOST_AUTO_TEST_CASE(parts_of_the_budget_add_up) {
  const DampingPoint p = point({.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 1.1, .bond_damping = 0.7});
  const compare::DampingBudget& b = p.budget;
  const double sum = b.discretization + b.shear + b.time_step + b.amplitude + b.peak_fit;
  BOOST_TEST(std::abs(sum - (p.damping_paper / p.damping_beam - 1)) < 1e-12);
  BOOST_TEST(b.amplitude < -0.005);
  BOOST_TEST(std::abs(b.time_step) < 2e-4);
  // finite bonds and half a sphere more at the end: about (r_f / (r_f + 1/2))^2
  BOOST_TEST(std::abs(b.discretization - (std::pow(13 / 13.5, 2) - 1)) < 0.001);
}

BOOST_AUTO_TEST_CASE(two_routes_to_the_damping_agree) {
  for (const double load : {0.01, 0.05}) {
    const DampingPoint p =
        point({.aspect_ratio = 9, .poisson_ratio = 0.17, .load = load, .bond_damping = 0.8});
    BOOST_TEST(std::abs(p.damping_sine / p.damping - 1) < 3e-4);
  }
}

BOOST_AUTO_TEST_CASE(fiber_damping_is_proportional_to_bond_damping) {
  const double slope = point({.aspect_ratio = 9, .load = 1e-4, .bond_damping = 0.1}).damping / 0.1;
  for (const double damping : {0.02, 0.5, 2.0}) {
    const double here = point({.aspect_ratio = 9, .load = 1e-4, .bond_damping = damping}).damping / damping;
    BOOST_TEST(std::abs(here / slope - 1) < 3e-4);
  }
}

BOOST_AUTO_TEST_CASE(dashpot_laws_are_measured_as_their_linear_chain_says) {
  for (const auto law : {dem::DashpotLaw::retardation_time, dem::DashpotLaw::bending_only}) {
    const DampingPoint p =
        point({.aspect_ratio = 9, .poisson_ratio = 0.17, .load = 1e-4, .dashpots = law, .bond_damping = 0.9});
    BOOST_TEST(std::abs(p.damping / p.damping_modes - 1) < 2e-4);
  }
  const dem::Table table = compare::dashpot_table(10, 0.3);
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    if (table.text(row, "motion") == "bending" && table.number(row, "mode") == 1) {
      BOOST_TEST(std::abs(table.number(row, "mode_damping") - 0.0071324) < 1e-6);
    }
  }
}

namespace {

/// |sum w y exp(-i omega t)| with a Hann window.
double spectrum(const compare::TipHistory& h, double omega) {
  std::complex<double> sum = 0;
  const double span = h.time.back();
  for (std::size_t i = 0; i < h.time.size(); ++i) {
    sum += (1 - std::cos(2 * pi * h.time[i] / span)) * h.y[i] * std::polar(1.0, -omega * h.time[i]);
  }
  return std::abs(sum);
}

double spectral_peak(const compare::TipHistory& h, double near) {
  double low = 0.98 * near, high = 1.02 * near;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (spectrum(h, a) < spectrum(h, b) ? low : high) = spectrum(h, a) < spectrum(h, b) ? a : b;
  }
  return (low + high) / 2;
}

}  // namespace

BOOST_AUTO_TEST_CASE(large_motion_approaches_the_damped_elastica_at_second_order) {
  // one and the same beam: its retardation time is that of xi_b = 1 at r_f = 10, and xi_b grows as r_f^2
  const double ten = test::elastica_error(10, 1.0), twenty = test::elastica_error(20, 4.0);
  BOOST_TEST_MESSAGE("max |dr|/L at r_f = 10, 20: " << ten << " " << twenty);
  BOOST_TEST(std::log2(ten / twenty) > 1.85);
  BOOST_TEST(std::log2(ten / twenty) < 2.15);
}

BOOST_AUTO_TEST_CASE(at_a_fixed_bond_damping_the_beam_itself_changes_and_the_order_is_lower) {
  // xi_b = 1 throughout: xi_f falls as 1/r_f^2, so the longer chain keeps more of its amplitude and of its
  // mode 2
  const double order = std::log2(test::elastica_error(10, 1.0) / test::elastica_error(20, 1.0));
  BOOST_TEST(order > 1.59);
  BOOST_TEST(order < 1.69);
}

BOOST_AUTO_TEST_CASE(three_bending_frequencies_by_spectral_analysis) {
  const DampingCase asked{.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 1e-4, .bond_damping = 1e-4};
  const auto modes = reference::chain_modes(compare::linear_chain_of(asked), reference::ChainMotion::bending,
                                            reference::ChainEnds::clamped_free);
  const dem::Fiber fiber = compare::damped_fiber(asked);
  for (int n = 0; n < 3; ++n) {
    const double periods = 60;  // of this mode
    dem::Release<2> release = compare::static_release(fiber, modes[0], asked.load, 1);
    release.period = 2 * pi / modes[n].eigenvalue.imag();
    release.periods = periods;
    dem::ReleaseOptions options;
    options.samples_per_period = 24;
    options.step_ratio = 0.1;
    const auto history =
        compare::tip_history(dem::ring_down<2>({release}, options)[0], dem::fiber_length(fiber));
    const double found = spectral_peak(history, modes[n].eigenvalue.imag());
    BOOST_TEST(std::abs(found / modes[n].eigenvalue.imag() - 1) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(an_undamped_release_keeps_its_energy_over_a_thousand_periods) {
  dem::Fiber fiber = compare::damped_fiber({.aspect_ratio = 10});
  fiber.bond_damping = 0;
  const auto mode = reference::first_bending_mode(
      compare::linear_chain_of(compare::DampingCase{.aspect_ratio = 10, .bond_damping = 1e-9}));
  dem::ReleaseOptions options;
  options.form = dem::BondForm::total;
  options.samples_per_period = 8;
  options.step_ratio = 0.25;
  options.energy = true;
  const auto record = dem::ring_down<2>({compare::static_release(fiber, mode, 1e-3, 1000)}, options)[0];
  const double n = static_cast<double>(record.samples.size()), start = record.samples[0].energy;
  double mean_t = 0, mean_e = 0, tt = 0, te = 0, worst = 0;
  for (const auto& s : record.samples)
    mean_t += s.time / (2 * pi / mode.eigenvalue.imag()) / n, mean_e += s.energy / start / n;
  for (const auto& s : record.samples) {
    const double t = s.time / (2 * pi / mode.eigenvalue.imag()) - mean_t, e = s.energy / start - mean_e;
    tt += t * t;
    te += t * e;
    worst = std::max(worst, std::abs(s.energy / start - 1));
  }
  BOOST_TEST_MESSAGE("energy: slope per period / (4 pi E) " << te / tt / (4 * pi) << ", largest change "
                                                            << worst);
  BOOST_TEST(std::abs(te / tt / (4 * pi)) < 1e-10);
  BOOST_TEST(worst < 1e-4);
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_threads_or_neighbors) {
  compare::DampingOptions one, two;
  one.elastica = two.elastica = false;
  two.jobs = 2;
  const std::vector<DampingCase> several{
      {.aspect_ratio = 6, .load = 0.05}, {.aspect_ratio = 6, .load = 0.3}, {.aspect_ratio = 9, .load = 0.05}};
  const auto a = compare::damping_points(several, one), b = compare::damping_points(several, two);
  const DampingPoint alone = point(several[1]);
  for (std::size_t i = 0; i < several.size(); ++i) BOOST_TEST(a[i].damping == b[i].damping);
  BOOST_TEST(alone.damping == a[1].damping);
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_measured) {
  BOOST_CHECK_THROW(point({.bond_damping = -1}), dem::InvalidInput);
  BOOST_CHECK_THROW(point({.bond_damping = 0}), compare::InputError);
  BOOST_CHECK_THROW(point({.load = 0}), compare::InputError);
  BOOST_CHECK_THROW(point({.peaks = {3, 3}}), compare::InputError);
  const DampingPoint overdamped = point({.aspect_ratio = 2, .bond_damping = 50});
  BOOST_TEST(std::isnan(overdamped.damping));
  BOOST_TEST(overdamped.status != "measured");
  BOOST_CHECK_THROW(compare::damping_from_peaks({{0, 1.0}}, {0, 1}), compare::InputError);
  BOOST_CHECK_THROW(compare::damping_from_peaks({{0, 1.0}, {1, 1.0}, {2, 1.0}}, {0, 2}), compare::InputError);
}

// From a hundredth to half of critical, let go from equilibrium: the first mode's damping, whatever the
// others do.
BOOST_AUTO_TEST_CASE(the_first_mode_is_parted_from_the_others_at_every_damping) {
  for (const double damping : {0.002, 0.05, 0.3, 1.0, 1.6, 3.0, 10.0, 30.0, 60.0}) {
    for (const auto& [aspect_ratio, nu] : {std::pair{10, 0.3}, std::pair{7, 0.1}}) {
      if (aspect_ratio == 7 && damping > 30) continue;  // nine tenths of critical
      const DampingPoint p = point({.aspect_ratio = aspect_ratio,
                                    .poisson_ratio = nu,
                                    .load = 0.02,
                                    .bond_damping = damping,
                                    .peaks = {0, 2}});
      BOOST_TEST_CONTEXT("r_f " << aspect_ratio << " xi_b " << damping << " " << p.status) {
        BOOST_TEST(std::abs(p.damping / p.damping_modes - 1) < 2e-4);
        BOOST_TEST(std::abs(p.frequency / p.frequency_modes - 1) < 5e-4);
        if (std::isfinite(p.damping_sine)) BOOST_TEST(std::abs(p.damping_sine / p.damping - 1) < 1e-3);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(light_damping_at_large_load_is_the_damped_elasticas) {
  const auto p = compare::damping_points({{.load = 0.6, .bond_damping = 0.05}}).front();
  BOOST_TEST(std::abs(p.damping / p.damping_elastica - 1) < 6e-3);                       // finite bonds
  BOOST_TEST(std::abs(p.damping_elastica / p.damping_closed_form - 1 + 0.014) < 0.006);  // the amplitude
}

BOOST_AUTO_TEST_CASE(heavy_damping_is_measured_where_it_can_be_and_only_what_was_asked_for_is_spoken_of) {
  const DampingPoint heavy =
      point({.aspect_ratio = 9, .poisson_ratio = 0.2, .load = 2, .bond_damping = 60, .peaks = {0, 2}});
  BOOST_TEST(heavy.status == "measured");
  // of the small peaks behind the release, counted from the bend that the incremental form leaves
  BOOST_TEST(std::abs(heavy.damping / heavy.damping_modes - 1) < 1e-4);
  BOOST_TEST(std::isfinite(heavy.damping_paper));
  const DampingPoint more =
      point({.aspect_ratio = 9, .poisson_ratio = 0.2, .load = 0.5, .bond_damping = 85, .peaks = {0, 1}});
  BOOST_TEST(std::isnan(more.damping));
  BOOST_TEST(std::isfinite(more.damping_paper));
  BOOST_TEST(more.status ==
             "measured, but not without mode 2: higher modes outlive the first, which cannot be "
             "seen alone");
}

BOOST_AUTO_TEST_CASE(a_motion_of_two_modes_is_filtered) {
  const double w = 7.3, xi = 0.0008, period = 2 * pi / w;
  compare::TipHistory h;
  for (int i = 0; i <= 2600; ++i) {
    const double t = i * period / 200, e = std::exp(-xi * w * t), f = 0.03 * std::exp(-xi * 39 * w * t);
    const double w2 = 6.27 * w;
    h.time.push_back(t);
    h.y.push_back(e * std::cos(w * t) + f * std::cos(w2 * t));
    h.velocity.push_back(e * (-xi * w * std::cos(w * t) - w * std::sin(w * t)) +
                         f * (-xi * 39 * w * std::cos(w2 * t) - w2 * std::sin(w2 * t)));
  }
  const auto raw = compare::damping_from_peaks(compare::positive_peaks(h), {4, 9});
  BOOST_TEST(std::abs(raw.ratio / (xi / std::sqrt(1 + xi * xi)) - 1) > 0.01);  // what the filter is for
  const compare::CleanPeaks clean{compare::CleanPeaks::Way::filter, {4, 9}};
  const auto found = compare::first_mode_damping(h, clean, 1.002 * w);
  BOOST_TEST(std::abs(found.peaks.ratio / (xi / std::sqrt(1 + xi * xi)) - 1) < 1e-5);
  BOOST_TEST(std::abs(found.peaks.frequency / w - 1) < 1e-6);
  BOOST_TEST(std::abs(found.measured.front().time / (4 * period) - 1) < 1e-3);
  for (std::size_t i = 0; i < h.time.size(); ++i) {  // a third harmonic goes with the cube of the swing
    const double e = 0.2 * std::exp(-3 * xi * w * h.time[i]), a = 3 * w * h.time[i];
    h.y[i] += e * std::cos(a), h.velocity[i] -= e * (3 * xi * w * std::cos(a) + 3 * w * std::sin(a));
  }
  // ln(e + 0.2 e^3) falls by d ln e (1 + 0.6 e^2) / (1 + 0.2 e^2)
  const auto peak = [&](int n) {
    const double e = std::exp(-xi * w * period * n);
    return e + 0.2 * e * e * e;
  };
  const double delta = std::log(peak(4) / peak(9)) / 5;
  const auto swung = compare::first_mode_damping(h, clean, 1.002 * w);
  BOOST_TEST(std::abs(swung.peaks.ratio / compare::damping_ratio(delta) - 1) < 2e-4);
  h.time.resize(1000), h.y.resize(1000), h.velocity.resize(1000);
  BOOST_CHECK_THROW(compare::first_mode_part(h, w), compare::InputError);
}

BOOST_AUTO_TEST_CASE(peaks_of_a_known_motion) {
  // y = exp(-xi w t) cos(w_d t + phi) started at rest, sampled 40 times a period
  const double xi = 0.013, w = 7.3, w_d = w * std::sqrt(1 - xi * xi),
               phi = -std::atan(xi / std::sqrt(1 - xi * xi));
  compare::TipHistory h;
  for (int i = 0; i < 500; ++i) {
    const double t = i * 2 * pi / w_d / 40, e = std::exp(-xi * w * t);
    h.time.push_back(t);
    h.y.push_back(e * std::cos(w_d * t + phi));
    h.velocity.push_back(e * (-xi * w * std::cos(w_d * t + phi) - w_d * std::sin(w_d * t + phi)));
  }
  const auto peaks = compare::positive_peaks(h);
  BOOST_TEST(peaks.size() == 13u);
  BOOST_TEST(peaks[0].time == 0.0);
  const compare::Damping found = compare::damping_from_peaks(peaks, {1, 10});
  BOOST_TEST(std::abs(found.ratio / xi - 1) < 1e-5);
  BOOST_TEST(std::abs(found.frequency / w_d - 1) < 1e-6);
  BOOST_TEST(std::abs(compare::damping_from_sine(h, peaks[1].time, peaks[10].time, found).ratio / xi - 1) <
             1e-9);
  BOOST_TEST(std::abs(compare::damping_ratio(compare::log_decrement(0.3)) - 0.3) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
