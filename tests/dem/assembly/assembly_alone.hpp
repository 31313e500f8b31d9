#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/analysis/observables.hpp"
#include "dem/bond/incremental.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/assembly/assembly_scenes.hpp"
#include "tests/dem/marching_chains.hpp"

/// Fibers of an assembly that touch nothing against each alone in a ChainBatch.
namespace scenes {

/// One row of the table: what the fibers are made of and what is around them.
struct Case {
  const char* name;
  dem::BondForm form;
  bool curved;
  double damping;   ///< xi_b
  double friction;  ///< xi_r
  dem::Rolling rolling = dem::Rolling::set_valued;
  enum { vacuum, steady, unsteady } fluid = vacuum;
  bool gravity = false;
  dem::BondModel model = dem::BondModel::paper;
  dem::DashpotLaw dashpots = dem::DashpotLaw::bond_damping;
  bool stiff = false;  ///< bonds solved for within the step
};

inline dem::Chain<3> chain_of(const Case& c, int bonds, double size) {
  dem::Fiber fiber = odd_fiber(bonds, size);
  fiber.rolling_friction = c.friction;
  fiber.bond_model = c.model;
  fiber.dashpots = c.dashpots;
  if (c.dashpots == dem::DashpotLaw::retardation_time) {
    fiber.retardation_time = c.damping * dem::bond_time_step(fiber);
  } else {
    fiber.bond_damping = c.damping;
  }
  return c.curved ? curled(fiber, {0.05, 0.11, -0.17}) : dem::straight_chain<3>(fiber);
}

inline dem::Domain around(const Case& c, const dem::Fiber& fiber) {
  dem::Domain s;
  s.contacts = {0.5, 0.3, 0.05};
  // so strong that it tells within the few steps
  if (c.gravity)
    s.gravity = 0.002 * fiber.diameter / std::pow(dem::bond_time_step(fiber), 2) * V{0.3, -0.5, 0.8};
  if (c.fluid != Case::vacuum) s.fluid = marching::odd_fluid<3>(fiber);
  if (c.fluid == Case::steady) s.fluid->flow = {dem::gradient_at(s.fluid->flow, 0)};
  return s;
}

/// The same fiber by itself.
struct Alone {
  dem::ChainState<3> state;
  std::vector<dem::BondHistory<double, 3>> history;
};

inline Alone alone(const Case& c, const dem::Chain<3>& chain, const dem::Domain& s,
                   const dem::ChainState<3>& start, double dt, int steps) {
  dem::Physics physics{3, c.form, dem::damped(chain.fiber), false,
                       c.form == dem::BondForm::total && !chain.natural.empty()};
  physics.fluid = s.fluid.has_value();
  if (c.stiff) physics.solved = dem::Solved::bonds, physics.damped = true;
  if (chain.fiber.rolling_friction > 0) physics.rolling = c.rolling, physics.damped = true;
  dem::ChainBatch<3> block({chain}, {false, false}, {dt}, {0}, physics, dem::InstructionSet::scalar);
  const double m = dem::sphere_mass(chain.fiber);
  if (s.fluid) {
    block.set_fluid(0, *s.fluid);
    dem::Boundary<3> weight;
    for (int i = 0; i <= chain.fiber.aspect_ratio; ++i) weight.loads.push_back({i, m * s.gravity, {}});
    if (c.gravity) block.set_loads(0, weight);
  }
  dem::put_state(block, 0, chain, start);
  block.synchronize();
  // the first kick takes the dashpots at the velocities half a step before, as every other
  dem::ChainBatch<3> lagged({chain}, {false, false}, {dt}, {0}, physics, dem::InstructionSet::scalar);
  dem::ChainState<3> before = start;
  for (std::size_t i = 0; i < start.poses.size(); ++i) {
    before.velocity[i] = block.sphere(0, static_cast<int>(i)).velocity;
    before.spin[i] = block.sphere(0, static_cast<int>(i)).spin;
  }
  dem::put_state(lagged, 0, chain, before);
  lagged.synchronize();
  for (int i = 0; i <= chain.fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(0, i);
    sphere.force = lagged.sphere(0, i).force, sphere.moment = lagged.sphere(0, i).moment;
    block.set_sphere(0, i, sphere);
  }
  block.march(steps);
  const int spheres = chain.fiber.aspect_ratio + 1;
  Alone result{dem::state_now(block, 0, spheres), {}};
  for (int i = 0; i + 1 < spheres; ++i) result.history.push_back(block.history(0, i));
  if (!s.fluid) {  // a free fall adds up with what the bonds do
    const double t = steps * dt;
    for (int i = 0; i < spheres; ++i) {
      result.state.poses[i].position = result.state.poses[i].position + (0.5 * t * t) * s.gravity;
      result.state.velocity[i] = result.state.velocity[i] + t * s.gravity;
    }
  }
  return result;
}

inline double apart(const dem::Quaternion<double>& a, const dem::Quaternion<double>& b) {
  return std::min(std::abs(a.w - b.w) + norm(a.v - b.v), std::abs(a.w + b.w) + norm(a.v + b.v));
}

/// Largest differences of two states: positions over the diameter, velocities over diameter and time, turns.
struct Off {
  double position = 0, velocity = 0, spin = 0, turn = 0, angle = 0;
};

inline void compare(const dem::ChainState<3>& a, const dem::ChainState<3>& b, double length, double rate,
                    Off& off) {
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    off.position = std::max(off.position, norm(a.poses[i].position - b.poses[i].position) / length);
    off.velocity = std::max(off.velocity, norm(a.velocity[i] - b.velocity[i]) / (length * rate));
    off.spin = std::max(off.spin, norm(a.spin[i] - b.spin[i]) / rate);
    off.turn = std::max(off.turn, apart(a.poses[i].orientation, b.poses[i].orientation));
  }
}

