#include "reference/reissner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/gsl_ode.hpp"
#include "reference/gsl_root.hpp"

// theta'' = -load cos(theta) (1 + beta sin(theta)), beta = load (1/axial - 1/shear). An endless beam comes
// to rest at theta* with x' = 0: sin(theta*) = min(1, -1/beta). The distance D = theta* - theta grows from
// the free end like an exponential, so z = ln D is used where it grows much, and theta / load otherwise.

namespace fiberchain::reference {
namespace {

using detail::OdeIntegrator;
constexpr double kHalfPi = std::numbers::pi / 2;

struct Beam {
  Beam(double load_value, double axial, double shear)
      : load(load_value),
        stretch(1 / axial),
        shear_compliance(1 / shear),
        beta(load * (stretch - shear_compliance)),
        rate(std::sqrt(load * std::max({1.0, 1 + beta, -beta}))),
        tilted(beta < -1),
        rest_sine(tilted ? -1 / beta : 1),
        rest_cosine(tilted ? std::sqrt((beta - 1) * (beta + 1)) / -beta : 0),
        rest_angle(std::atan2(rest_sine, rest_cosine)) {}

  bool gentle() const { return rate <= 1; }

  double sine_at(double distance) const {
    return rest_sine * std::cos(distance) - rest_cosine * std::sin(distance);
  }
  double cosine_at(double distance) const {
    return rest_cosine * std::cos(distance) + rest_sine * std::sin(distance);
  }
  /// (1 - x') part: cos(theta)(1 + beta sin(theta)) / D, regular at D = 0.
  double restoring_over_distance(double distance) const {
    const double half = distance / 2;
    const double sinc_half = half == 0 ? 1 : std::sin(half) / half;
    if (tilted) {
      const double cosine_half = rest_cosine * std::cos(half) + rest_sine * std::sin(half);
      return cosine_at(distance) * -beta * cosine_half * sinc_half;
    }
    return std::cos(half) * sinc_half * (1 + beta * std::cos(distance));
  }

