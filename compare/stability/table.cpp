#include "compare/stability/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow row_of(const StabilityPoint& p) {
  const StabilityCase& c = p.asked;
  return {{"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"bond_damping", c.bond_damping},
          {"bond", std::string(dem::name(c.bond))},
          {"scheme", std::string(dem::name(c.scheme))},
          {"ends", std::string(c.ends == reference::ChainEnds::clamped_free ? "clamped_free" : "free_free")},
          {"dimension", std::string(c.dimension == 2 ? "planar" : "spatial")},
          {"stable_step_endless", p.endless},
          {"stable_step_modes", p.modes},
          {"stable_step_measured", p.measured},
          {"stable_step_half_width", p.half_width},
          {"stable_step_difference", p.difference},
          {"bond_time_verdict", p.bond_time_verdict},
          {"quarter_verdict", p.quarter_verdict},
          {"quarter_growth", p.quarter_growth},
          {"steps", static_cast<std::int64_t>(p.steps)},
          {"status", p.status}};
}

}  // namespace

std::vector<StabilityCase> cases(const StabilitySweep& sweep) {
  std::vector<StabilityCase> all;
  for (const auto scheme : sweep.scheme)
    for (const auto bond : sweep.bond)
      for (const auto ends : sweep.ends)
        for (const int dimension : sweep.dimension)
          for (const int aspect_ratio : sweep.aspect_ratio)
            for (const double nu : sweep.poisson_ratio)
              for (const double damping : sweep.bond_damping)
                all.push_back({aspect_ratio, nu, damping, bond, scheme, ends, dimension});
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

}  // namespace fiberchain::compare
