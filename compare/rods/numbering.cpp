#include "compare/rods/numbering.hpp"

#include <algorithm>

#include "compare/rods/benchmark.hpp"

namespace fiberchain::compare {
namespace {

using V = dem::Vec<double, 3>;

constexpr int bonds = 26;  // odd members of 13
const dem::RodPathOptions exact{.tolerance = 1e-12};

dem::Fiber frame_fiber(dem::BondModel bond) {
  return rod_fiber({.bond = bond, .bonds = bonds, .poisson_ratio = 0.17});
}

/// Force in the plane and lateral, E I / L^2.
constexpr V flat_force{1.1, 0.7, 0}, lateral_force{0, 0, 2.9};

dem::RodProblem clamped(dem::Chain<3> chain, int clamp) {
  return {.chain = std::move(chain), .supports = {{.sphere = clamp}}};
}

double distance(const V& a, const V& b, double length) { return dem::norm(a - b) / length; }

V end_of(const dem::Fiber& fiber, bool other_numbers) {
  const auto chain = dem::cornered_chain<3>(fiber, bonds / 2);
  const int end = other_numbers ? 0 : bonds;
  dem::RodProblem frame = clamped(other_numbers ? dem::renumbered(chain) : chain, bonds - end);
  frame.point_loads = {{.sphere = end, .force = rod_units(fiber).force * (flat_force + lateral_force)}};
  return dem::solve_rod(frame, 1, exact).poses[static_cast<std::size_t>(end)].position;
}

V end_after(const dem::Fiber& fiber, const V& first, const V& second) {
  const double unit = rod_units(fiber).force;
  dem::RodProblem frame = clamped(dem::cornered_chain<3>(fiber, bonds / 2), 0);
  frame.point_loads = {{.sphere = bonds, .force = unit * first}};
  frame.start = dem::solve_rod(frame, 1, exact).poses;
  frame.point_loads[0].steady = true;
  frame.point_loads.push_back({.sphere = bonds, .force = unit * second});
  return dem::solve_rod(frame, 1, exact).poses.back().position;
}

template <class Difference>
double worst_of_bonds(const Difference& difference) {
  return std::max(difference(frame_fiber(dem::BondModel::paper)),
                  difference(frame_fiber(dem::BondModel::corrected)));
}

}  // namespace

double l_frame_numbering_difference() {
  return worst_of_bonds([](const dem::Fiber& fiber) {
    return distance(end_of(fiber, false), end_of(fiber, true), rod_length(fiber));
  });
}

double l_frame_path_difference() {
  return worst_of_bonds([](const dem::Fiber& fiber) {
    const V together = end_of(fiber, false), lateral_first = end_after(fiber, lateral_force, flat_force),
            lateral_last = end_after(fiber, flat_force, lateral_force);
    return std::max(distance(together, lateral_first, rod_length(fiber)),
                    distance(together, lateral_last, rod_length(fiber)));
  });
}

}  // namespace fiberchain::compare