constexpr int kSteps = 150;

inline Off off_of(const Case& c, dem::InstructionSet set, int threads) {
  const double speed = c.stiff                           ? (c.fluid != Case::vacuum ? 0.019 : 0.012)
                       : c.fluid != Case::vacuum         ? 0.15
                       : c.damping > 0 || c.friction > 0 ? 0.07
                                                         : 0.02;
  std::vector<dem::FiberGroup> groups{scattered(chain_of(c, 7, 1), 11, speed, 3),
                                      scattered(chain_of(c, 4, 1.3), 5, speed, 4),
                                      scattered(chain_of(c, 17, 0.9), 1, speed, 5)};
  for (int g : {1, 2}) {
    for (auto& fiber : groups[g].fibers) move(fiber, {0, 0, 2.0 * g});  // beside the first ones
  }
  const dem::Fiber& fiber = groups[0].chain.fiber;
  const dem::Domain s = around(c, fiber);
  double dt = 1;
  for (const auto& group : groups) {
    const dem::Fiber& own = group.chain.fiber;
    dt = std::min(dt, c.stiff ? 1.2 * dem::undamped_time_step(own) : 0.4 * dem::stable_time_step(own));
  }
  dem::Assembly assembly(groups, s,
                         {.step = dt,
                          .integrator = c.stiff ? dem::Integrator::leapfrog_stiff : dem::Integrator::leapfrog,
                          .form = c.form,
                          .rolling = c.rolling,
                          .threads = threads,
                          .allow_passage = true,
                          .instruction_set = set});
  assembly.march(kSteps);
  BOOST_TEST(assembly.touching() == 0);
  Off off;
  double most_bent = 0, farthest = 0;
  for (int g = 0; g < 3; ++g) {
    const dem::Chain<3>& chain = groups[g].chain;
    for (int f = 0; f < assembly.fibers(g); ++f) {
      const Alone one = alone(c, chain, s, groups[g].fibers[f], dt, kSteps);
      const dem::ChainState<3> now = assembly.state(g, f);
      compare(now, one.state, fiber.diameter, 1 / (dt * kSteps), off);
      farthest = std::max(farthest, norm(now.poses[2].position - groups[g].fibers[f].poses[2].position));
      const auto bonds = assembly.bonds(g, f);
      for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
        const V e = dem::unit(one.state.poses[i + 1].position - one.state.poses[i].position);
        const V summed = one.history[i].rotation - dot(one.history[i].rotation, e) * e;
        const double bent =
            c.form == dem::BondForm::total ? dem::bending_angle(chain, one.state.poses, i) : norm(summed);
        off.angle = std::max(off.angle, std::abs(bonds[i].bending_angle - bent));
        most_bent = std::max(most_bent, bent);
      }
    }
  }
  BOOST_TEST(most_bent > (c.stiff ? 0.008 : 0.02), c.name << ": too little happens, bent by " << most_bent);
  BOOST_TEST(farthest > 0.2 * fiber.diameter);
  return off;
}

}  // namespace scenes
