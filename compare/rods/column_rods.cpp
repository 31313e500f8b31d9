#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/rods/benchmark.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// How an end of a column in a plane is held.
struct ColumnEnd {
  bool along = false, across = true, turn = false;
};

struct Column {
  ColumnEnd begin, end;
  double euler;  ///< load at which the slender one branches [E I / L^2]
};

constexpr Column clamped_free{{true, true, true}, {false, false, false}, pi* pi / 4};
constexpr Column hinged{{true, true, false}, {false, true, false}, pi* pi};
constexpr Column clamped_hinged{{true, true, true}, {false, true, false}, 20.190728556426629};
constexpr Column clamped_clamped{{true, true, true}, {false, true, true}, 4 * pi* pi};

dem::RodProblem chain_column(const dem::Fiber& fiber, const Column& column, double load) {
  dem::RodProblem problem{.chain = dem::straight_chain<3>(fiber), .planar = true};
  const auto support = [&](int sphere, const ColumnEnd& end) {
    if (end.along || end.across || end.turn)
      problem.supports.push_back({.sphere = sphere,
                                  .hold_displacement = {end.along, end.across, true},
                                  .hold_rotation = {true, true, end.turn}});
  };
  support(0, column.begin);
  support(fiber.aspect_ratio, column.end);
  problem.point_loads = {{.sphere = fiber.aspect_ratio, .force = {-load * rod_units(fiber).force, 0, 0}}};
  return problem;
}

reference::RodProblem rod_column(const RodSetting& setting, const Column& column, double load) {
  const dem::Fiber fiber = rod_fiber(setting);
  const auto end_of = [](const ColumnEnd& end) -> reference::RodEnd {
    return {.held = {end.along, end.across, true},
            .joint = end.turn ? reference::RodJoint::clamped : reference::RodJoint::hinge};
  };
  return {.rod = continuum_rod(fiber, {{rod_length(fiber)}}, setting.sheared),
          .begin = end_of(column.begin),
          .end = end_of(column.end),
          .varied = {.force = {-load * rod_units(fiber).force, 0, 0}},
          .planar = true};
}

/// Far enough for stretch and bonds that the branch is passed before.
double beyond(const Column& column) { return 1.4 * column.euler; }

dem::RodPath chain_path(const dem::Fiber& fiber, const Column& column) {
  return dem::trace_rod(
      chain_column(fiber, column, beyond(column)),
      {.control = dem::RodControl::load, .points = 70, .tolerance = 1e-12, .singular_tolerance = 1e-13});
}

double rod_branch(const RodSetting& setting, const Column& column) {
  return beyond(column) * reference::rod_critical_factor(rod_column(setting, column, beyond(column)), 0.5,
                                                         0.99, reference::RodMotion::in_plane);
}

template <const Column* Ends>
RodBenchmark column(std::string_view name, int order_bonds = 40) {
  return {.name = name,
          .multiple = 1,
          .chain = [](const RodSetting& s) -> std::vector<double> {
            const dem::RodPath path = chain_path(rod_fiber(s), *Ends);
            return {beyond(*Ends) * first_singular(path, dem::SingularKind::bifurcation).point.factor};
          },
          .rod = [](const RodSetting& s) -> std::vector<double> { return {rod_branch(s, *Ends)}; },
          .order_bonds = order_bonds};
}

/// A hinged column beyond its load: how far its end has come, how high the middle is.
std::vector<double> chain_beyond(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const dem::RodPath straight = chain_path(fiber, hinged);
  const double scale = setting.load / beyond(hinged), L = rod_length(fiber);
  const dem::RodPath branch = dem::trace_branch(
      chain_column(fiber, hinged, beyond(hinged)), first_singular(straight, dem::SingularKind::bifurcation),
      1, 0.05, {.points = 20, .end_factor = scale, .tolerance = 1e-12, .find_singular = false});
  const auto& poses = branch.points.back().poses;
  return {std::abs(poses[static_cast<std::size_t>(setting.bonds / 2)].position[1]) / L,
          1 - poses.back().position[0] / L};
}

std::vector<double> rod_beyond(const RodSetting& setting) {
  reference::RodProblem problem = rod_column(setting, hinged, setting.load);
  const double L = problem.rod.segments[0].length;
  problem.rod.segments = {{L / 2}, {L / 2}};
  auto guess = reference::rod_at_rest();
  // P / P_cr = (2 K(sin(a/2)) / pi)^2 = 1 + a^2/8 + ..., a the angle of the ends
  const double a = std::min(2.4, std::sqrt(8 * (setting.load / rod_branch(setting, hinged) - 1)));
  guess.orientation = {0, 0, std::sin(a / 2), std::cos(a / 2)};
  guess.force = problem.varied.force;
  const auto found = reference::solve_rod(problem, 1, guess);
  return {std::abs(found.sections[1].position[1]) / L, 1 - found.sections[2].position[0] / L};
}

}  // namespace

std::vector<RodBenchmark> column_rods() {
  return {column<&clamped_free>("column-clamped-free", 10),
          column<&hinged>("column-hinged"),
          column<&clamped_hinged>("column-clamped-hinged"),
          column<&clamped_clamped>("column-clamped"),
          {.name = "column-beyond",
           .load_is = "P L^2/(E I) on a hinged column, beyond pi^2",
           .load = 13,
           .chain = chain_beyond,
           .rod = rod_beyond}};
}

}  // namespace fiberchain::compare
