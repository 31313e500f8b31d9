#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "compare/bench/problems.hpp"
#include "compare/bench/ring_down.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"

namespace fiberchain::compare {
namespace {

using reference::ChainMode;

/// Tip deflection over L. xi_f falls by about half its square; rounding grows as it gets smaller.
constexpr double amplitude = 1e-4;
constexpr double amplitude_effect = amplitude * amplitude / 2;
/// Two peaks after the release give the first guess of the fit over the whole watch.
constexpr double damping_periods = 2.2;

struct Exact {
  double damping;
  double error;  ///< relative
};

double dense_damping(const dem::Fiber& fiber) {
  const auto modes = reference::chain_modes(linear_chain_of(fiber), reference::ChainMotion::bending,
                                            reference::ChainEnds::clamped_free);
  return modes.front().damping;
}

/// xi_f depends on nu, xi_b and r_f only; other sizes and moduli round differently.
Exact exact_damping(const dem::Fiber& fiber) {
  const double here = dense_damping(fiber);
  double error = 0;
  for (const double factor : {0.7, 1.9, 3.1}) {
    dem::Fiber other = fiber;
    other.diameter *= factor;
    other.material.youngs_modulus *= factor * factor;
    other.material.shear_modulus *= factor * factor;
    error = std::max(error, std::abs(dense_damping(other) / here - 1));
  }
  return {here, error + amplitude_effect};
}

/// xi_f by a damped sine through every sample.
double fitted_damping(const dem::ReleaseRecord<2>& record, const dem::Fiber& fiber) {
  const TipHistory history = tip_history(record, dem::fiber_length(fiber));
  const Damping start = damping_from_peaks(positive_peaks(history), {0, 1});
  return damping_from_sine(history, 0, history.time.back(), start).ratio;
}

PrecisionRow eigenvalue_row(const dem::Fiber& fiber, const Exact& exact, const TimingBudget& budget) {
  PrecisionRow row{.method = "eigenvalue",
                   .setting = "inverse iteration",
                   .aspect_ratio = fiber.aspect_ratio,
                   .in_time = false};
  return measured_row(
      row, budget, [&] { return reference::first_bending_mode(linear_chain_of(fiber)).damping; },
      [&](double found) -> Judged {
        return {std::abs(found / exact.damping - 1), {}};
      });
}

}  // namespace

PrecisionProblem damping_problem(int aspect_ratio, const BenchOptions& options) {
  dem::Fiber fiber = nominal_fiber(aspect_ratio, 0.3, dem::BondModel::paper);
  fiber.bond_damping = 1;
  const Exact exact = exact_damping(fiber);
  PrecisionProblem problem{
      .id = fmt::format("damping-{}", aspect_ratio),
      .title = fmt::format("Damping ratio ξ_f, r_f = {}, ξ_b = 1", aspect_ratio),
      .error_label = "relative error of ξ_f",
      .short_title = fmt::format("ξ_f, r_f = {}, ξ_b = 1", aspect_ratio),
      .reference =
          "all modes of the linear chain by a dense eigensolve; own error: the same chain in other units, "
          "and the amplitude",
      .reference_error = exact.error,
      .rows = {},
      .periods = damping_periods};
  problem.rows.push_back(eigenvalue_row(fiber, exact, row_budget(options)));
  const ChainMode mode = reference::first_bending_mode(linear_chain_of(fiber));
  const dem::Release<2> release = mode_release(fiber, mode, amplitude, damping_periods);
  const auto settings = options.leapfrogs_alone ? leapfrog_settings(release, options.quick)
                                                : ring_down_settings(release, options.quick, false);
  auto rows =
      ring_down_rows(settings, release, row_budget(options), [&](const dem::ReleaseRecord<2>& record) {
        return std::abs(fitted_damping(record, fiber) / exact.damping - 1);
      });
  std::ranges::move(rows, std::back_inserter(problem.rows));
  return problem;
}

}  // namespace fiberchain::compare
