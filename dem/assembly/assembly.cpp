#include "dem/assembly/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/observables.hpp"
#include "dem/errors.hpp"
#include "dem/motion/half_step.hpp"

namespace fiberchain::dem {
namespace {

void check(const FiberGroup& group) {
  check(group.chain.fiber);
  if (group.fibers.empty()) throw InvalidInput("a group of fibers without a fiber is not allowed");
  for (const auto& fiber : group.fibers) {
    if (fiber.poses.size() != group.chain.poses.size() || fiber.velocity.size() != fiber.poses.size() ||
        fiber.spin.size() != fiber.poses.size()) {
      throw InvalidInput("a fiber needs a pose, a velocity and a spin for every sphere of its chain");
    }
  }
}

void check_fluid(const Surroundings& surroundings) {
  if (!surroundings.fluid) return;
  check<3>(*surroundings.fluid);
  if (surroundings.fluid->hydrodynamics != Hydrodynamics::free_draining) {
    throw InvalidInput(fmt::format("hydrodynamics = {} is not allowed: fibers among others are free draining",
                                   name(surroundings.fluid->hydrodynamics)));
  }
}

double stored(const EnergyBalance& e) { return e.kinetic + e.bonds + e.contacts + e.gravity; }

}  // namespace

Assembly::Assembly(std::vector<FiberGroup> groups, Surroundings surroundings, AssemblyOptions options) {
  if (groups.empty()) throw InvalidInput("fibers = none is not allowed: an assembly needs at least one");
  for (const FiberGroup& group : groups) check(group);
  check_fluid(surroundings);
  if (options.threads < 1) throw InvalidInput(fmt::format("threads = {} is not allowed: 1 or more", options.threads));
  const double step = options.step ? *options.step : assembly_time_step(groups, surroundings).step;
  if (!(step > 0) || !std::isfinite(step)) {
    throw InvalidInput(fmt::format("step = {} s is not allowed: it must be finite and greater than 0", step));
  }
  state_ = std::make_unique<State>(std::move(surroundings), std::move(options), step);
  State& s = *state_;
  s.add(groups);
  for (int k = 0; k < s.contacts.stripes(); ++k) s.contacts.work_out(k, s.rows, 0);
  for (int k = 0; k < s.contacts.stripes(); ++k) s.contacts.gather_loads(k, s.rows);
  s.start_blocks(0);
}

Assembly::~Assembly() = default;
Assembly::Assembly(Assembly&&) noexcept = default;

void Assembly::insert(FiberGroup group) {
  check(group);
  State& s = *state_;
  const StepChoice choice = assembly_time_step({group}, s.surroundings);
  const double largest = std::min({choice.bonds, choice.damped_bonds});
  if (s.step > largest) {
    throw InvalidInput(fmt::format("step = {:g} s is not allowed: at most {:g} s, which the fibers to be inserted bear", s.step,
                                   largest));
  }
  const double before = s.options.book_energy ? stored(s.energy()) : 0;
  s.start_blocks(s.add({group}));
  if (s.options.book_energy) s.inserted += stored(s.energy()) - before;
}

void Assembly::march(std::int64_t steps) { state_->march(steps); }
double Assembly::step() const { return state_->step; }
std::int64_t Assembly::steps() const { return state_->steps; }
double Assembly::time() const { return state_->time(); }
std::int64_t Assembly::spheres() const { return state_->rows.count; }
int Assembly::groups() const { return static_cast<int>(state_->kinds.size()); }
const Chain<3>& Assembly::chain(int group) const { return state_->kinds[group].chain; }
int Assembly::fibers(int group) const { return state_->fibers[group]; }

PlacedSpheres Assembly::placed() const {
  PlacedSpheres all;
  for (std::int64_t i = 0; i < state_->rows.count; ++i) {
    all.position.push_back(state_->rows.place(i));
    all.radius.push_back(state_->rows.position.data()[i * position_numbers + 3]);
  }
  return all;
}

std::int64_t Assembly::first_sphere(int group, int fiber) const { return state_->first_sphere(group, fiber); }

ChainState<3> Assembly::state(int group, int fiber) const {
  const State& s = *state_;
  const State::Place at = s.place(group, fiber);
  const FiberKind& kind = s.kinds[group];
  const BlockLook now = s.look(at.block);
  ChainState<3> state;
  for (int i = 0; i < kind.spheres(); ++i) {
    MovingSphere<double, 3> sphere = s.blocks[at.block].sphere(kind, now, at.lane, i);
    move_half_step(sphere, EndLoad<double, 3>{}, kind.chain.fiber, kind.drag, s.gradient_now(), s.step, false);
    if (!s.rows.oriented()) {
      const double unknown = std::nan("");
      sphere.pose.orientation = {unknown, {unknown, unknown, unknown}};
    }
    state.poses.push_back(sphere.pose);
    state.velocity.push_back(sphere.velocity);
    state.spin.push_back(sphere.spin);
  }
  return state;
}

std::vector<BondState> Assembly::bonds(int group, int fiber) const {
  const State& s = *state_;
  const State::Place at = s.place(group, fiber);
  const FiberBlock& block = s.blocks[at.block];
  const FiberKind& kind = s.kinds[group];
  const BlockLook now = s.look(at.block);
  const BondParameters<double>& law = kind.parameters.bond;
  std::vector<BondState> bonds;
  const ChainState<3> state = this->state(group, fiber);
  for (int i = 0; i + 1 < kind.spheres(); ++i) {
    const RelativeMotion<double, 3> motion{state.velocity[i + 1] - state.velocity[i],
                                           0.5 * (state.spin[i] + state.spin[i + 1]), state.spin[i + 1] - state.spin[i]};
    const auto line = bond_vector<double, 3>(state.poses[i + 1].position - state.poses[i].position,
                                             kind.parameters.inverse_length);
    const Vec<double, 3> e = line.inverse_length * line.vector;
    if (s.options.form == BondForm::total) {
      const auto k = bond_kinematics(kind.chain, state.poses, i);
      const Vec<double, 3> spring = bond_loads(k, bond_stress(law, k.separation, k.rotation)).force_on_first;
      bonds.push_back({spring + dashpot_action(law, line.vector, e, motion).force, bending_angle(kind.chain, state.poses, i)});
      continue;
    }
    const BondHistory<double, 3> history = block.history(kind, now, at.lane, i);
    bonds.push_back({incremental_action<true>(law, history, line, motion).force,
                     norm(history.rotation - dot(history.rotation, e) * e)});
  }
  return bonds;
}

std::int64_t Assembly::touching() const { return state_->contacts.touching(); }
std::vector<ContactState> Assembly::contacts() const { return state_->contacts.states(state_->rows, state_->time()); }
StepTimes Assembly::times() const { return state_->watch.times; }
EnergyBalance Assembly::energy() const { return state_->energy(); }

double total(const EnergyBalance& e) {
  return stored(e) + e.bond_damping + e.bond_friction + e.contact_normal + e.contact_tangential + e.contact_rolling +
         e.fluid - e.wall_work - e.inserted;
}

}  // namespace fiberchain::dem
