#include <cmath>
#include <numbers>

#include "compare/rods/benchmark.hpp"
#include "dem/chain/rod_shapes.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

// Lee's frame: two members, hinged at both ends, a force at a fifth of the second one, toward the first one's
// begin. At load factor 1 it is beyond its first limit, E I / L^2.
constexpr double lee_load = 80;

/// Load factor of a limit point's equilibrium by the balance of the loaded sphere: where the factor turns,
/// that of the nearest equilibrium that was found is better than what lies on the line between two.
double limit_factor(const dem::RodProblem& problem, const dem::SingularPoint& limit) {
  const auto sphere = static_cast<std::size_t>(problem.point_loads.front().sphere);
  const auto none = dem::rod_forces(problem, limit.point.poses, 0)[sphere],
             whole = dem::rod_forces(problem, limit.point.poses, 1)[sphere];
  const auto load = whole - none;
  return -none.dot(load) / load.dot(load);
}

dem::RodProblem lees_chain(const dem::Fiber& fiber) {
  const int n = fiber.aspect_ratio;
  dem::RodProblem frame{.chain = dem::cornered_chain<3>(fiber, n / 2), .planar = true};
  for (const int end : {0, n})
    frame.supports.push_back({.sphere = end, .hold_rotation = {true, true, false}});
  frame.point_loads = {{.sphere = n / 2 + n / 10, .force = {-lee_load * rod_units(fiber).force, 0, 0}}};
  return frame;
}

reference::RodProblem lees_rod(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const double L = rod_length(fiber);
  const reference::RodEnd hinge{.joint = reference::RodJoint::hinge};
  const reference::SpaceVector force{-lee_load * rod_units(fiber).force, 0, 0};
  return {
      .rod = continuum_rod(fiber, {{L / 2}, {L / 10, {}, pi / 2}, {0.4 * L, {}, 0, force}}, setting.sheared),
      .begin = hinge,
      .end = hinge,
      .planar = true};
}

// The right-angle frame: hinged in its plane, its end may slide towards its begin, moments at both bend it.
constexpr double frame_moment = 7;

double chain_frame_moment(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const int n = setting.bonds;
  dem::RodProblem frame{.chain = dem::cornered_chain<3>(fiber, n / 2)};
  const dem::Quaternion<double> base{std::cos(pi / 8), {0, 0, std::sin(pi / 8)}};
  frame.supports = {{.sphere = 0, .hold_rotation = {true, true, false}},
                    {.sphere = n,
                     .hold_displacement = {false, true, true},
                     .hold_rotation = {true, true, false},
                     .axes = base}};
  const double M = frame_moment * rod_units(fiber).moment;
  frame.point_loads = {{.sphere = 0, .moment = {0, 0, -M}}, {.sphere = n, .moment = {0, 0, M}}};
  const dem::RodPath path = dem::trace_rod(
      frame,
      {.control = dem::RodControl::load, .points = 600, .tolerance = 1e-12, .singular_tolerance = 1e-13});
  return frame_moment * first_singular(path, dem::SingularKind::bifurcation).point.factor;
}

double rod_frame_moment(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const double L = rod_length(fiber), M = frame_moment * rod_units(fiber).moment;
  // the base along x, so that the end slides along an axis
  reference::RodProblem frame{
      .rod = continuum_rod(fiber, {{L / 2, {}, -pi / 4}, {L / 2, {}, pi / 2}}, setting.sheared),
      .begin = {.joint = reference::RodJoint::hinge},
      .end = {.held = {false, true, true}, .joint = reference::RodJoint::hinge},
      .varied = {.moment = {0, 0, M}, .begin_moment = {0, 0, -M}},
      .planar = true};
  // the first of the zeros: steps of 1/30 as far as the sign stays
  double low = 0.5;
  const auto sign_at = [&](double factor) {
    return std::signbit(reference::follow_rod(frame, factor).out_of_plane);
  };
  const bool sign = sign_at(low);
  while (low < 1 && sign_at(low + 1.0 / 30) == sign) low += 1.0 / 30;
  return frame_moment *
         reference::rod_critical_factor(frame, low, low + 1.0 / 30, reference::RodMotion::out_of_plane);
}

// The deep arch: 215 degrees of a circle, clamped and hinged, a force at the middle toward the center (D. A.
// DaDeppo, R. Schmidt, J. Appl. Mech. 42 (1975) 896-898).
constexpr double arch_angle = 215 * pi / 180, arch_load = 140;

