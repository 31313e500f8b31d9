#include "compare/stability/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow row_of(const StabilityCase& c) {
  return {{"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"bond_damping", c.bond_damping},
          {"bond", std::string(dem::name(c.bond))},
          {"form", std::string(dem::name(c.form))},
          {"scheme", std::string(dem::name(c.scheme))},
          {"ends", std::string(c.ends == reference::ChainEnds::clamped_free ? "clamped_free" : "free_free")},
          {"dimension", std::string(c.dimension == 2 ? "planar" : "spatial")}};
}

dem::NamedRow row_of(const StabilityPoint& p) {
  return joined(row_of(p.asked), {{"stable_step_endless", p.endless},
                                  {"stable_step_modes", p.modes},
                                  {"stable_step_measured", p.measured},
                                  {"stable_step_half_width", p.half_width},
                                  {"stable_step_difference", p.difference},
                                  {"bond_time_verdict", p.bond_time_verdict},
                                  {"quarter_verdict", p.quarter_verdict},
                                  {"quarter_growth", p.quarter_growth},
                                  {"steps", static_cast<std::int64_t>(p.steps)},
                                  {"status", p.status}});
}

dem::NamedRow row_of(const GrowthPoint& point, const Growth& growth) {
  return joined(row_of(point.asked.chain),
                {{"step_ratio", growth.step_ratio},
                 {"growth_modes", growth.modes},
                 {"growth_measured", growth.measured},
                 {"growth_difference", growth.measured - growth.modes},
                 {"growth_margin", growth_margin(growth.steps)},
                 {"swell", growth.swell},
                 {"growth_verdict", std::string(growth.grows() ? "unstable" : "stable")},
                 {"steps", growth.steps},
                 {"status", point.status}});
}

/// Every combination, of those schemes alone that have a stable step or have none.
std::vector<StabilityCase> all_cases(const StabilitySweep& sweep, bool stable_step) {
  std::vector<StabilityCase> all;
  for (const auto scheme : sweep.scheme)
    for (const auto bond : sweep.bond)
      for (const auto ends : sweep.ends)
        for (const int dimension : sweep.dimension)
          for (const auto form : sweep.form)
            for (const int aspect_ratio : sweep.aspect_ratio)
              for (const double nu : sweep.poisson_ratio)
                for (const double damping : sweep.bond_damping)
                  if (has_stable_step(scheme) == stable_step)
                    all.push_back({aspect_ratio, nu, damping, bond, scheme, ends, dimension, form});
  return all;
}

}  // namespace

std::vector<StabilityCase> cases(const StabilitySweep& sweep) { return all_cases(sweep, true); }

std::vector<GrowthCase> growth_cases(const StabilitySweep& sweep) {
  std::vector<GrowthCase> all;
  for (const StabilityCase& chain : all_cases(sweep, false)) all.push_back({chain, sweep.step_ratio});
  return all;
}

std::vector<GrowthCase> growth_figure_cases() {
  StabilitySweep sweep{.aspect_ratio = {5, 20},
                       .poisson_ratio = {-0.2, 0, 0.3, 0.49},
                       .bond_damping = {0, 0.1, 1, 10},
                       .dimension = {2, 3},
                       .form = {dem::BondForm::incremental, dem::BondForm::total}};
  std::vector<GrowthCase> all = growth_cases(sweep);
  sweep.aspect_ratio = {50, 200};
  sweep.poisson_ratio = {0.3};
  sweep.bond = {dem::BondModel::paper};
  sweep.dimension = {2};
  const std::vector<GrowthCase> longer = growth_cases(sweep);
  all.insert(all.end(), longer.begin(), longer.end());
  return all;
}

std::vector<StabilityCase> stability_figure_cases() {
  std::vector<StabilityCase> all = cases({});
  StabilitySweep over_aspect_ratio{.aspect_ratio = {5, 7, 14, 20, 30, 50, 100, 200},
                                   .poisson_ratio = {0.3},
                                   .bond_damping = {0, 0.1, 1, 10},
                                   .bond = {dem::BondModel::paper},
                                   .scheme = {dem::Integrator::leapfrog}};
  const auto add = [&] {
    const auto more = cases(over_aspect_ratio);
    all.insert(all.end(), more.begin(), more.end());
  };
  add();
  // solved for, heavy dashpots let a motion grow so slowly that runs take minutes
  over_aspect_ratio.scheme = {dem::Integrator::leapfrog_damped};
  over_aspect_ratio.bond_damping = {0, 0.1, 1};
  add();
  return all;
}

dem::Table stability_table(const std::vector<StabilityPoint>& points) {
  return tabulate(points, [](const StabilityPoint& point) { return row_of(point); });
}

std::string stability_notes(const std::vector<StabilityPoint>& points) {
  double largest = 0;
  int measured = 0, beyond = 0, bond_time = 0, quarter = 0;
  for (const StabilityPoint& p : points) {
    ++measured;
    largest = std::max(largest, std::abs(p.difference));
    beyond += std::abs(p.difference) > 0.01;
    bond_time += p.bond_time_verdict == "unstable";
    quarter += p.quarter_verdict == "unstable";
  }
  if (measured == 0) return "";
  return fmt::format(
      "- Theory of the finite chain against measurement: largest difference {:.2e} over {} chains, {} of "
      "them beyond "
      "1 %.\n"
      "- Paper's rules: a step of t_b is unstable for {} of the {}, one of 0.25 t_b for {}.\n",
      largest, measured, beyond, bond_time, measured, quarter);
}

dem::Table growth_table(const std::vector<GrowthPoint>& points) {
  std::vector<dem::NamedRow> rows;
  for (const GrowthPoint& point : points)
    for (const Growth& growth : point.at) rows.push_back(row_of(point, growth));
  return tabulate(rows, [](const dem::NamedRow& row) { return row; });
}

std::string growth_notes(const std::vector<GrowthPoint>& points) {
  double root = 0, swell = 0, longest = 0;
  int runs = 0, grew = 0, apart = 0;
  for (const GrowthPoint& point : points) {
    for (const Growth& growth : point.at) {
      ++runs;
      root = std::max(root, growth.modes - 1);
      swell = std::max(swell, growth.swell);
      longest = std::max(longest, growth.step_ratio);
      grew += growth.grows();
      apart += std::abs(growth.measured - growth.modes) > growth_margin(growth.steps);
    }
  }
  if (runs == 0) return "";
  return fmt::format(
      "- Bonds solved within the step (leapfrog-stiff), up to {} t_b: of {} runs {} grew; largest speed over "
      "that of "
      "the start {:.3g}; largest |z| of a mode 1 + {:.1e}; growth of runs and of modes apart by more than "
      "the length "
      "of the run explains in {}.\n",
      longest, runs, grew, swell, root, apart);
}

}  // namespace fiberchain::compare
