#pragma once

#include "dem/insertion/random_insertion.hpp"
#include "tests/dem/assembly/assembly_scenes.hpp"

/// Fibers of two kinds, 9 spheres and 14 of another diameter and material, one curved, that fall and meet.
namespace scenes {

struct SmallPacking {
  std::vector<dem::FiberGroup> groups;
  dem::Domain around;

  dem::Assembly assembly(dem::AssemblyOptions options) const { return {groups, around, std::move(options)}; }

  /// An unsteady flow, the same everywhere along x and y.
  void stir_with_fluid() {
    const dem::Fiber& fiber = groups[0].chain.fiber;
    const double rate = 0.4 * dem::sphere_mass(fiber) / dem::stokes_drag({1, {}}, fiber).translation / 0.01;
    dem::Gradient A{};
    A[0][2] = 40;
    around.fluid = dem::Fluid{rate, dem::oscillation(A, 0.02, 0.4)};
  }
};

inline SmallPacking small_packing(int first, int second, const dem::Box& room, dem::Domain around) {
  dem::Fiber one{dem::isotropic_material(2.6e6, 0.3, 1000), 2e-3, 8};
  one.bond_damping = 0.3;
  dem::Fiber two{dem::isotropic_material(4.1e6, 0.17, 1300), 1.37e-3, 13};
  two.bond_damping = 0.1;
  around.gravity = {0.2, -0.3, -9.81};
  around.contacts = {0.4, 0.6, 0.02};
  around.wall_youngs_modulus = 3e6;
  dem::InsertionRules rules{room};
  rules.velocity = {0.1, 0.05, -1.5};
  rules.seed = 5;
  return {
      dem::random_insertion({{dem::straight_chain<3>(one), first}, {curled(two, {0.02, 0.06, 0.09}), second}},
                            rules, around),
      around};
}

inline dem::Wall side(const V& point, const V& normal) { return {dem::Plane{point, normal}}; }

/// Closed, about as wide as the fibers are long.
inline SmallPacking packing_in_a_box(int first, int second) {
  const double a = 0.024;
  dem::Domain around;
  around.walls = {side({0, 0, 0}, {0, 0, 1}), side({0, 0, 0}, {1, 0, 0}), side({a, 0, 0}, {-1, 0, 0}),
                  side({0, 0, 0}, {0, 1, 0}), side({0, a, 0}, {0, -1, 0})};
  const double height = 4.5e-4 * (first + second);
  return small_packing(first, second, {{0, 0, 0}, {a, a, std::max(height, 0.02)}}, around);
}

/// Periodic along x and y, between a floor and a plate that comes down.
inline SmallPacking packing_in_a_periodic_box(int first, int second) {
  const dem::Vec<double, 3> period{0.0213, 0.0257, 0};
  const double height = std::max(4.5e-4 * (first + second), 0.02);
  dem::Domain around;
  around.period = period;
  around.walls = {side({0, 0, 0}, {0, 0, 1}), side({0, 0, height}, {0, 0, -1})};
  around.walls[1].velocity = {0, 0, -0.6};
  around.walls[1].active_until = 0.4 * height / 0.6;
  return small_packing(first, second, {{0, 0, 0}, {period[0], period[1], height}}, around);
}

/// All positions, velocities, spins and orientations.
inline std::vector<double> numbers(const dem::Assembly& assembly) {
  std::vector<double> all;
  for (int g = 0; g < assembly.groups(); ++g) {
    for (int f = 0; f < assembly.fibers(g); ++f) {
      const dem::ChainState<3> s = assembly.state(g, f);
      for (std::size_t i = 0; i < s.poses.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
          all.insert(all.end(),
                     {s.poses[i].position[c], s.velocity[i][c], s.spin[i][c], s.poses[i].orientation.v[c]});
        }
      }
    }
  }
  return all;
}

}  // namespace scenes
