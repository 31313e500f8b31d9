#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/bench/history_reference.hpp"
#include "compare/bench/problems.hpp"
#include "compare/bench/ring_down.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"

namespace fiberchain::compare {
namespace {

using Path = std::vector<dem::Vec<double, 2>>;

constexpr double history_periods = 3;
/// A multiple of every number of samples a period that a setting has.
constexpr int samples_per_period = 4050;

double largest_distance(const Path& a, const Path& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, dem::norm(a[i] - b[i]));
  return largest;
}

std::vector<double> times_of(double period) {
  std::vector<double> times;
  const int n = static_cast<int>(history_periods * samples_per_period);
  for (int i = 0; i <= n; ++i) times.push_back(period * i / samples_per_period);
  return times;
}

/// Largest |dr| / L at the record's own samples, each of which the reference has too.
double path_error(const dem::ReleaseRecord<2>& record, const Path& exact, double length) {
  const std::size_t stride = (exact.size() - 1) / (record.samples.size() - 1);
  double largest = 0;
  for (std::size_t i = 0; i < record.samples.size(); ++i) {
    largest = std::max(largest, dem::norm((1 / length) * record.samples[i].position - exact[i * stride]));
  }
  return largest;
}

}  // namespace

PrecisionProblem history_problem(int aspect_ratio, double load, const BenchOptions& options) {
  dem::Fiber fiber = nominal_fiber(aspect_ratio, 0.3, dem::BondModel::paper);
  fiber.bond_damping = 1;
  const dem::Release<2> release =
      static_release(fiber, reference::first_bending_mode(linear_chain_of(fiber)), load, history_periods);
  const std::vector<double> times = times_of(release.period);
  const Path exact = tip_path_by_runge_kutta(release, times, 1e-12),
             looser = tip_path_by_runge_kutta(release, times, 1e-11);
  PrecisionProblem problem{
      .id = fmt::format("history-{}", aspect_ratio),
      .title = fmt::format("Free end after the release, r_f = {}, {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}, "
                           "ξ_b = 1",
                           aspect_ratio, load),
      .error_label = "largest |Δ{/:Bold r}|/{/:Italic L} of the free end over three periods",
      .short_title = fmt::format("path of the free end, r_f = {}, PL²/EI = {:g}", aspect_ratio, load),
      .reference =
          "GSL's Prince-Dormand 8(9) at 1e-12 on the chain's equations; own error: its distance from 1e-11",
      .reference_error = largest_distance(exact, looser),
      .rows = {},
      .periods = history_periods};
  const auto settings = options.leapfrogs_alone ? leapfrog_settings(release, options.quick)
                                                : ring_down_settings(release, options.quick, true);
  auto rows =
      ring_down_rows(settings, release, row_budget(options), [&](const dem::ReleaseRecord<2>& record) {
        return path_error(record, exact, dem::fiber_length(fiber));
      });
  std::ranges::move(rows, std::back_inserter(problem.rows));
  return problem;
}

}  // namespace fiberchain::compare
