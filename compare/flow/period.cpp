#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "compare/flow/study.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"
#include "reference/rigid_chain_mobility.hpp"

namespace fiberchain::compare {
namespace {

using OrbitPoints = std::vector<OrbitPoint>;

double jeffery(int spheres) {
  return reference::jeffery_period(reference::free_draining_aspect_ratio(spheres), 1);
}

double rigid(int spheres, dem::Hydrodynamics hydrodynamics) {
  using enum reference::ChainCoupling;
  constexpr reference::ChainCoupling couplings[] = {none, force_torque, force_torque_stresslet};
  if (spheres > 500) return nan;
  return reference::rigid_chain_period({spheres, couplings[static_cast<int>(hydrodynamics)]}, 1);
}

/// Period of a correlation at r = N; NaN where it makes no sense.
double correlated(std::string_view name, double ratio) {
  for (const auto& correlation : reference::aspect_ratio_correlations()) {
    if (correlation.name != name) continue;
    if (ratio < correlation.low || ratio > correlation.high) return nan;
    return reference::jeffery_period(correlation.function(ratio), 1);
  }
  return nan;
}

dem::NamedRow orbit_row(const OrbitPoint& p) {
  const int N = p.asked.spheres;
  const double cox = correlated("Cox", N), measured = correlated("Goldsmith-Mason", N);
  const double rigid_period = rigid(N, p.asked.hydrodynamics);
  return {{"aspect_ratio", std::int64_t{N - 1}},
          {"spheres", std::int64_t{N}},
          {"hydrodynamics", std::string(name(p.asked.hydrodynamics))},
          {"elasto_viscous", p.asked.elasto_viscous},
          {"period", dem::known(p.period)},
          {"period_rigid", dem::known(rigid_period)},
          {"period_error", dem::known(p.period / rigid_period - 1)},
          {"period_jeffery", jeffery(N)},
          {"period_cox", dem::known(cox)},
          {"period_goldsmith_mason", dem::known(measured)},
          {"period_harris_pittman", dem::known(correlated("Harris-Pittman", N))},
          {"period_zhang", dem::known(correlated("Zhang", N))},
          {"over_cox", dem::known(p.period / cox - 1)},
          {"over_goldsmith_mason", dem::known(p.period / measured - 1)},
          {"bending_angle", p.bending_angle},
          {"steps", static_cast<std::int64_t>(p.history.record.work.steps)},
          {"run_time", p.history.run_time},
          {"status", p.status}};
}

using Transform = std::function<double(double period, double spheres)>;

/// Chains as points, formulas as lines.
std::vector<Series> series_of(const OrbitPoints& points, const Transform& y) {
  using dem::Hydrodynamics;
  std::vector<Series> all;
  for (const auto& [hydrodynamics, label] : {std::pair{Hydrodynamics::free_draining, "free draining"},
                                             {Hydrodynamics::interactions, "interactions"},
                                             {Hydrodynamics::stresslets, "stresslets"}}) {
    Series s{label, {}, {}, Mark::points};
    for (const OrbitPoint& p : points) {
      if (p.asked.hydrodynamics != hydrodynamics) continue;
      s.add(p.asked.spheres, y(p.period, p.asked.spheres));
    }
    if (!s.x.empty()) all.push_back(std::move(s));
  }
  const auto add = [&](const std::string& label, Dash dash, int color, auto value) {
    Series s{label, {}, {}, Mark::line, dash, color};
    for (double r = 2; r <= 101; r *= 1.03) s.add(r, y(value(r), r));
    all.push_back(std::move(s));
  };
  add("Jeffery, exact", Dash::solid, 0,
      [](double r) { return reference::jeffery_period(std::sqrt((r * r + 1) / 2), 1); });
  int place = 1;
  for (const auto hydrodynamics : {Hydrodynamics::interactions, Hydrodynamics::stresslets}) {
    Series s{"", {}, {}, Mark::line, Dash::solid, place++};
    for (int N = 2; N <= 101; N += 1 + N / 12) s.add(N, y(rigid(N, hydrodynamics), N));
    all.push_back(std::move(s));
  }
  int color = 3;
  for (const auto& correlation : reference::aspect_ratio_correlations()) {
    add(std::string(correlation.name), Dash::dashed, color++,
        [&](double r) { return correlated(correlation.name, r); });
  }
  return all;
}

std::vector<std::pair<std::string, Figure>> orbit_figures(const OrbitPoints& points) {
  const auto figure = [&](std::string title, Axis y, const Transform& transform) {
    Figure made{};
    made.title = std::move(title);
    made.x = {"aspect ratio {/:Italic r} = {/:Italic N}", true};
    made.y = std::move(y);
    made.series = series_of(points, transform);
    made.legend_title = "rigid chains";
    return made;
  };
  return {{"fig-5", figure("Fig 5: orbit period of a rigid fiber in shear", {"shear rate times period", true},
                           [](double T, double) { return T; })},
          {"fig-5-over-cox", figure("Fig 5: orbit period over Cox's", {"period over Cox's - 1"},
                                    [](double T, double r) { return T / correlated("Cox", r) - 1; })}};
}

}  // namespace

std::vector<OrbitCase> period_cases(const PeriodSweep& sweep) {
  using dem::Hydrodynamics;
  std::vector<OrbitCase> cases;
  const auto add = [&](Hydrodynamics hydrodynamics, const std::vector<int>& spheres, double tolerance) {
    for (const int N : spheres) {
      // as stiff as not to bend: mu rate/E below 1e-6
      const double stiff = std::clamp(1e-3 * N * N * N, 0.01, 1.0);
      cases.push_back(
          {.spheres = N, .hydrodynamics = hydrodynamics, .elasto_viscous = stiff, .tolerance = tolerance});
    }
  };
  add(Hydrodynamics::free_draining, sweep.spheres, 1e-10);
  add(Hydrodynamics::interactions, sweep.interacting, 1e-8);
  add(Hydrodynamics::stresslets, sweep.stresslets, 1e-7);
  return cases;
}

FlowStudy period_study(const PeriodSweep& sweep, const OrbitOptions& options) {
  std::vector<OrbitCase> cases = period_cases(sweep);
  std::ranges::reverse(cases);  // the dearest first, so that no thread is left with one of them alone
  OrbitPoints points = orbit_points(cases, options);
  std::ranges::reverse(points);
  const auto failed = std::ranges::count_if(points, [](const OrbitPoint& p) { return std::isnan(p.period); });
  return {.table = tabulate(points, orbit_row),
          .figures = orbit_figures(points),
          .failed = static_cast<int>(failed)};
}

}  // namespace fiberchain::compare
