#include "compare/breaking/fragments.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/breaking/released_rod.hpp"

namespace fiberchain::compare {
namespace {

/// Longest piece of a rod, of its length.
double longest_piece(const dem::Assembly& assembly, int rod, int bonds) {
  int longest = 0, from = 0;
  for (int i = 0; i <= bonds; ++i) {
    if (i < bonds && !assembly.is_broken(0, rod, i)) continue;
    longest = std::max(longest, i - from);
    from = i + 1;
  }
  return static_cast<double>(longest) / bonds;
}

/// Each in a plane of its own.
dem::FiberGroup rods_of(const FragmentCase& asked) {
  ReleasedRod rod = released_rod(asked.aspect_ratio);
  dem::Fiber& fiber = rod.fiber;
  fiber.mass = dem::MassModel::cylinder;
  fiber.dashpots = dem::DashpotLaw::retardation_time;
  fiber.retardation_time = time_of_way(fiber, asked.damping_way * asked.aspect_ratio);
  fiber.strength =
      dem::BondStrength{.tension = asked.strength * stress_at_rest(rod),
                        .weibull = dem::WeibullSpread{asked.modulus, dem::fiber_length(fiber), asked.seed}};
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::FiberGroup group{chain, {}};
  const dem::ChainState<3> one = arc(chain, rod.curvature * dem::bond_length(fiber));
  for (int n = 0; n < asked.rods; ++n) {
    dem::ChainState<3> state = one;
    for (auto& pose : state.poses) pose.position[2] += 3.0 * n * fiber.diameter;
    group.fibers.push_back(std::move(state));
  }
  return group;
}

}  // namespace

Fragments break_rods(const FragmentCase& asked) {
  dem::FiberGroup group = rods_of(asked);
  const dem::Fiber fiber = group.chain.fiber;
  const double end = time_of_way(fiber, 3.0 * asked.aspect_ratio),
               step = 0.1 * asked.aspect_ratio * dem::bond_time_step(fiber);
  dem::Assembly assembly(
      {std::move(group)}, {},
      {.step = step, .integrator = dem::Integrator::leapfrog_stiff, .form = dem::BondForm::total});
  assembly.march(std::llround(end / step));
  std::vector<int> pieces(static_cast<std::size_t>(asked.rods), 1);
  for (const dem::BondBreak& one : assembly.take_breaks()) ++pieces[static_cast<std::size_t>(one.fiber)];
  Fragments all;
  double squares = 0;
  for (int n = 0; n < asked.rods; ++n) {
    const double own = pieces[static_cast<std::size_t>(n)];
    all.mean += own / asked.rods;
    squares += own * own / asked.rods;
    all.unbroken += own == 1 ? 1.0 / asked.rods : 0;
    all.longest += longest_piece(assembly, n, asked.aspect_ratio) / asked.rods;
  }
  all.deviation = std::sqrt((squares - all.mean * all.mean) / asked.rods);
  return all;
}

}  // namespace fiberchain::compare
