// The beam of a generalized Maxwell material in time: against the exact motion of its modes, the roots of the
// complex modulus and the beams it turns into.
#include "reference/viscoelastic_beam.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/complex_modes.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(viscoelastic_beam_test)

namespace ref = fiberchain::reference;
using ref::HeldShape;
using ref::ViscoelasticDamping;

namespace {

const ref::PronySeries odd_spectrum{{0.21, 0.9}, {0.13, 0.07}, {0.05, 0.004}};

ref::BeamResolution tight(int modes) { return {modes, ref::CvodeMethod::bdf, {1e-12, 1e-15}}; }

std::vector<double> times_to(double end, int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(end * i / samples);
  return times;
}

double omega_of(int mode) { return ref::clamped_free_beta(mode) * ref::clamped_free_beta(mode); }

/// q(t) of one mode let go at rest from 1, by the eigenvectors of its (q, q', x_j).
class ExactMode {
 public:
  ExactMode(double omega, const ViscoelasticDamping& damping) {
    const ref::PronySeries& series = damping.spectrum;
    const Eigen::Index n = 2 + static_cast<Eigen::Index>(series.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    a(0, 1) = 1;
    a(1, 0) = -omega * omega;
    a(1, 1) = -omega * omega * damping.beside.retardation - damping.beside.viscous;
    for (Eigen::Index j = 2; j < n; ++j) {
      const ref::PronyTerm& term = series[static_cast<std::size_t>(j - 2)];
      a(1, j) = -omega * omega * term.strength;
      a(j, 1) = 1;
      a(j, j) = -1 / term.time;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
    rates_ = solver.eigenvalues();
    const Eigen::VectorXcd start = Eigen::VectorXcd::Unit(n, 0);
    parts_ = solver.eigenvectors().row(0).transpose().cwiseProduct(
        solver.eigenvectors().partialPivLu().solve(start));
  }
  double at(double t) const {
    std::complex<double> sum = 0;
    for (Eigen::Index i = 0; i < rates_.size(); ++i) sum += parts_(i) * std::exp(rates_(i) * t);
    return sum.real();
  }

 private:
  Eigen::VectorXcd rates_, parts_;
};

void check_energy(const ref::BeamHistory& history) {
  const double start = history.samples.front().elastic;
  BOOST_TEST(start > 0);
  double worst = 0;
  double dissipated = 0;
  for (const auto& s : history.samples) {
    worst = std::max(worst, std::abs(s.kinetic + s.elastic + s.dissipated - start) / start);
    BOOST_TEST(s.dissipated >= dissipated - 1e-12 * start);
    dissipated = s.dissipated;
  }
  BOOST_TEST_MESSAGE("energy closes to " << worst << " in " << history.statistics.steps << " steps");
  BOOST_TEST(worst < 1e-8);
  BOOST_TEST(dissipated > 0.2 * start);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_modes_ring_down_is_exact) {
  const ViscoelasticDamping damping{odd_spectrum, {}};
  for (const int mode : {1, 2, 3}) {
    const ExactMode exact(omega_of(mode), damping);
    HeldShape shape;
    shape.modes.resize(static_cast<std::size_t>(mode));
    shape.modes.back() = 0.07;
    const auto history =
        ref::viscoelastic_beam(damping, shape, times_to(12 / omega_of(mode) * 6.3, 300), tight(14));
    double worst = 0;
    for (const auto& s : history.samples) worst = std::max(worst, std::abs(s.y - 0.07 * exact.at(s.time)));
    BOOST_TEST_MESSAGE("mode " << mode << ": largest difference " << worst / 0.07);
    BOOST_TEST(worst < 2e-8 * 0.07);
    check_energy(history);
  }
}

BOOST_AUTO_TEST_CASE(decay_is_the_root_of_the_complex_modulus) {
  // once the creep is gone every period multiplies the motion by exp(2 pi Re s/Im s)
  const ref::PronySeries fast{{0.04, 0.2}, {0.03, 0.02}};
  const ref::FreeDecay root =
      ref::complex_beam_modes({1, 1, 1}, ref::complex_modulus(fast), ref::ChainEnds::clamped_free, 1)[0]
          .decay;
  const double period = 2 * std::numbers::pi / root.eigenvalue.imag();
  std::vector<double> times;
  for (int i = 0; i < 12; ++i) times.push_back((4.1 + i) * period);
  const auto history = ref::viscoelastic_beam({fast, {}}, {0, {0.11}}, times, tight(8));
  const double factor = std::pow(history.samples.back().y / history.samples.front().y, 1.0 / 11);
  const double decrement = -std::log(factor);
  const double damping = decrement / std::hypot(decrement, 2 * std::numbers::pi);
  BOOST_TEST(damping == root.damping, boost::test_tools::tolerance(1e-7));
  BOOST_TEST_MESSAGE("zeta " << damping << ", less tan delta/2 " << root.difference);
  // and not half of the loss factor
  BOOST_TEST(std::abs(damping - root.half_loss_factor) > 1e-4 * damping);
}

BOOST_AUTO_TEST_CASE(a_load_that_vanishes_lets_all_modes_ring) {
  // y = load sum 4/beta^4 q_n(t); a little Kelvin-Voigt damping quiets the modes beyond the resolution
  const ViscoelasticDamping damping{{{0.2, 0.3}, {0.1, 0.02}}, {0.006, 0.05}};
  const std::vector<double> times = times_to(9, 200);
  const auto history = ref::viscoelastic_beam(damping, {0.37, {}}, times, tight(18));
  std::vector<double> exact(times.size(), 0.0);
  for (int n = 80; n >= 1; --n) {
    const ExactMode mode(omega_of(n), damping);
    for (std::size_t i = 0; i < times.size(); ++i) {
      exact[i] += 4 * 0.37 / (omega_of(n) * omega_of(n)) * mode.at(times[i]);
    }
  }
  double worst = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    worst = std::max(worst, std::abs(history.samples[i].y - exact[i]));
  BOOST_TEST_MESSAGE("largest difference " << worst);
  BOOST_TEST(worst < 1e-8);
  BOOST_TEST(history.samples[0].y == 0.37 / 3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(history.samples[0].elastic == 0.37 * 0.37 / 6, boost::test_tools::tolerance(1e-12));
  check_energy(history);
}

BOOST_AUTO_TEST_CASE(shapes_add_up) {
  const ViscoelasticDamping damping{odd_spectrum, {}};
  const std::vector<double> times = times_to(5, 60);
  const auto both = ref::viscoelastic_beam(damping, {0, {0.05, -0.02}}, times, tight(10));
  const auto first = ref::viscoelastic_beam(damping, {0, {0.05}}, times, tight(10));
  const auto second = ref::viscoelastic_beam(damping, {0, {0, -0.02}}, times, tight(10));
  for (std::size_t i = 0; i < times.size(); ++i) {
    BOOST_TEST(std::abs(both.samples[i].y - first.samples[i].y - second.samples[i].y) < 1e-9);
    BOOST_TEST(std::abs(both.samples[i].angle - first.samples[i].angle - second.samples[i].angle) < 1e-8);
    const auto stored = [&](const ref::BeamHistory& h) {
      return h.samples[i].kinetic + h.samples[i].elastic;
    };
    BOOST_TEST(std::abs(stored(both) - stored(first) - stored(second)) < 1e-9);  // the modes are orthogonal
  }
  check_energy(both);
}

BOOST_AUTO_TEST_CASE(without_branches_it_is_the_damped_beam) {
  const ref::BeamDamping beside{0.011, 0.2};
  const std::vector<double> times = times_to(6, 80);
  const auto modal = ref::damped_beam_modal(beside, {ref::Release::Shape::static_load, 0.29}, times, 6000);
  const auto history = ref::viscoelastic_beam({{}, beside}, {0.29, {}}, times, tight(18));
  for (std::size_t i = 0; i < times.size(); ++i) {
    BOOST_TEST(std::abs(history.samples[i].y - modal.samples[i].y) < 1e-9);
    BOOST_TEST(std::abs(history.samples[i].dissipated - modal.samples[i].dissipated) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(branches_that_are_very_fast_or_very_slow) {
  const std::vector<double> times = times_to(4, 40);
  const HeldShape shape{0, {0.1}};
  const auto largest = [&](const ref::BeamHistory& a, const ref::BeamHistory& b) {
    double worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      worst = std::max(worst, std::abs(a.samples[i].y - b.samples[i].y));
    }
    return worst;
  };
  // fast: a dashpot with retardation g tau, to first order in tau
  const auto fast = [&](double tau) {
    return largest(ref::viscoelastic_beam({{{0.02 / tau, tau}}, {}}, shape, times, tight(6)),
                   ref::viscoelastic_beam({{}, {0.02, 0}}, shape, times, tight(6)));
  };
  BOOST_TEST(fast(1e-5) < 1e-5);
  BOOST_TEST(fast(1e-4) / fast(1e-5) == 10, boost::test_tools::tolerance(0.05));
  // slow: a spring more, which holds the beam where it was: g/(1 + g) of the start is the new equilibrium
  const double g = 0.4;
  const auto slow = ref::viscoelastic_beam({{{g, 1e7}}, {}}, shape, times, tight(6));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double w = omega_of(1) * std::sqrt(1 + g);
    BOOST_TEST(std::abs(slow.samples[i].y - 0.1 * (g + std::cos(w * times[i])) / (1 + g)) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const std::vector<double> times{0, 1};
  BOOST_CHECK_THROW(ref::viscoelastic_beam({{{-0.1, 1}}, {}}, {0.1, {}}, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({{{0.1, 0}}, {}}, {0.1, {}}, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({{}, {-1, 0}}, {0.1, {}}, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({{}, {0, NAN}}, {0.1, {}}, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({}, {INFINITY, {}}, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({}, {0, std::vector<double>(17, 0.1)}, times),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::viscoelastic_beam({}, {0.1, {}}, {1, 1}), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