  double load;
  double stretch;           ///< 1 / axial
  double shear_compliance;  ///< 1 / shear
  double beta;
  double rate;         ///< bound of the growth of D, sqrt(max of -theta''/D)
  bool tilted;         ///< the endless beam's sections rest short of the vertical
  double rest_sine;    ///< sin(theta*)
  double rest_cosine;  ///< cos(theta*)
  double rest_angle;   ///< theta*
};

/// y' from sine and cosine of the section's angle.
double rise(const Beam& beam, double sine, double cosine) {
  return sine * (1 + beam.load * beam.stretch * sine) + beam.load * beam.shear_compliance * cosine * cosine;
}

// Unknown (z or theta/load), its derivative by tau, y and shortening accumulated from the free end.
enum Component : std::size_t { kUnknown, kPrime, kRise, kShortening, kSize };
using State = std::array<double, kSize>;

/// One of the two forms of the problem: tau = scale * (1 - s/L).
struct Form {
  double scale;
  double rise_unit;        ///< y over the integral kRise
  double shortening_unit;  ///< x over the integral kShortening
  detail::OdeRhs rhs;
};

Form gentle_form(const Beam& beam) {
  auto rhs = [&beam](double, const double* u, double* du) {
    const double theta = beam.load * u[kUnknown];
    const double sine = std::sin(theta);
    const double cosine = std::cos(theta);
    const double half = std::sin(theta / 2) / beam.load;
    du[kUnknown] = u[kPrime];
    du[kPrime] = -cosine * (1 + beam.beta * sine);
    du[kRise] = rise(beam, sine, cosine) / beam.load;
    du[kShortening] = 2 * half * half - (beam.stretch - beam.shear_compliance) * sine / beam.load * cosine;
  };
  return {1, beam.load, beam.load * beam.load, rhs};
}

Form logarithmic_form(const Beam& beam) {
  auto rhs = [&beam](double, const double* z, double* dz) {
    const double distance = std::exp(z[kUnknown]);
    const double growth = beam.load * beam.restoring_over_distance(distance) / (beam.rate * beam.rate);
    const double sine = beam.sine_at(distance);
    const double cosine = beam.cosine_at(distance);
    const double half = std::sin((beam.rest_angle - distance) / 2);
    dz[kUnknown] = z[kPrime];
    dz[kPrime] = growth - z[kPrime] * z[kPrime];
    dz[kRise] = rise(beam, sine, cosine);
    dz[kShortening] = 2 * half * half - beam.beta * sine * cosine;
  };
  return {beam.rate, 1 / beam.rate, 1 / beam.rate, rhs};
}

const char* const kName = "Reissner beam by shooting";

/// Takes a state that overshot unknown = target back onto it, with the unknown as independent variable
/// (Henon's trick); returns the tau there.
double back_to(double target, double tau, State& state, const Form& form) {
  std::array<double, kSize + 1> by_unknown{};
  std::copy(state.begin(), state.end(), by_unknown.begin());
  by_unknown[kSize] = tau;
  const auto rhs = [&](double, const double* y, double* dy) {
    form.rhs(0, y, dy);
    const double slope = y[kPrime];
    for (std::size_t i = 0; i < kSize; ++i) dy[i] /= slope;
    dy[kSize] = 1 / slope;
  };
  double unknown = state[kUnknown];
  OdeIntegrator(kSize + 1, rhs, {}, kName).advance(unknown, target, by_unknown);
  std::copy(by_unknown.begin(), by_unknown.end() - 1, state.begin());
  return by_unknown[kSize];
}

/// State and tau from which to integrate: the free end itself, or, where the beam lies at rest along most
/// of its length, the point where D = 1e-17 theta*. Until there z = z_tip + ln cosh(kappa tau) exactly
/// to rounding, kappa^2 = growth at D = 0, and the integrals grow linearly.
double start(const Beam& beam, const Form& form, double z_tip, State& state) {
  state = {z_tip, 0, 0, 0};
  const double kappa = std::sqrt(beam.load * beam.restoring_over_distance(0)) / beam.rate;
  const double climb = std::log(1e-17 * beam.rest_angle) - z_tip;
  const double tau = std::min(form.scale, (climb + std::numbers::ln2) / kappa);
  if (!(climb > 20 && kappa * tau > 20)) return 0;
  State slope{};
  form.rhs(0, state.data(), slope.data());
  state = {z_tip + kappa * tau - std::numbers::ln2, kappa, slope[kRise] * tau, slope[kShortening] * tau};
  return tau;
}

/// From the free end (D = exp(z_tip)) toward the clamp, where z = ln(theta*). Positive if that is reached
/// too soon, negative if not yet; continuous with its slope, without loops beyond the clamp.
double clamp_residual(const Beam& beam, const Form& form, double z_tip, State& state) {
  const double target = std::log(beam.rest_angle);
  double tau = start(beam, form, z_tip, state);
  OdeIntegrator path(kSize, form.rhs, {}, kName);
  while (tau < form.scale && state[kUnknown] < target) path.step(tau, form.scale, state);
  if (state[kUnknown] <= target) return state[kUnknown] - target;
  tau = back_to(target, tau, state, form);
  return state[kPrime] * (form.scale - tau);
}

struct Solution {
  Form form;
  double tip_unknown;
  double tip_angle;
  State clamp;
};

Solution solve_gentle(const Beam& beam) {
  Solution solution{gentle_form(beam), 0, 0, {}};
  const auto residual = [&](double unknown) {
    solution.clamp = {unknown, 0, 0, 0};
    double tau = 0;
    OdeIntegrator(kSize, solution.form.rhs, {}, kName).advance(tau, 1, solution.clamp);
    return solution.clamp[kUnknown];
  };
  const double upper = (1 + std::abs(beam.beta)) / 2 * (1 + 1e-9);
  solution.tip_unknown = detail::find_root(residual, 0, upper, {1e-15, 1e-15, 200}, kName);
  residual(solution.tip_unknown);
  solution.tip_angle = beam.load * solution.tip_unknown;
  return solution;
}

Solution solve_logarithmic(const Beam& beam) {
  Solution solution{logarithmic_form(beam), 0, 0, {}};
  const auto residual = [&](double z) { return clamp_residual(beam, solution.form, z, solution.clamp); };
  const double top = std::log(beam.rest_angle);
  // D <= D_tip cosh(rate sigma); ln cosh(r) = r + ln((1 + exp(-2r)) / 2)
  const double lower = top - beam.rate - std::log((1 + std::exp(-2 * beam.rate)) / 2);
  const double below = lower - 1e-9 * beam.rate;
  // The residual grows about as fast as z: a step of twice its size usually brackets the root.
  double above = below;
  for (double step = -2 * residual(below); above < top - step && residual(above += step) < 0;) step *= 2;
  if (residual(above) < 0) above = top - 1e-12;
  solution.tip_unknown =
      detail::find_root(residual, below, above, {1e-14 * (1 + beam.rate), 1e-15, 200}, kName);
  residual(solution.tip_unknown);
  solution.tip_angle = beam.rest_angle - std::exp(solution.tip_unknown);
  return solution;
}

Solution solve(const Beam& beam) { return beam.gentle() ? solve_gentle(beam) : solve_logarithmic(beam); }

void check(double load, double axial, double shear) {
  require_between("load", load, 0, max_reissner_load);
  require_positive_or_infinite("axial", axial);
  require_positive_or_infinite("shear", shear);
}

}  // namespace

TipState reissner_tip(double load, double axial, double shear) {
  check(load, axial, shear);
  if (load == 0) return {0, 0, 0};
  const Beam beam(load, axial, shear);
  const Solution solution = solve(beam);
  return {solution.form.rise_unit * solution.clamp[kRise],
          solution.form.shortening_unit * solution.clamp[kShortening], solution.tip_angle};
}

TipState reissner_cantilever(double bending, double axial, double shear, double force, double length) {
  require_positive("bending", bending);
  require_positive("length", length);
  const double unit = length * length / bending;
  return reissner_tip(force * unit, axial * unit, shear * unit);
}

BeamShape reissner_shape(double load, double axial, double shear, std::size_t n) {
  check(load, axial, shear);
  require_between("n", static_cast<double>(n), 2, 1e7);
  BeamShape shape{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n),
                  std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    shape.x[i] = shape.s[i] = static_cast<double>(i) / static_cast<double>(n - 1);
  }
  if (load == 0) return shape;
  const Beam beam(load, axial, shear);
  const Solution solution = solve(beam);
  OdeIntegrator path(kSize, solution.form.rhs, {}, kName);
  State state{solution.tip_unknown, 0, 0, 0};
  double tau = 0;
  for (std::size_t i = n; i-- > 1;) {
    path.advance(tau, solution.form.scale * (1 - shape.s[i]), state);
    const double shortening = solution.clamp[kShortening] - state[kShortening];
    shape.y[i] = solution.form.rise_unit * (solution.clamp[kRise] - state[kRise]);
    shape.x[i] = shape.s[i] - solution.form.shortening_unit * shortening;
    shape.theta[i] =
        beam.gentle() ? beam.load * state[kUnknown] : beam.rest_angle - std::exp(state[kUnknown]);
  }
  return shape;
}

}  // namespace fiberchain::reference
