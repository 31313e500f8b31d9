#include "compare/identify/identify.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/calibration/calibration.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "reference/chain_modes.hpp"
#include "reference/damped_beam.hpp"

namespace fiberchain::compare {
namespace {

constexpr std::size_t kFewest = 12;
constexpr std::size_t kMostModes = 4;
/// By which another sine must lower Schwarz's criterion: strong evidence is 10 (Kass and Raftery).
constexpr double kStandsOut = 10;
/// Squares of the residuals over those of the record that are round-off.
constexpr double kRoundOff = 1e-23;
constexpr Estimate kUnknown{};

void check(const IdentifyCase& asked) {
  const RingDownRecord& r = asked.record;
  if (r.time.size() != r.displacement.size())
    throw InputError(fmt::format("{} times and {} displacements: as many are needed", r.time.size(),
                                 r.displacement.size()));
  if (r.time.size() < kFewest)
    throw InputError(fmt::format("{} samples are too few: {} or more are needed", r.time.size(), kFewest));
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    if (!std::isfinite(r.time[i]) || !std::isfinite(r.displacement[i]))
      throw InputError(fmt::format("sample {} is not finite", i));
    if (i > 0 && !(r.time[i] > r.time[i - 1]))
      throw InputError(fmt::format("times must rise: sample {} is at {:g} s, the one before at {:g} s", i,
                                   r.time[i], r.time[i - 1]));
  }
  if (!(asked.confidence > 0 && asked.confidence < 1))
    throw InputError(fmt::format("confidence = {:g} is not allowed: above 0 and below 1", asked.confidence));
}

/// Whether a sine is another mode, and not what a frequency that changes with the amplitude leaves of one.
bool is_another(const DampedSine& sine, const std::vector<DampedSine>& modes) {
  return std::ranges::none_of(modes, [&](const DampedSine& mode) {
    return std::abs(sine.w / mode.w - 1) < 0.5 || std::abs(mode.w / sine.w - 1) < 0.5;
  });
}

/// By which a sine as it was guessed lowers n ln(squares) of what is left.
double gain_of(const DampedSine& sine, const std::vector<double>& times, const SineFit& fit) {
  double squares = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i] - times[0], angle = sine.w * t,
                 left = fit.residuals[i] -
                        std::exp(-sine.s * t) * (sine.a * std::cos(angle) + sine.b * std::sin(angle));
    squares += left * left;
  }
  return static_cast<double>(times.size()) * std::log(fit.squares / squares);
}

/// As many modes as stand out.
SineFit fit_of(const RingDownRecord& record) {
  SineFit best = mean_of(record);
  const double highest = 0.95 * nyquist_frequency(record);
  const double least = kRoundOff * best.squares;
  while (best.modes.size() < kMostModes && best.squares > least) {
    const DampedSine more = strongest_sine({record.time, best.residuals}, highest);
    if (!is_another(more, best.modes)) break;
    // fits take long: of a guess that gains not half of what it must none is made
    const double needed = sine_parameters * std::log(static_cast<double>(record.time.size())) + kStandsOut;
    if (!best.modes.empty() && !(gain_of(more, record.time, best) > 0.5 * needed)) break;
    std::vector<DampedSine> start = best.modes;
    start.push_back(more);
    SineFit fit = fit_sines(record, best.offset, start);
    const bool sound = fit.converged && static_cast<int>(record.time.size()) > fit.parameters() &&
                       is_another(fit.modes.back(), best.modes);
    if (!sound || !(fit.criterion() < best.criterion() - kStandsOut)) break;
    best = std::move(fit);
  }
  return best;
}

/// Half widths of frequency and damping ratio, from the covariance of decay s and damped frequency w.
struct HalfWidths {
  double frequency, damping_ratio;
};

HalfWidths half_widths(const SineFit& fit, double noise, double confidence) {
  const DampedSine& mode = fit.modes.front();
  const double size = std::hypot(mode.s, mode.w), cube = size * size * size;
  const auto error = [&](double by_s, double by_w) {
    const Eigen::Vector2d by(by_s, by_w);
    return noise * std::sqrt(by.dot(fit.covariance.block<2, 2>(3, 3) * by));
  };
  const double freedom = static_cast<double>(fit.residuals.size()) - fit.parameters(),
               t = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, freedom);
  return {t * error(mode.s / size, mode.w / size),
          t * error(mode.w * mode.w / cube, -mode.s * mode.w / cube)};
}

double correlation_of(const std::vector<double>& residuals) {
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += residuals[i] * residuals[i];
    if (i > 0) products += residuals[i] * residuals[i - 1];
  }
  return squares > 0 ? products / squares : 0;
}

template <class Function>
Estimate carried(const Estimate& from, const Function& to) {
  return {to(from.value), to(from.low), to(from.high)};
}

