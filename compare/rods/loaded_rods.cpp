#include <cmath>
#include <numbers>

#include "compare/rods/benchmark.hpp"
#include "dem/chain/rod_shapes.hpp"

namespace fiberchain::compare {
namespace {

using dem::LoadDirection;
using V = dem::Vec<double, 3>;
using std::numbers::pi;

/// Loads of a clamped rod in their units. Those that follow are given in the end's frame.
struct CantileverLoads {
  V force{}, moment{}, following_force{}, weight{}, following_weight{};
  dem::LineLoads rule = dem::LineLoads::consistent;
};

/// A clamped rod: an arc at rest, or two members with a corner half way.
struct Cantilever {
  double arc = 0;
  bool corner = false;
  CantileverLoads loads{};
};

std::vector<double> both(std::vector<double> end, const std::vector<double>& middle) {
  end.insert(end.end(), middle.begin(), middle.end());
  return end;
}

/// Places of the end and of the middle.
std::vector<double> chain_places(const RodSetting& setting, const Cantilever& c) {
  const dem::Fiber fiber = rod_fiber(setting, c.arc);
  const RodUnits unit = rod_units(fiber);
  const int n = setting.bonds;
  dem::RodProblem problem{.chain = c.corner     ? dem::cornered_chain<3>(fiber, n / 2)
                                   : c.arc != 0 ? dem::arc_rod(fiber)
                                                : dem::straight_chain<3>(fiber)};
  problem.supports = {{.sphere = 0}};
  const CantileverLoads& loads = c.loads;
  problem.point_loads = {
      {.sphere = n, .force = unit.force * loads.force, .moment = unit.moment * loads.moment},
      {.sphere = n, .force = unit.force * loads.following_force, .direction = LoadDirection::following}};
  problem.line_loads = {{.first = 0, .last = n, .force = unit.line_load * loads.weight},
                        {.first = 0,
                         .last = n,
                         .force = unit.line_load * loads.following_weight,
                         .direction = LoadDirection::following}};
  problem.line_load_rule = loads.rule;
  const dem::Poses<3> poses = dem::solve_rod(problem, 1, {.tolerance = 1e-12}).poses;
  return both(over(poses.back().position, unit.length),
              over(poses[static_cast<std::size_t>(n / 2)].position, unit.length));
}

std::vector<double> rod_places(const RodSetting& setting, const Cantilever& c) {
  const dem::Fiber fiber = rod_fiber(setting, c.arc);
  const RodUnits unit = rod_units(fiber);
  const reference::SpaceVector curvature{0, 0, c.arc / unit.length};
  const double half = unit.length / 2;
  const std::vector<reference::RodSegment> parts{{half, curvature}, {half, curvature, c.corner ? pi / 2 : 0}};
  const CantileverLoads& loads = c.loads;
  const reference::RodProblem problem{
      .rod = continuum_rod(fiber, parts, setting.sheared),
      .varied = {.force = vector_of(unit.force * loads.force),
                 .moment = vector_of(unit.moment * loads.moment),
                 .weight = vector_of(unit.line_load * loads.weight),
                 .following_force = vector_of(unit.force * loads.following_force),
                 .following_weight = vector_of(unit.line_load * loads.following_weight)}};
  const auto sections = reference::follow_rod(problem, 1, 10).sections;
  return both(over(sections[2].position, unit.length), over(sections[1].position, unit.length));
}

/// Both sides of a cantilever whose loads are a function of the setting's one.
template <Cantilever (*Of)(double load)>
RodBenchmark cantilever(std::string_view name, std::string_view load_is, double load, std::size_t shown,
                        double order_corrected = 4) {
  return {.name = name,
          .load_is = load_is,
          .load = load,
          .shown = shown,
          .order_corrected = order_corrected,
          .chain = [](const RodSetting& s) { return chain_places(s, Of(s.load)); },
          .rod = [](const RodSetting& s) { return rod_places(s, Of(s.load)); }};
}

Cantilever ring(double load) { return {.loads = {.moment = {0, 0, load}}}; }

/// A wrench whose axis leans against the rod's first tangent: a helix and what the ends do to it.
Cantilever helix(double load) {
  return {.loads = {.force = load * V{0.4, 1.3, -0.9}, .moment = load * V{2.6, 2, 4}}};
}

Cantilever bend(double load) { return {.arc = pi / 4, .loads = {.force = {0, 0, load}}}; }

Cantilever weight_lumped(double load) {
  return {.loads = {.weight = {0, -load, 0}, .rule = dem::LineLoads::lumped}};
}

Cantilever weight(double load) { return {.loads = {.weight = {0, -load, 0}}}; }

Cantilever arc_weight(double load) { return {.arc = pi / 2, .loads = {.weight = {0, 0, -load}}}; }

Cantilever follower(double load) { return {.loads = {.following_force = {0, load, 0}}}; }

Cantilever pressure(double load) { return {.loads = {.following_weight = {0, load, 0}}}; }

Cantilever l_frame(double load) { return {.corner = true, .loads = {.force = load * V{0.7, 0.4, 2.1}}}; }

}  // namespace

std::vector<RodBenchmark> loaded_rods() {
  return {cantilever<ring>("ring", "M L/(E I) at the end", 2 * pi, 4),
          cantilever<helix>("helix", "a wrench at the end, times it", 1, 2),
          cantilever<bend>("bend", "P L^2/(E I) out of the plane", 4.441, 2),
          cantilever<weight_lumped>("weight-lumped", "w L^3/(E I), half a bond's on each of its spheres", 7.3,
                                    1, 2),
          cantilever<weight>("weight", "w L^3/(E I), with end moments", 7.3, 1),
          cantilever<arc_weight>("arc-weight", "w L^3/(E I) out of the plane of a quarter arc", 5.1, 2),
          cantilever<follower>("follower", "P L^2/(E I) across the end, turning with it", 9.7, 1),
          cantilever<pressure>("pressure", "w L^3/(E I) across the rod, turning with it", 11.3, 1),
          cantilever<l_frame>("l-frame", "a force at the end, times it", 1, 2)};
}

}  // namespace fiberchain::compare
