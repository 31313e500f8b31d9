#include "compare/breaking/released_rod.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiberchain::compare {
namespace {

using V = dem::Vec<double, 3>;
using std::numbers::pi;

std::int64_t steps_of(const ReleasedRod& rod, double step) {
  return std::llround(time_of_way(rod.fiber, undisturbed_way(rod.fiber.aspect_ratio)) / step);
}

}  // namespace

dem::ChainState<3> arc(const dem::Chain<3>& chain, double angle) {
  const double l = dem::bond_length(chain.fiber);
  dem::ChainState<3> state = dem::at_rest<3>(chain.poses);
  for (int i = 1; i <= chain.fiber.aspect_ratio; ++i) {
    const double direction = (i - 0.5) * angle;
    state.poses[i].orientation = dem::rotation(V{0, 0, i * angle});
    state.poses[i].position =
        state.poses[i - 1].position + l * V{std::cos(direction), std::sin(direction), 0};
  }
  return state;
}

ReleasedRod released_rod(int aspect_ratio) {
  dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431), 0.0262, aspect_ratio};
  return {fiber, 0.05 / dem::fiber_length(fiber)};
}

double time_of_way(const dem::Fiber& fiber, double diameters) {
  const double s = diameters * fiber.diameter,
               c = std::sqrt(dem::bending_stiffness(fiber) * dem::bond_length(fiber) /
                             dem::sphere_mass(fiber));
  return s * s / (4 * pi * c);
}

double undisturbed_way(int aspect_ratio) { return 2.9 * std::sqrt(aspect_ratio); }

double largest_curvature_of_beam() {
  constexpr int n = 2000;  // Simpson's rule for the integral of sin(pi y^2 / 2) to sqrt(2)
  const double h = std::numbers::sqrt2 / n;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double y = k * h, weight = k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2;
    sum += weight * std::sin(0.5 * pi * y * y);
  }
  return 2 * sum * h / 3;
}

double stress_at_rest(const ReleasedRod& rod) {
  return rod.fiber.material.youngs_modulus * dem::sphere_radius(rod.fiber) * rod.curvature;
}

dem::Assembly assembly_of(const ReleasedRod& rod, dem::AssemblyOptions options) {
  const dem::Fiber& fiber = rod.fiber;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double moment = dem::bending_stiffness(fiber) * rod.curvature;
  dem::Grip clamp, hold;
  clamp.place = clamp.turn = {true, true, true}, clamp.spheres = {{0, 0, 0}};
  hold.moment = {0, 0, moment}, hold.spheres = {{0, 0, fiber.aspect_ratio}};
  dem::Grip release = hold;
  release.moment = {0, 0, -moment}, release.ramp = time_of_way(fiber, rod.release_way);
  options.grips = {clamp, hold, release};
  return {{{chain, {arc(chain, rod.curvature * dem::bond_length(fiber))}}}, {}, options};
}

double largest_curvature(const ReleasedRod& rod, const dem::AssemblyOptions& options) {
  dem::Assembly assembly = assembly_of(rod, options);
  double largest = 0;
  for (const std::int64_t steps = steps_of(rod, assembly.step()); assembly.steps() < steps;) {
    assembly.march(8);
    for (const dem::BondState& bond : assembly.bonds(0, 0)) largest = std::max(largest, bond.bending_angle);
  }
  return largest / (rod.curvature * dem::bond_length(rod.fiber));
}

std::vector<dem::BondBreak> breaks_of(const ReleasedRod& rod, const dem::AssemblyOptions& options) {
  dem::Assembly assembly = assembly_of(rod, options);
  assembly.march(steps_of(rod, assembly.step()));
  return assembly.take_breaks();
}

}  // namespace fiberchain::compare