void note_doubts(Identification& found) {
  if (found.periods < 2) {
    found.doubts.push_back(fmt::format(
        "frequency: the record has {:.2g} periods, 2 at least tell it from a drift", found.periods));
    found.frequency = found.damping_ratio = kUnknown;
    return;
  }
  const Estimate& xi = found.damping_ratio;
  if (xi.low > 0) return;
  // the error of xi falls as 1/(amplitude over noise) and as 1/periods^(3/2) where little decays
  const double width = xi.high - xi.value,
               longer = std::pow(2 * width / std::max(xi.value, 0.1 * width), 2.0 / 3);
  found.doubts.push_back(
      fmt::format("damping: its interval, {:.3g} to {:.3g}, holds none; a record {:.1f} times as long, or "
                  "{:.1f} times less "
                  "noise, would tell",
                  xi.low, xi.high, longer, std::pow(longer, 1.5)));
  found.damping_ratio = kUnknown;
}

void note_warnings(Identification& found, const RingDownRecord& record) {
  const auto n = static_cast<double>(record.time.size());
  if (std::abs(found.correlation) > 5 / std::sqrt(n)) {
    found.warnings.push_back(
        fmt::format("what the fit leaves is not noise (correlation {:.2g} from one sample to the next): the "
                    "intervals are "
                    "too narrow; large amplitudes change frequency and damping",
                    found.correlation));
  }
  const DampedSine& mode = found.fit.modes.front();
  if (const double samples = 2 * nyquist_frequency(record) / mode.w; samples < 4) {
    found.warnings.push_back(fmt::format(
        "{:.2g} samples a period: the vibration may be a faster one that sampling folds down", samples));
  }
  for (const DampedSine& other : found.fit.modes) {
    if (other.w >= mode.w) continue;
    found.warnings.push_back(fmt::format(
        "there is a slower mode at {:.4g} of the frequency: this may be no first mode", other.w / mode.w));
  }
}

/// omega_1^2 of E.
double squared_frequency(const IdentifyCase& asked, dem::Fiber fiber, double damping_ratio) {
  if (asked.of == RecordOf::chain) {
    const double omega = calibrate({fiber}, damping_ratio).natural_frequency;
    return omega * omega;
  }
  const double beta = reference::clamped_free_beta(1), L = dem::fiber_length(fiber),
               R = dem::sphere_radius(fiber), mass = fiber.material.density * std::numbers::pi * R * R;
  return std::pow(beta / L, 4) * dem::bending_stiffness(fiber) / mass;
}

/// xi_b of xi_f; not a number beyond what bonds reach.
double setting_of(const dem::Fiber& fiber, double damping_ratio) {
  try {
    return calibrate({fiber}, damping_ratio).setting;
  } catch (const InputError&) {
    return nan;
  }
}

void identify_fiber(const IdentifyCase& asked, Identification& found) {
  dem::Fiber fiber = *asked.fiber;
  fiber.bond_damping = fiber.retardation_time = 0;
  dem::check(fiber);
  const double xi = found.damping_ratio.value, nu = dem::poisson_ratio(fiber.material);
  if (!std::isfinite(nu))
    throw InputError("the fiber's Young's and shear modulus must be those of an isotropic material");
  if (!std::isfinite(found.frequency.value)) {
    found.youngs_modulus = found.bond_damping = kUnknown;
    return;
  }
  // of E all frequencies are the square root at the same nu and xi
  const double unit =
      squared_frequency(asked, fiber, std::isfinite(xi) ? xi : 1e-6) / fiber.material.youngs_modulus;
  found.youngs_modulus = carried(found.frequency, [&](double omega) { return omega * omega / unit; });
  if (!std::isfinite(xi)) {
    found.bond_damping = kUnknown;
    return;
  }
  fiber.dashpots = dem::DashpotLaw::bond_damping;
  fiber.material = dem::isotropic_material(found.youngs_modulus->value, nu, fiber.material.density);
  found.bond_damping = carried(found.damping_ratio, [&](double ratio) { return setting_of(fiber, ratio); });
}

}  // namespace

Identification identify(const IdentifyCase& asked) {
  check(asked);
  Identification found;
  found.fit = fit_of(asked.record);
  const SineFit& fit = found.fit;
  found.noise = std::sqrt(fit.squares / (static_cast<double>(fit.residuals.size()) - fit.parameters()));
  found.correlation = correlation_of(fit.residuals);
  if (fit.modes.empty()) {
    found.doubts.emplace_back("frequency and damping: no vibration stands out of the noise");
  } else {
    const DampedSine& mode = fit.modes.front();
    const double omega = std::hypot(mode.s, mode.w), xi = mode.s / omega,
                 duration = asked.record.time.back() - asked.record.time.front();
    const HalfWidths half = half_widths(fit, found.noise, asked.confidence);
    found.frequency = {omega, omega - half.frequency, omega + half.frequency};
    found.damping_ratio = {xi, xi - half.damping_ratio, std::min(xi + half.damping_ratio, 1 - 1e-12)};
    found.amplitude = std::hypot(mode.a, mode.b);
    found.periods = duration * mode.w / (2 * std::numbers::pi);
    note_doubts(found);
    note_warnings(found, asked.record);
  }
  found.log_decrement = carried(found.damping_ratio, [](double xi) { return log_decrement(xi); });
  found.loss_factor = carried(found.damping_ratio, [](double xi) { return 2 * xi; });
  if (asked.fiber) identify_fiber(asked, found);
  return found;
}

}  // namespace fiberchain::compare
