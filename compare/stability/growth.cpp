#include "compare/stability/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/stirred.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/stopping.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::compare {
namespace {

using reference::ChainMotion;

constexpr double died = 1e-4;  // speeds over those of the start; round-off of positions is at 1e-6

/// The modes of one kind of a chain at one step; the form of the bond does not matter to them.
struct RootCase {
  StabilityCase chain;
  ChainMotion motion;
  double step_ratio;

  auto key() const {
    return std::tuple(chain.aspect_ratio, chain.poisson_ratio, chain.bond_damping, chain.bond, chain.scheme,
                      chain.ends, motion, step_ratio);
  }
  bool operator<(const RootCase& other) const { return key() < other.key(); }
  double cost() const { return std::pow(chain.aspect_ratio + 1.0, 3); }
};

/// Largest |z| of each.
using Roots = std::map<RootCase, double>;

std::vector<RootCase> root_cases(const GrowthCase& asked) {
  std::vector<ChainMotion> motions{ChainMotion::bending, ChainMotion::axial};
  if (asked.chain.dimension == 3) motions.push_back(ChainMotion::twist);
  std::vector<RootCase> all;
  for (const ChainMotion motion : motions)
    for (const double ratio : asked.step_ratios) all.push_back({asked.chain, motion, ratio});
  return all;
}

double largest_root(const RootCase& asked) {
  const reference::LinearChain chain = linear_chain_of(stability_fiber(asked.chain));
  return reference::chain_radius(chain, time_scheme(asked.chain.scheme), asked.motion, asked.chain.ends,
                                 asked.step_ratio * reference::bond_time(chain));
}

/// Of all cases, each once.
Roots largest_roots(const std::vector<GrowthCase>& cases, const StabilityOptions& options) {
  Roots roots;
  for (const GrowthCase& asked : cases)
    for (const RootCase& root : root_cases(asked)) roots.try_emplace(root, 0);
  std::vector<Roots::iterator> all;
  std::vector<double> costs;
  for (auto at = roots.begin(); at != roots.end(); ++at) {
    all.push_back(at);
    costs.push_back(at->first.cost());
  }
  options.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (!options.stopped()) all[i]->second = largest_root(all[i]->first);
  });
  return roots;
}

/// Speeds of a lane after every step, until it died or grew.
struct Speeds {
  std::vector<double> at;

  bool over() const { return !at.empty() && !(at.back() > died && at.back() <= swollen); }
  /// Largest of a part of the run.
  double peak(double from, double to) const {
    const auto size = static_cast<double>(at.size());
    const auto first = at.begin() + static_cast<std::ptrdiff_t>(from * size);
    return *std::max_element(first, at.begin() + static_cast<std::ptrdiff_t>(std::ceil(to * size)));
  }
  double growth() const {
    return std::pow(peak(0.75, 1) / peak(0.25, 0.5), 2 / static_cast<double>(at.size()));
  }
};

/// What runs do at steps that fit into a block.
void measure(const StabilityRun& run, std::vector<Growth>::iterator first,
             std::vector<Growth>::iterator last) {
  std::vector<StirredLane> lanes;
  for (auto at = first; at != last; ++at) {
    const double time_step = at->step_ratio * dem::bond_time_step(run.fiber);
    lanes.push_back({time_step, 1e-7 / time_step});
  }
  std::vector<Speeds> all(lanes.size());
  march_stirred(run, lanes, growth_steps, 1, [&](const std::vector<double>& speeds) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!all[i].over()) all[i].at.push_back(speeds[i]);
    return !std::ranges::all_of(all, &Speeds::over);
  });
  for (const Speeds& speeds : all) {
    first->measured = speeds.growth();
    first->swell = speeds.peak(0, 1);
    first->steps = static_cast<std::int64_t>(speeds.at.size()) - 1;
    ++first;
  }
}

GrowthPoint point_of(const GrowthCase& asked, const Roots& roots) {
  GrowthPoint point{asked, {}, "measured"};
  for (const double ratio : asked.step_ratios) point.at.push_back({ratio, 0, 0, 0, 0});
  for (const RootCase& root : root_cases(asked)) {
    for (Growth& growth : point.at)
      if (growth.step_ratio == root.step_ratio) growth.modes = std::max(growth.modes, roots.at(root));
  }
  const StabilityRun run = run_of(asked.chain);
  const auto lanes = static_cast<std::ptrdiff_t>(lanes_of_block(run));
  for (auto first = point.at.begin(); first != point.at.end();) {
    const auto last = first + std::min(lanes, point.at.end() - first);
    measure(run, first, last);
    first = last;
  }
  return point;
}

void check(const GrowthCase& asked) {
  check(asked.chain);
  if (has_stable_step(asked.chain.scheme)) {
    throw InputError(fmt::format("scheme = {} has a stable step", dem::name(asked.chain.scheme)));
  }
  if (asked.chain.aspect_ratio > 200) {
    throw InputError(fmt::format("aspect_ratio = {} is not allowed with scheme = {}: 1 to 200",
                                 asked.chain.aspect_ratio, dem::name(asked.chain.scheme)));
  }
  for (const double ratio : asked.step_ratios) {
    if (!(ratio > 0 && ratio <= 1e6))
      throw InputError(fmt::format("step_ratio = {} is not allowed: above 0, up to 1e6", ratio));
  }
}

double cost_of(const GrowthCase& asked) {
  return (asked.chain.aspect_ratio + 1.0) * growth_steps * asked.chain.dimension;
}

}  // namespace

bool Growth::grows() const { return !(swell <= swollen); }

double growth_margin(std::int64_t steps) {
  return std::expm1(std::log(1e3) * 2 / static_cast<double>(steps));
}

std::vector<GrowthPoint> growth_points(const std::vector<GrowthCase>& cases,
                                       const StabilityOptions& options) {
  for (const GrowthCase& asked : cases) check(asked);
  std::vector<double> costs;
  std::vector<GrowthPoint> points;
  for (const GrowthCase& asked : cases) {
    costs.push_back(cost_of(asked));
    points.push_back({asked, {}, std::string(not_begun)});
  }
  const Roots roots = largest_roots(cases, options);
  options.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (options.stopped()) return;
    points[i] = point_of(cases[i], roots);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
