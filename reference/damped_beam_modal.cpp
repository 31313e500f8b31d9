#include <cmath>
#include <limits>
#include <numbers>

#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

struct Oscillation {
  double value;
  double rate;
};

/// T'' + 2 a T' + b^2 T = 0, T(0) = 1, T'(0) = 0, for any a >= 0: exp(-a t)(C + a t S),
/// C = cosh(z), S = sinh(z)/z, z^2 = (a^2 - b^2) t^2; T' = -b^2 t exp(-a t) S.
Oscillation oscillate(double a, double b, double t) {
  const double z2 = (a * a - b * b) * t * t;
  if (z2 > 1) {  // overdamped: two decays, the slow rate without cancellation
    const double root = std::sqrt((a - b) * (a + b));
    const double fast = a + root;
    const double slow = b * b / fast;
    const double exp_slow = std::exp(-slow * t);
    const double exp_fast = std::exp(-fast * t);
    return {(fast * exp_slow - slow * exp_fast) / (2 * root), b * b * (exp_fast - exp_slow) / (2 * root)};
  }
  double c = 1 + z2 / 2 * (1 + z2 / 12 * (1 + z2 / 30));
  double s = 1 + z2 / 6 * (1 + z2 / 20 * (1 + z2 / 42));
  if (std::abs(z2) > 1e-3) {
    const double z = std::sqrt(std::abs(z2));
    c = z2 > 0 ? std::cosh(z) : std::cos(z);
    s = z2 > 0 ? std::sinh(z) / z : std::sin(z) / z;
  }
  const double decay = std::exp(-a * t);
  return {decay * (c + a * t * s), -b * b * t * decay * s};
}

struct Mode {
  double a;      ///< half the damping coefficient
  double b;      ///< undamped frequency beta^2
  double tip;    ///< deflection of the tip in this mode at release
  double slope;  ///< tip angle over tip deflection
};

/// phi_n'(1)/phi_n(1) = beta (sin sinh)/(sin cosh - cos sinh) ... written with tanh so that it never
/// overflows.
double slope_over_tip(double beta) {
  const double t = std::tanh(beta);
  return beta * (std::sin(beta) * t) / (std::sin(beta) - std::cos(beta) * t);
}

std::vector<Mode> modes_of(const BeamDamping& damping, const Release& release, int terms) {
  const bool from_load = release.shape == Release::Shape::static_load;
  std::vector<Mode> modes;
  for (int n = 1; n <= (from_load ? terms : 1); ++n) {
    const double beta = clamped_free_beta(n);
    const double b = beta * beta;
    const double tip = from_load ? 4 * release.amount / (b * b) : release.amount;
    modes.push_back({(damping.viscous + damping.retardation * b * b) / 2, b, tip, slope_over_tip(beta)});
  }
  return modes;
}

BeamSample sample(const std::vector<Mode>& modes, double time) {
  BeamSample at{};
  at.time = time;
  for (auto mode = modes.rbegin(); mode != modes.rend(); ++mode) {  // small terms first
    const Oscillation o = oscillate(mode->a, mode->b, time);
    at.y += mode->tip * o.value;
    at.y_rate += mode->tip * o.rate;
    at.angle += mode->slope * mode->tip * o.value;
    at.angle_rate += mode->slope * mode->tip * o.rate;
    // int phi^2 = phi(1)^2 / 4
    const double half_mass = mode->tip * mode->tip / 8;
    at.kinetic += half_mass * o.rate * o.rate;
    at.elastic += half_mass * mode->b * mode->b * o.value * o.value;
    at.dissipated += half_mass * (mode->b * mode->b * (1 - o.value * o.value) - o.rate * o.rate);
  }
  return at;
}

}  // namespace

double clamped_free_beta(int n) {
  require_between("n", n, 1, 1e7);
  using std::numbers::pi;
  const double middle = (n - 0.5) * pi;
  if (n > 12) return middle;  // the root is within 2 exp(-beta) < 1e-16 of it
  const auto f = [](double beta) { return std::cos(beta) + 1 / std::cosh(beta); };
  return detail::find_root(f, middle - 0.5, middle + 0.5, {}, "frequency of the clamped-free beam");
}

double damped_beam_ratio(const BeamDamping& damping, int n) {
  require_between("retardation", damping.retardation, 0, kLargest);
  require_between("viscous", damping.viscous, 0, kLargest);
  const double b = clamped_free_beta(n) * clamped_free_beta(n);
  return (damping.viscous / b + damping.retardation * b) / 2;
}

BeamHistory damped_beam_modal(const BeamDamping& damping, const Release& release,
                              const std::vector<double>& times, int terms) {
  require_between("retardation", damping.retardation, 0, kLargest);
  require_between("viscous", damping.viscous, 0, kLargest);
  require_between("release amount", release.amount, -kLargest, kLargest);
  require_between("terms", terms, 1, 1e6);
  require_times(times);
  const std::vector<Mode> modes = modes_of(damping, release, terms);
  BeamHistory history;
  for (const double time : times) history.samples.push_back(sample(modes, time));
  return history;
}

}  // namespace fiberchain::reference
