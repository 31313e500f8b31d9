#include <algorithm>
#include <cmath>

#include "compare/bench/kernels.hpp"
#include "compare/bench/tables.hpp"

namespace fiberchain::compare {
namespace {

using Value = double (*)(const PrecisionRow&);

std::vector<std::string> methods_of(const PrecisionProblem& problem) {
  std::vector<std::string> methods;
  for (const PrecisionRow& row : problem.rows) {
    if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
  }
  return methods;
}

/// The settings of a method, coarse to fine; those that failed or cost nothing of this kind leave no point,
/// and those that the reference cannot be told from stand at its own error.
Series series_of(const PrecisionProblem& problem, const std::string& method, Value value, int color) {
  Series series{method, {}, {}, Mark::line_and_points, Dash::solid, color};
  for (const PrecisionRow& row : problem.rows) {
    if (row.method != method || !(row.error >= 0) || !(value(row) > 0)) continue;
    series.add(std::max(row.error, problem.reference_error), value(row));
  }
  return series;
}

/// A line at the reference's own error where that is not far below what is drawn.
void show_reference(Figure& figure, double error) {
  double left = 1, low = 1e300, high = 0;
  for (const Series& series : figure.series) {
    for (const double x : series.x) left = std::min(left, x);
    for (const double y : series.y) low = std::min(low, y), high = std::max(high, y);
  }
  if (error < left / 10 || high == 0) return;
  figure.series.push_back(
      {"as far as the reference tells", {error, error}, {low, high}, Mark::line, Dash::dotted, 6});
}

/// The same method has the same color in every figure; those not named take their place in the legend.
int color_of(const std::string& method, int place) {
  constexpr const char* known[] = {"eigenvalue",
                                   "leapfrog",
                                   "leapfrog, 8 in lanes",
                                   "leapfrog-damped",
                                   "leapfrog-damped, 8 in lanes",
                                   "implicit",
                                   "cvode",
                                   "auto",
                                   "leapfrog-stiff",
                                   "leapfrog-stiff, 8 in lanes"};
  const auto found = std::ranges::find(known, method);
  if (found != std::end(known)) return static_cast<int>(found - std::begin(known));
  if (method == "leapfrog, total form") return 0;
  return method == "leapfrog-damped, total form" ? 4 : place;
}

Figure figure_of(const PrecisionProblem& problem, Value value, const char* label, bool lanes) {
  Figure figure{problem.title, {problem.error_label, true}, {label, true}, {}};
  int place = 0;
  for (const std::string& method : methods_of(problem)) {
    const auto row = std::ranges::find(problem.rows, method, &PrecisionRow::method);
    Series series = series_of(problem, method, value, color_of(method, place++));
    if (!series.x.empty() && (lanes || row->lanes == 1)) figure.series.push_back(std::move(series));
  }
  show_reference(figure, problem.reference_error);
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> precision_figures(const std::vector<PrecisionProblem>& problems) {
  std::vector<std::pair<std::string, Figure>> figures;
  for (const PrecisionProblem& problem : problems) {
    const Figure time = figure_of(
        problem, [](const PrecisionRow& row) { return row.time.least; }, "run time of one chain (s)", true);
    const Figure work = figure_of(
        problem, [](const PrecisionRow& row) { return row.work.bond_evaluations; }, "evaluations of a bond",
        false);
    if (!time.series.empty()) figures.emplace_back("bench-" + problem.id, time);
    if (!work.series.empty()) figures.emplace_back("bench-" + problem.id + "-work", work);
  }
  return figures;
}

Figure kernel_figure(const std::vector<KernelTime>& times, const std::vector<MeasuredPeak>& peaks) {
  Figure figure{"Inner loops: a bond-step against what its operations take at least",
                {"least time at the core's peak (ns)", true},
                {"measured, chains of 11 spheres (ns)", true},
                {}};
  double low = 1e300, high = 0;
  int color = 1;
  for (const MeasuredPeak& peak : peaks) {
    Series series{std::string(dem::name(peak.set)), {}, {}, Mark::points, Dash::solid, color++};
    for (const KernelTime& t : times) {
      if (t.set != peak.set) continue;
      series.add(1e9 * bound_of(t.count, peak.peak).least(), 1e9 * t.ensemble);
      low = std::min(low, series.x.back());
      high = std::max(high, series.x.back());
    }
    figure.series.push_back(std::move(series));
  }
  figure.series.push_back({"bound", {low, high}, {low, high}, Mark::line, Dash::dashed, 0});
  return figure;
}

}  // namespace fiberchain::compare
