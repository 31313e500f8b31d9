#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/rods/numbering.hpp"
#include "compare/rods/study.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// Order in the number of bonds at the usual load and at an odd one, the farther from what is expected, for
/// both bonds; with the error of the finer chain.
std::vector<Measured> orders(std::string_view name) {
  const RodBenchmark& one = rod_benchmark(name);
  std::vector<Measured> found;
  for (const auto bond : {dem::BondModel::paper, dem::BondModel::corrected}) {
    const double expected = bond == dem::BondModel::paper ? one.order_paper : one.order_corrected;
    double worst = expected, error = 0;
    for (const auto& [nu, factor] : {std::pair{0.17, 1.0}, std::pair{0.41, 0.83}}) {
      const RodSetting coarse{bond, one.order_bonds, nu, factor * one.load},
          fine{bond, 2 * one.order_bonds, nu, factor * one.load};
      const double last = rod_error(one, fine), order = std::log2(rod_error(one, coarse) / last);
      if (factor == 1) error = last;
      if (!(std::abs(order - expected) <= std::abs(worst - expected))) worst = order;
    }
    found.push_back({worst, {2 * one.order_bonds, error}});
  }
  return found;
}

/// The 45 degree bend of Bathe and Bolourchi: radius 100, E = 1e7, section 1 x 1: E I, E A, and G A and G J =
/// E I of a round one without lateral contraction.
std::vector<double> bend_tip(dem::BondModel bond, int bonds, double force, bool by_chain) {
  const double length = 25 * pi, diameter = 2 / std::sqrt(3.0);
  const RodSetting setting{bond, bonds, 0, force * length * length / (1e7 / 12), length / diameter / bonds};
  const RodBenchmark& bend = rod_benchmark("bend");
  const std::vector<double> end = by_chain ? bend.chain(setting) : bend.rod(setting);
  return {length * end[1], length * end[0], length * end[2]};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < b.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

std::vector<Measured> bends(const ValidationInput&) {
  struct Printed {
    double force;
    std::vector<double> tip;
  };
  const Printed printed[] = {{300, {22.33, 58.84, 40.08}},
                             {600, {15.79, 47.23, 53.37}},
                             {300, {22.5, 59.2, 39.5}},
                             {600, {15.9, 47.2, 53.4}}};
  std::vector<Measured> found;
  for (const Printed& row : printed) {
    const auto chain = bend_tip(dem::BondModel::corrected, 68, row.force, true),
               rod = bend_tip(dem::BondModel::corrected, 68, row.force, false),
               eight = bend_tip(dem::BondModel::paper, 8, row.force, true);
    found.push_back({largest_difference(chain, row.tip),
                     {chain[0], chain[1], chain[2], largest_difference(chain, rod),
                      largest_difference(eight, row.tip), eight[0], eight[1], eight[2]}});
  }
  return found;
}

/// First limit of Lee's frame over E I / 120^2, its members 120 long of 6 in area and 2 in inertia.
std::vector<Measured> lees_frame(const ValidationInput&) {
  const double slenderness = 240 / (4 * std::sqrt(2.0 / 6));
  const auto setting = [&](dem::BondModel bond) { return RodSetting{bond, 100, 0.3, 1, slenderness / 100}; };
  const RodSetting corrected = setting(dem::BondModel::corrected);
  const auto chain = lees_path_of_chain(corrected, 0.3).limits, rod = lees_path_of_rod(corrected, 0.3).limits,
             sheared = lees_path_of_rod(setting(dem::BondModel::paper), 0.3).limits;
  return {{chain.at(0) / 4, {rod.at(0) / 4, sheared.at(0) / 4, chain.at(1) / 4, rod.at(1) / 4}}};
}

/// A slender fiber of 80 bonds, L / d = 800.
RodSetting slender(double poisson_ratio) { return {dem::BondModel::corrected, 80, poisson_ratio, 1, 10}; }

std::vector<Measured> deep_arch(const ValidationInput&) {
  const double unit = std::pow(215 * pi / 180, 2);  // (L / R)^2
  const RodBenchmark& arch = rod_benchmark("deep-arch");
  return {{100 * arch.chain(slender(0.3)).front() / unit, {100 * arch.rod(slender(0.3)).front() / unit}}};
}

std::vector<Measured> twisted_ring(const ValidationInput&) {
  double worst = 1;
  for (const double nu : {0.0, 0.17, 0.41}) {
    const double ratio = rod_benchmark("twisted-ring").chain(slender(nu)).front() / michell_turn(nu);
    if (std::abs(ratio - 1) > std::abs(worst - 1)) worst = ratio;
  }
  return {{worst}};
}

std::vector<Measured> euler_loads(const ValidationInput&) {
  const std::pair<std::string_view, double> columns[] = {{"column-clamped-free", pi * pi / 4},
                                                         {"column-hinged", pi * pi},
                                                         {"column-clamped-hinged", 20.190728556426629},
                                                         {"column-clamped", 4 * pi * pi}};
  double worst = 1;
  for (const auto& [name, euler] : columns) {
    const double ratio = rod_benchmark(name).chain(slender(0.17)).front() / euler;
    if (std::abs(ratio - 1) > std::abs(worst - 1)) worst = ratio;
  }
  return {{worst}};
}

/// Frames of Argyris et al., whose flat section no chain has: the rod by shooting.
reference::RodProblem flat_frame(double corner) {
  constexpr double E = 71240, b = 30, t = 0.6;
  return {.rod = {.segments = {{240, {}, corner}, {240, {}, -pi / 2}},
                  .bending = E * t * b * b * b / 12,
                  .torsion = E / 2.62 * b * t * t * t / 3,
                  .axial = E * b * t,
                  .sideways = E * b * t * t * t / 12},
          .planar = true};
}

std::vector<Measured> flat_frames(const ValidationInput&) {
  using enum reference::RodMotion;
  reference::RodProblem clamped = flat_frame(0);
  clamped.varied.force = {1, 0, 0};
  const double force = reference::rod_critical_factor(clamped, 0.9, 1.3, out_of_plane);
  double moments[2];
  for (int i = 0; i < 2; ++i) {
    reference::RodProblem hinged = flat_frame(pi / 4);
    hinged.begin.joint = reference::RodJoint::hinge;
    hinged.end = {.held = {false, true, true}, .joint = reference::RodJoint::hinge};
    const double way = i == 0 ? 1 : -1;
    hinged.varied.moment = {0, 0, way}, hinged.varied.begin_moment = {0, 0, -way};
    moments[i] = reference::rod_critical_factor(hinged, 600, 628, out_of_plane);
  }
  return {{force}, {moments[0], {moments[1]}}};
}

template <std::size_t... I>
Checks order_checks(std::index_sequence<I...>) {
  const auto ids = [](std::string_view name) -> std::vector<std::string> {
    return {"rods-" + std::string(name) + "-paper", "rods-" + std::string(name) + "-corrected"};
  };
  return {{.ids = ids(rod_benchmarks()[I].name),
           .measure = [](const ValidationInput&) { return orders(rod_benchmarks()[I].name); }}...};
}

}  // namespace

const Checks& rods_checks() {
  using In = ValidationInput;
  using Found = std::vector<Measured>;
  static const Checks checks = merged(
      order_checks(std::make_index_sequence<18>()),
      {{{"rods-bend-simo-300", "rods-bend-simo-600", "rods-bend-bathe-300", "rods-bend-bathe-600"}, bends},
       {{"rods-lees-frame-limit"}, lees_frame},
       {{"rods-deep-arch-limit"}, deep_arch},
       {{"rods-twisted-ring-michell"}, twisted_ring},
       {{"rods-euler-loads"}, euler_loads},
       {{"rods-flat-frame-clamped", "rods-flat-frame-hinged"}, flat_frames},
       {{"rods-l-frame-numbering"}, [](const In&) -> Found { return {{l_frame_numbering_difference()}}; }},
       {{"rods-l-frame-path"}, [](const In&) -> Found { return {{l_frame_path_difference()}}; }}});
  return checks;
}

}  // namespace fiberchain::compare