double chain_arch(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting, arch_angle);
  const int n = setting.bonds;
  dem::RodProblem arch{.chain = dem::arc_rod(fiber), .planar = true};
  arch.supports = {{.sphere = 0}, {.sphere = n, .hold_rotation = {true, true, false}}};
  const dem::Vec<double, 3> inward{-std::sin(arch_angle / 2), std::cos(arch_angle / 2), 0};
  arch.point_loads = {{.sphere = n / 2, .force = arch_load * rod_units(fiber).force * inward}};
  const dem::RodPath path = dem::trace_rod(arch, {.points = 60,
                                                  .most_points = 2000,
                                                  .end_factor = 2,
                                                  .end_displacement = 0.33 * rod_length(fiber),
                                                  .probe = {n / 2, inward},
                                                  .tolerance = 1e-12,
                                                  .singular_tolerance = 1e-13});
  return arch_load * limit_factor(arch, first_singular(path, dem::SingularKind::limit_point));
}

double rod_arch(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting, arch_angle);
  const double L = rod_length(fiber), force = arch_load * rod_units(fiber).force, half = arch_angle / 2;
  const reference::SpaceVector curvature{0, 0, arch_angle / L},
      inward{-force * std::sin(half), force * std::cos(half), 0};
  const reference::RodProblem arch{
      .rod = continuum_rod(fiber, {{L / 2, curvature}, {L / 2, curvature, 0, inward}}, setting.sheared),
      .end = {.joint = reference::RodJoint::hinge},
      .planar = true};
  const auto path = reference::rod_path(arch, reference::solve_rod(arch, 0, reference::rod_at_rest()),
                                        {.ends = [](const auto& at) { return at.slope < 0; }});
  return arch_load * reference::rod_limit_points(arch, path).at(0).factor;
}

}  // namespace

LeesPath lees_path_of_chain(const RodSetting& setting, double downward) {
  const dem::Fiber fiber = rod_fiber(setting);
  const int n = setting.bonds;
  const double L = rod_length(fiber);
  const dem::RodProblem frame = lees_chain(fiber);
  const dem::RodPath path = dem::trace_rod(frame, {.points = 60,
                                                   .most_points = 4000,
                                                   .end_factor = 10,
                                                   .end_displacement = downward * L,
                                                   .probe = {n / 2 + n / 10, {-1, 0, 0}},
                                                   .tolerance = 1e-12,
                                                   .singular_tolerance = 1e-13});
  LeesPath found;
  for (const dem::RodPoint& point : path.points) {
    found.down.push_back(point.probe / L);
    found.load.push_back(point.factor * lee_load);
  }
  for (const dem::SingularPoint& point : path.singular)
    if (point.kind == dem::SingularKind::limit_point)
      found.limits.push_back(limit_factor(frame, point) * lee_load);
  return found;
}

LeesPath lees_path_of_rod(const RodSetting& setting, double downward) {
  const reference::RodProblem frame = lees_rod(setting);
  const double L = rod_length(rod_fiber(setting));
  const auto down = [&](const reference::RodEquilibrium& at) { return 0.5 - at.sections[2].position[0] / L; };
  const auto path =
      reference::rod_path(frame, reference::solve_rod(frame, 0, reference::rod_at_rest()),
                          {.points = 400, .ends = [&](const auto& at) { return down(at) > downward; }});
  LeesPath found;
  for (const auto& at : path) found.down.push_back(down(at)), found.load.push_back(at.factor * lee_load);
  for (const auto& at : reference::rod_limit_points(frame, path))
    found.limits.push_back(at.factor * lee_load);
  return found;
}

std::vector<RodBenchmark> frame_rods() {
  return {{.name = "lees-frame",
           .multiple = 10,
           .chain = [](const RodSetting& s) { return lees_path_of_chain(s, 0.3).limits; },
           .rod = [](const RodSetting& s) { return lees_path_of_rod(s, 0.3).limits; }},
          {.name = "right-angle-frame",
           .chain = [](const RodSetting& s) -> std::vector<double> { return {chain_frame_moment(s)}; },
           .rod = [](const RodSetting& s) -> std::vector<double> { return {rod_frame_moment(s)}; }},
          {.name = "deep-arch",
           .chain = [](const RodSetting& s) -> std::vector<double> { return {chain_arch(s)}; },
           .rod = [](const RodSetting& s) -> std::vector<double> { return {rod_arch(s)}; }}};
}

}  // namespace fiberchain::compare
