#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compare/stability/table.hpp"

namespace fiberchain::compare {
namespace {

using StabilityPoints = std::vector<StabilityPoint>;
using reference::ChainEnds;

std::string kind_name(const StabilityCase& c) {
  return fmt::format("{}-{}", dem::name(c.bond), dem::name(c.scheme));
}

std::string kind_title(const StabilityCase& c) {
  return fmt::format("{} bond, {}", dem::name(c.bond),
                     c.scheme == dem::Integrator::leapfrog ? "lagged dashpots" : "solved dashpots");
}

std::set<double> values(const StabilityPoints& points, double StabilityCase::*of) {
  std::set<double> all;
  for (const StabilityPoint& p : points) all.insert(p.asked.*of);
  return all;
}

StabilityPoints with_aspect_ratio(const StabilityPoints& points, int aspect_ratio) {
  StabilityPoints some;
  std::ranges::copy_if(points, std::back_inserter(some),
                       [&](const StabilityPoint& p) { return p.asked.aspect_ratio == aspect_ratio; });
  return some;
}

Figure heat_map(const StabilityPoints& points) {
  const std::set<double> nu = values(points, &StabilityCase::poisson_ratio);
  const std::set<double> xi = values(points, &StabilityCase::bond_damping);
  HeatMap map{
      .x = {nu.begin(), nu.end()}, .y = {xi.begin(), xi.end()}, .label = "d{/:Italic t}/{/:Italic t}_b"};
  const auto place = [](const std::set<double>& all, double value) {
    return std::distance(all.begin(), all.find(value));
  };
  const double missing = std::nan("");
  map.value.assign(xi.size(), std::vector<double>(nu.size(), missing));
  for (const StabilityPoint& p : points) {
    map.value[place(xi, p.asked.bond_damping)][place(nu, p.asked.poisson_ratio)] = p.measured;
  }
  map.framed_below = 0.25;
  const StabilityCase& c = points[0].asked;
  return {.title = fmt::format("Largest stable step, {}, r_f = {}", kind_title(c), c.aspect_ratio),
          .x = {"Poisson's ratio ν (framed: the paper's 0.25 {/:Italic t}_b is unstable)"},
          .y = {"ξ_b"},
          .series = {},
          .map = map};
}

Series level(double height, double from, double to, const std::string& label) {
  return {label, {from, to}, {height, height}, Mark::line, Dash::dotted, 7};
}

/// Theory as lines, measurement as points, a color per Poisson's ratio.
Figure damping_curves(const StabilityPoints& points) {
  const StabilityCase& any = points[0].asked;
  Figure figure{.title = fmt::format("Largest stable step, {}, r_f = {}", kind_title(any), any.aspect_ratio),
                .x = {"ξ_b (lines: theory, points: runs)", true},
                .y = {"d{/:Italic t}/{/:Italic t}_b", true},
                .series = {}};
  const std::set<double> damped = values(points, &StabilityCase::bond_damping);
  const double low = *std::ranges::find_if(damped, [](double xi) { return xi > 0; }) / 3,
               high = *damped.rbegin();
  int color = 0;
  for (const double nu : values(points, &StabilityCase::poisson_ratio)) {
    // in the plane the corrected bond knows nothing of nu
    const bool any_nu = any.bond == dem::BondModel::corrected && any.dimension == 2;
    if (nu != 0.3 && (any_nu || (nu != -0.2 && nu != 0 && nu != 0.49))) continue;
    Series theory{any_nu ? "any ν" : fmt::format("ν = {}", nu), {}, {}, Mark::line, Dash::solid, color};
    for (int i = 0; i <= 60; ++i) {
      StabilityCase at = any;
      at.poisson_ratio = nu;
      at.bond_damping = low * std::pow(high / low, i / 60.0);
      theory.add(at.bond_damping, modal_limit(at));
    }
    Series runs{"", {}, {}, Mark::points, Dash::solid, color++};
    for (const StabilityPoint& p : points) {
      if (p.asked.poisson_ratio != nu || p.asked.bond_damping == 0) continue;
      runs.add(p.asked.bond_damping, p.measured);
    }
    figure.series.push_back(theory);
    figure.series.push_back(runs);
  }
  figure.series.push_back(level(0.25, low, high, "0.25 t_b"));
  return figure;
}

/// The limit over that of the endless chain, a color per damping.
Figure aspect_ratio_curves(const StabilityPoints& points) {
  const StabilityCase& any = points[0].asked;
  Figure figure{
      .title = fmt::format("Limit of finite chains, {}, ν = {}", kind_title(any), any.poisson_ratio),
      .x = {"{/:Italic r}_f (lines: theory, points: runs)", true},
      .y = {"limit / endless chain's limit"},
      .series = {}};
  std::set<int> aspect_ratios;
  for (const StabilityPoint& p : points) aspect_ratios.insert(p.asked.aspect_ratio);
  int color = 0;
  for (const double xi : values(points, &StabilityCase::bond_damping)) {
    Series theory{fmt::format("ξ_b = {}", xi), {}, {}, Mark::line, Dash::solid, color};
    Series runs{"", {}, {}, Mark::points, Dash::solid, color++};
    StabilityCase at = any;
    at.bond_damping = xi;
    const double endless = endless_limit(at), low = *aspect_ratios.begin(), high = *aspect_ratios.rbegin();
    int before = 0;
    for (int i = 0; i <= 60; ++i) {
      at.aspect_ratio = static_cast<int>(std::lround(low * std::pow(high / low, i / 60.0)));
      if (at.aspect_ratio == before) continue;
      before = at.aspect_ratio;
      theory.add(at.aspect_ratio, modal_limit(at) / endless);
    }
    for (const StabilityPoint& p : points) {
      if (p.asked.bond_damping != xi) continue;
      runs.add(p.asked.aspect_ratio, p.measured / endless);
    }
    figure.series.push_back(theory);
    figure.series.push_back(runs);
  }
  return figure;
}

void add_figures(std::vector<std::pair<std::string, Figure>>& figures, const std::string& kind,
                 const StabilityPoints& points) {
  std::set<int> aspect_ratios;
  for (const StabilityPoint& p : points) aspect_ratios.insert(p.asked.aspect_ratio);
  for (const int aspect_ratio : aspect_ratios) {
    const StabilityPoints at = with_aspect_ratio(points, aspect_ratio);
    const std::set<double> nu = values(at, &StabilityCase::poisson_ratio),
                           xi = values(at, &StabilityCase::bond_damping);
    const std::string name = fmt::format("{}-{}", kind, aspect_ratio);
    if (nu.size() > 1 && xi.size() > 1) figures.emplace_back("stability-map-" + name, heat_map(at));
    const bool curves = *xi.rbegin() > 0 && xi.size() > 2 && (nu.size() > 1 || aspect_ratios.size() == 1);
    if (curves && nu.contains(0.3)) figures.emplace_back("stability-damping-" + name, damping_curves(at));
  }
  StabilityPoints usual;
  std::ranges::copy_if(points, std::back_inserter(usual), [&](const StabilityPoint& p) {
    return p.asked.poisson_ratio == 0.3 && std::set{0.0, 0.1, 1.0, 10.0}.contains(p.asked.bond_damping);
  });
  if (aspect_ratios.size() > 2 && !usual.empty())
    figures.emplace_back("stability-aspect-ratio-" + kind, aspect_ratio_curves(usual));
}

}  // namespace

std::vector<std::pair<std::string, Figure>> stability_figures(const std::vector<StabilityPoint>& points) {
  std::map<std::string, StabilityPoints> kinds;
  for (const StabilityPoint& p : points) {
    std::string kind = kind_name(p.asked);
    if (p.asked.ends == ChainEnds::free_free) kind += "-free";
    if (p.asked.dimension == 3) kind += "-spatial";
    kinds[kind].push_back(p);
  }
  std::vector<std::pair<std::string, Figure>> figures;
  for (const auto& [kind, group] : kinds) add_figures(figures, kind, group);
  return figures;
}

}  // namespace fiberchain::compare
