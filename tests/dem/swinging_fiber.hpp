#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/vibration/release.hpp"

/// Checks of one fiber in motion, whatever its masses and the length of its bonds.
namespace swinging {

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using Scheme = std::pair<dem::Integrator, dem::BondForm>;

/// Each of these keeps the release's energy within a share of it, and the last place of the tip is the last
/// scheme's within a share of the fiber's length.
inline void check_schemes(const dem::Release<3>& release, const std::vector<Scheme>& schemes, double energy,
                          double tip) {
  std::vector<V> tips;
  for (const auto& [integrator, form] : schemes) {
    dem::ReleaseOptions options;
    options.integrator = integrator, options.form = form, options.energy = true;
    if (integrator == dem::Integrator::cvode) options.tolerance = 1e-9;
    if (integrator != dem::Integrator::cvode) options.step_ratio = 0.1;
    const auto record = dem::ring_down<3>({release}, options)[0];
    BOOST_TEST(record.failure == "");
    double worst = 0;
    for (const auto& sample : record.samples)
      worst = std::max(worst, std::abs(sample.energy / record.samples.front().energy - 1));
    BOOST_TEST(worst < energy, dem::name(integrator) << ": energy off by " << worst);
    tips.push_back(record.samples.back().position);
  }
  for (const V& one : tips)
    BOOST_TEST(norm(one - tips.back()) < tip * dem::fiber_length(release.chain.fiber));
}

/// So many fibers far from each other, thrown, fall for 8000 steps: momentum grows by the weight, to a share
/// of it, and their energy stays within 1e-3 of the kinetic one.
inline void check_fall(const dem::Chain<3>& chain, int fibers, dem::AssemblyOptions options,
                       double momentum) {
  const dem::Fiber& fiber = chain.fiber;
  dem::FiberGroup group{chain, {}};
  for (int f = 0; f < fibers; ++f) {
    dem::ChainState<3> state =
        dem::placed(chain, dem::FiberStart{{static_cast<double>(f), 0, 0}, {0.3, 1, -0.2}});
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
      const double x = static_cast<double>(i) / fiber.aspect_ratio;
      state.velocity[i] = {0.2 * x * x, -0.1 * x, 0.3 * std::sin(5 * x)};
      state.spin[i] = {1, -2 * x, 3};
    }
    group.fibers.push_back(std::move(state));
  }
  dem::Domain around;
  around.gravity = {0.4, -1.1, -9.81};
  dem::Assembly assembly({group}, around, std::move(options));
  const auto momentum_of_first = [&] {
    V sum{};
    const dem::ChainState<3> now = assembly.state(0, 0);
    for (std::size_t i = 0; i < now.velocity.size(); ++i)
      sum = sum + dem::mass_share(fiber, static_cast<int>(i)) * dem::sphere_mass(fiber) * now.velocity[i];
    return sum;
  };
  const auto mechanical = [](const auto& energy) { return energy.kinetic + energy.bonds + energy.gravity; };
  const V before = momentum_of_first();
  const auto start = assembly.energy();
  assembly.march(8000);
  const V expected = before + (assembly.time() * dem::fiber_mass(fiber)) * around.gravity;
  BOOST_TEST(norm(momentum_of_first() - expected) < momentum * norm(expected));
  BOOST_TEST(std::abs(mechanical(assembly.energy()) - mechanical(start)) < 1e-3 * start.kinetic);
}

}  // namespace swinging
