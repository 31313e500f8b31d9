#include "reference/hertz.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/gsl_status.hpp"

namespace fiberchain::reference {
namespace {

constexpr double pi = std::numbers::pi;

void check(const ElasticBody& body) {
  require_positive_or_infinite("radius", body.radius);
  require_positive_or_infinite("mass", body.mass);
  require_positive_or_infinite("Young's modulus", body.youngs_modulus);
  require_between("Poisson's ratio", body.poisson_ratio, std::nextafter(-1.0, 0.0), 0.5);
}

double compliance(const ElasticBody& body) {
  return (1 - body.poisson_ratio * body.poisson_ratio) / body.youngs_modulus;
}

double shear_compliance(const ElasticBody& body) {
  return (2 - body.poisson_ratio) * 2 * (1 + body.poisson_ratio) / body.youngs_modulus;
}

double from_inverse(const char* what, double inverse) {
  const double value = 1 / inverse;
  require_positive(what, value);
  return value;
}

/// w at which the oscillator of 4/5 delta^(5/4) would swing undamped [m^(1/4)/s].
double oscillator_rate(const HertzPair& pair) { return std::sqrt(1.25 * hertz_stiffness(pair) / pair.mass); }

/// delta of y = 4/5 delta^(5/4).
double overlap_of(double y) { return std::pow(1.25 * y, 0.8); }

/// acos(z) / sqrt(1 - z^2), continued analytically.
double phase_over_sine(double z) {
  const double rest = (1 - z) * (1 + z);
  if (std::abs(rest) < 1e-7) return 1 + rest / 6;
  return rest > 0 ? std::acos(z) / std::sqrt(rest) : std::acosh(z) / std::sqrt(-rest);
}

/// Integral of f over (0, end), f integrable at its ends.
template <class Function>
double integral(const Function& f, double end, const char* what) {
  struct Free {
    void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
  };
  const std::unique_ptr<gsl_integration_workspace, Free> workspace(gsl_integration_workspace_alloc(1000));
  gsl_function function{[](double x, void* self) { return (*static_cast<const Function*>(self))(x); },
                        const_cast<Function*>(&f)};
  double value = 0, error = 0;
  check_gsl(gsl_integration_qags(&function, 0, end, 0, 1e-11, 1000, workspace.get(), &value, &error), what);
  return value;
}

}  // namespace

HertzPair hertz_pair(const ElasticBody& first, const ElasticBody& second) {
  check(first);
  check(second);
  return {from_inverse("E*", compliance(first) + compliance(second)),
          from_inverse("G*", shear_compliance(first) + shear_compliance(second)),
          from_inverse("R*", 1 / first.radius + 1 / second.radius),
          from_inverse("m*", 1 / first.mass + 1 / second.mass)};
}

double hertz_stiffness(const HertzPair& pair) { return 4.0 / 3 * pair.modulus * std::sqrt(pair.radius); }

double mindlin_stiffness(const HertzPair& pair) { return 8 * pair.shear_modulus * std::sqrt(pair.radius); }

double hertz_time_factor() { return 0.8 * std::sqrt(pi) * std::tgamma(0.4) / std::tgamma(0.9); }

HertzCollision hertz_collision(const HertzPair& pair, double speed) {
  require_positive("closing speed", speed);
  const double k = hertz_stiffness(pair);
  const double overlap = std::pow(1.25 * pair.mass * speed * speed / k, 0.4);
  return {overlap, hertz_time_factor() * overlap / speed, k * std::pow(overlap, 1.5)};
}

double hertz_restitution(double damping_ratio, ContactEnd end) {
  require_between("damping ratio", damping_ratio, 0, std::numeric_limits<double>::max());
  if (end == ContactEnd::zero_force) return std::exp(-2 * damping_ratio * phase_over_sine(damping_ratio));
  if (damping_ratio >= 1) return 0;
  return std::exp(-pi * damping_ratio / std::sqrt((1 - damping_ratio) * (1 + damping_ratio)));
}

double common_damping_ratio(double restitution) {
  require_between("restitution", restitution, std::numeric_limits<double>::min(), 1);
  const double l = std::log(restitution);
  return -l / std::sqrt(pi * pi + l * l);
}

DampedCollision damped_hertz_collision(const HertzPair& pair, double damping_ratio, double speed) {
  require_positive("closing speed", speed);
  require_between("damping ratio", damping_ratio, 0, std::nextafter(1.0, 0.0));
  const double z = damping_ratio, sine = std::sqrt((1 - z) * (1 + z)), phase = std::acos(z);
  const double w = oscillator_rate(pair), damped = w * sine;
  // y' falls to zero at phase acos(zeta), y'' at twice that; both have y = sin(phase) e^... / damped
  const auto y = [&](double at) { return speed / damped * std::exp(-z / sine * at) * std::sin(at); };
  const double time = integral([&](double at) { return std::pow(1.25 * y(at), -0.2) / damped; }, 2 * phase,
                               "time of a damped contact");
  return {overlap_of(y(phase)), time, hertz_restitution(z, ContactEnd::zero_force),
          overlap_of(std::max(0.0, y(2 * phase)))};
}

}  // namespace fiberchain::reference
