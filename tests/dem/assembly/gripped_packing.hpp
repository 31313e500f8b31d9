#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/dem/small_packing.hpp"

/// Spheres that are held, driven and loaded.
namespace grips {

using namespace scenes;

inline void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

inline dem::Fiber fiber_with(int aspect_ratio, double bond_damping) {
  dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.17, 1130), 1.66e-3, aspect_ratio};
  fiber.bond_damping = bond_damping;
  return fiber;
}

inline constexpr std::array<bool, 3> all{true, true, true}, none{}, z_only{false, false, true};

inline dem::Grip grip(const std::array<bool, 3>& place, const std::array<bool, 3>& turn,
                      std::vector<dem::SphereAddress> spheres) {
  dem::Grip grip;
  grip.place = place, grip.turn = turn, grip.spheres = std::move(spheres);
  return grip;
}

inline V momentum(const dem::Assembly& assembly) {
  V sum{};
  for (int group = 0; group < assembly.groups(); ++group) {
    const dem::Fiber& fiber = assembly.chain(group).fiber;
    for (int f = 0; f < assembly.fibers(group); ++f) {
      const dem::ChainState<3> state = assembly.state(group, f);
      for (std::size_t i = 0; i < state.velocity.size(); ++i)
        sum =
            sum + (dem::mass_share(fiber, static_cast<int>(i)) * dem::sphere_mass(fiber)) * state.velocity[i];
    }
  }
  return sum;
}

inline double mass(const dem::Assembly& assembly) {
  double sum = 0;
  for (int group = 0; group < assembly.groups(); ++group)
    sum += assembly.fibers(group) * dem::fiber_mass(assembly.chain(group).fiber);
  return sum;
}

/// Fibers that fall into a box, some of them clamped, shaken, turned, guided along one axis and loaded.
inline dem::AssemblyOptions with_grips(dem::AssemblyOptions options) {
  dem::Grip clamped = grip(all, all, {{0, 1, 0}, {0, 1, 1}}),
            shaken = grip({true, false, true}, none, {{1, 2, 13}}),
            turning = grip(all, all, {{1, 0, 4}, {1, 0, 5}}),
            guided = grip(z_only, {false, true, false}, {{0, 3, 8}}), loaded;
  shaken.body.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 3e-4, 90, 0.3, 0.004};
  turning.body.motion.about = dem::WallAxis{{0.012, 0.011, 0.01}, {0, 0.6, 0.8}};
  turning.body.motion.angular_velocity = 25;
  guided.body.velocity = {0, 0, 0.05};
  guided.body.active_from = 0.0101, guided.body.active_until = 0.0203;
  guided.force = {2e-4, 0, 0};
  loaded.force = {1e-4, -3e-4, 2e-4}, loaded.moment = {1e-7, 0, 3e-7}, loaded.ramp = 0.005;
  loaded.spheres = {{0, 2, 0}, {1, 1, 6}};
  options.grips = {clamped, shaken, turning, guided, loaded};
  return options;
}

struct Scheme {
  dem::Integrator integrator;
  dem::BondForm form;
  double step;
};
inline constexpr Scheme kSchemes[] = {{dem::Integrator::leapfrog, dem::BondForm::total, 5e-6},
                                      {dem::Integrator::leapfrog_stiff, dem::BondForm::incremental, 2e-5}};

inline dem::Assembly gripped_packing(const Scheme& scheme, bool accounted = false, int threads = 1) {
  return packing_in_a_box(8, 6).assembly(with_grips({.step = scheme.step,
                                                     .integrator = scheme.integrator,
                                                     .form = scheme.form,
                                                     .threads = threads,
                                                     .account_energy = accounted}));
}

}  // namespace grips
