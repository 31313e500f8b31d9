#include "dem/assembly/assembly.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/packing_law.hpp"
#include "dem/contact/smooth_contacts.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"

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

void check_fluid(const Domain& domain) {
  if (!domain.fluid) return;
  check<3>(*domain.fluid);
  if (domain.fluid->hydrodynamics != Hydrodynamics::free_draining) {
    throw InvalidInput(fmt::format("hydrodynamics = {} is not allowed: fibers among others are free draining",
                                   name(domain.fluid->hydrodynamics)));
  }
}

/// The walls where they stand at a time; nothing for those that are not there.
std::vector<std::optional<WallShape>> standing(const std::vector<Wall>& walls, double time) {
  std::vector<std::optional<WallShape>> all;
  for (const Wall& wall : walls) {
    all.emplace_back();
    if (is_active(wall, time)) all.back() = wall.shape.moved(pose_at(wall, time));
  }
  return all;
}

void check_places(const std::vector<FiberGroup>& groups, const std::vector<Wall>& walls, double time) {
  const std::vector<std::optional<WallShape>> there = standing(walls, time);
  for (const FiberGroup& group : groups) {
    for (std::size_t f = 0; f < group.fibers.size(); ++f) {
      for (std::size_t i = 0; i < group.fibers[f].poses.size(); ++i) {
        for (std::size_t w = 0; w < walls.size(); ++w) {
          if (!there[w]) continue;
          const Vec<double, 3>& place = group.fibers[f].poses[i].position;
          if (i > 0 && passes_through(walls[w], group.fibers[f].poses[i - 1].position, place, time)) {
            throw InvalidInput(
                fmt::format("fiber {} is not allowed there: it goes through wall {} before its "
                            "sphere {}",
                            f, w, i));
          }
          if (there[w]->nearest(place).distance > 0) continue;
          throw InvalidInput(fmt::format(
              "sphere {} of fiber {} is not allowed there: its center is behind wall {}", i, f, w));
        }
      }
    }
  }
}

/// Spheres have no images: what they meet must be the same at all of them.
void check_periodic_invariance(const Domain& domain) {
  for (const Wall& wall : domain.walls) {
    for (int c = 0; c < 3; ++c) {
      if (domain.period[c] > 0 && !is_invariant_along(wall, c))
        throw InvalidKey("walls", "a wall across or askew to a periodic side is not allowed");
    }
  }
  if (!domain.fluid) return;
  for (const Gradient& A : {domain.fluid->flow.gradient, gradient_at(domain.fluid->flow, 0)}) {
    for (int c = 0; c < 3; ++c) {
      if (domain.period[c] > 0 && (A[0][c] != 0 || A[1][c] != 0 || A[2][c] != 0)) {
        throw InvalidKey("fluid", "a flow that varies along a periodic side is not allowed");
      }
    }
  }
}

/// What is built with springs solved for.
void check_stiff(const std::vector<FiberGroup>& groups, const AssemblyOptions& options) {
  if (options.integrator == Integrator::leapfrog) return;
  if (options.integrator != Integrator::leapfrog_stiff) {
    throw InvalidKey("integrator",
                     fmt::format("integrator = {} is not allowed: fibers among others have leapfrog "
                                 "and leapfrog-stiff",
                                 name(options.integrator)));
  }
  if (options.law != nullptr)
    throw InvalidInput("integrator = leapfrog-stiff is not allowed: it is built for the library's bond laws");
  for (const FiberGroup& group : groups) {
    if (group.chain.fiber.rolling_friction > 0 && options.rolling != Rolling::none) {
      throw InvalidKey(
          "integrator",
          "integrator = leapfrog-stiff is not allowed: rolling friction of the bonds is built for "
          "the leapfrog that leaves them explicit");
    }
  }
}

/// What is built with smooth fibers.
void check_smooth(const std::vector<FiberGroup>& groups, const Domain& domain,
                  const AssemblyOptions& options) {
  for (const FiberGroup& group : groups) {
    if (!group.chain.smooth) continue;
    smooth_law(law_of(domain.contacts));
    if (packing_law(options).intact_place >= 0)
      throw InvalidKey("fibers",
                       "smooth surfaces are not built together with bonds of a law that breaks them");
    const Fiber& fiber = group.chain.fiber;
    if (fiber.strength && fiber.spacing < 1)
      throw InvalidKey("fibers",
                       "smooth fibers that break need spacing: 1 or more, or their pieces would overlap");
  }
}

/// Contacts by the numbers of their spheres in place of rows, the lower one first.
std::vector<ContactState> by_numbers(const Assembly::State& s, std::vector<ContactState> all) {
  for (ContactState& contact : all) {
    contact.key.first.number = s.number_of(contact.key.first.number);
    if (!is_of_fiber(contact.key.second)) continue;
    contact.key.second.number = s.number_of(contact.key.second.number);
    if (contact.key.first.number < contact.key.second.number) continue;
    std::swap(contact.key.first, contact.key.second);
    contact.normal = -contact.normal;
    contact.force = -contact.force;
  }
  std::ranges::stable_sort(all, {}, &ContactState::key);
  return all;
}

/// What is built with grips.
void check_held(const std::vector<FiberGroup>& groups, const Domain& domain, const AssemblyOptions& options) {
  if (options.grips.empty()) return;
  if (domain.fluid) throw InvalidKey("held", "held spheres are not built together with a fluid");
  for (const Grip& grip : options.grips) {
    for (const SphereAddress& at : grip.spheres) {
      if (at.group < 0 || at.group >= std::ssize(groups)) continue;  // HeldSpheres tells
      if (groups[at.group].chain.fiber.rolling_friction > 0 && options.rolling == Rolling::set_valued)
        throw InvalidKey("held",
                         "held spheres are not built together with rolling friction of the bonds that is "
                         "solved within the step; motion.rolling: explicit_sign is");
    }
  }
}

double stored(const EnergyBalance& energy) { return sum_of(energy, EnergyRole::stored); }

}  // namespace

Assembly::Assembly(std::vector<FiberGroup> groups, Domain domain, AssemblyOptions options) {
  if (groups.empty()) throw InvalidInput("fibers = none is not allowed: an assembly needs at least one");
  for (const FiberGroup& group : groups) check(group);
  check_stiff(groups, options);
  check_smooth(groups, domain, options);
  check_fluid(domain);
  check_periodic_invariance(domain);
  check_held(groups, domain, options);
  if (options.threads < 1)
    throw InvalidInput(fmt::format("threads = {} is not allowed: 1 or more", options.threads));
  if (options.account_energy && packing_law(options).intact_place >= 0) {
    throw InvalidInput("account_energy is not allowed: what a breaking bond takes is not accounted");
  }
  const StepChoice choice =
      options.step ? stable_time_step(groups, domain, options) : assembly_time_step(groups, domain, options);
  const double step = options.step ? *options.step : choice.step;
  if (!(step > 0) || !std::isfinite(step)) {
    throw InvalidInput(fmt::format("step = {} s is not allowed: it must be finite and greater than 0", step));
  }
  if (step > largest_bond_step(choice)) {
    throw InvalidInput(fmt::format(
        "step = {:g} s is not allowed: it must be at most {:g} s, beyond which bonds are unstable", step,
        largest_bond_step(choice)));
  }
  state_ = std::make_unique<State>(std::move(domain), std::move(options), step);
  State& s = *state_;
  if (!s.options.placed_anywhere) check_places(groups, s.contacts.walls(), s.time());
  s.held = HeldSpheres(s.options.grips, groups, step);
  s.add(groups);
  if (s.held.any()) s.held.grasp(s);
  s.touch();
  s.contacts.begin_accounts();
  if (s.held.any()) s.held.before_start(s);
  s.start_blocks(0);
  if (s.held.any()) s.held.start(s);
  s.held.begin_accounts(s);
}

Assembly::~Assembly() = default;
Assembly::Assembly(Assembly&&) noexcept = default;
Assembly& Assembly::operator=(Assembly&&) noexcept = default;

void Assembly::insert(FiberGroup group) {
  check(group);
  State& s = *state_;
  check_stiff({group}, s.options);
  check_smooth({group}, s.domain, s.options);
  check_places({group}, s.contacts.walls(), s.time());
  const double largest = largest_bond_step(stable_time_step({group}, s.domain, s.options));
  if (s.step > largest) {
    throw InvalidInput(
        fmt::format("step = {:g} s is not allowed: at most {:g} s, which the fibers to be inserted bear",
                    s.step, largest));
  }
  const double before = s.options.account_energy ? stored(s.sample().energy) : 0;
  s.start_blocks(s.add({group}));
  if (s.options.account_energy) s.inserted += stored(s.sample().energy) - before;
}

void Assembly::march(std::int64_t steps, ContactForces at_end) { state_->march(steps, at_end); }
double Assembly::step() const { return state_->step; }
Integrator Assembly::integrator() const { return state_->options.integrator; }
std::int64_t Assembly::steps() const { return state_->steps; }
double Assembly::time() const { return state_->time(); }
std::int64_t Assembly::spheres() const { return state_->rows.count; }
int Assembly::groups() const { return static_cast<int>(state_->kinds.size()); }
const Chain<3>& Assembly::chain(int group) const { return state_->kinds[group].chain; }
int Assembly::fibers(int group) const { return state_->fibers[group]; }

PlacedSpheres Assembly::placed() const {
  PlacedSpheres all;
  all.position.reserve(static_cast<std::size_t>(state_->rows.count));
  all.radius.reserve(static_cast<std::size_t>(state_->rows.count));
  for (std::int64_t number = 0; number < state_->rows.count; ++number) {
    const std::int64_t row = state_->row_of(number);
    all.position.push_back(state_->rows.position(row));
    all.radius.push_back(state_->rows.radius(row));
  }
  return all;
}

void Assembly::coordinates(const Vec<double, 3>& direction, std::vector<double>& all) const {
  all.resize(static_cast<std::size_t>(state_->rows.count));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = dot(state_->rows.position(static_cast<std::int64_t>(i)), direction);
}

std::int64_t Assembly::first_sphere(int group, int fiber) const { return state_->first_sphere(group, fiber); }

bool Assembly::is_broken(int group, int fiber, int bond) const {
  const State::Slot at = state_->slot(group, fiber);
  return state_->blocks[at.block].is_broken(state_->kinds[group], at.lane, bond);
}

void Assembly::break_bond(int group, int fiber, int bond) {
  const State::Slot at = state_->slot(group, fiber);
  state_->blocks[at.block].break_bond(state_->kinds[group], at.lane, bond);
}

double Assembly::deepest_overlap() const { return state_->contacts.deepest(); }
double Assembly::largest_turn() const { return state_->largest_turn; }
double Assembly::longest_path() const { return state_->longest_path / state_->smallest_radius(); }
std::int64_t Assembly::touching() const { return state_->contacts.touching(); }
std::vector<ContactState> Assembly::contacts() const {
  return by_numbers(*state_, state_->contacts.states(state_->rows, state_->time()));
}
std::vector<ContactState> Assembly::contact_forces() const {
  return state_->last_forces ? by_numbers(*state_, *state_->last_forces) : contacts();
}
std::vector<WallSample> Assembly::wall_samples() const {
  return state_->contacts.wall_samples(state_->time());
}
void Assembly::begin_wall_interval() { state_->contacts.begin_wall_interval(state_->time()); }
std::vector<WallSample> Assembly::held_samples() const { return state_->held.samples(*state_); }
void Assembly::begin_held_interval() { state_->held.begin_interval(*state_); }
const std::vector<Grip>& Assembly::grips() const { return state_->options.grips; }
const std::vector<Wall>& Assembly::walls() const { return state_->contacts.walls(); }
std::int64_t Assembly::sort_count() const { return state_->sort_count; }
StepTimes Assembly::times() const { return state_->watch.times; }
IdleTimes Assembly::idle_times() const { return state_->pool.idle_times(); }
std::vector<PartTimes> Assembly::part_times() const {
  std::vector<PartTimes> all = state_->part_times;
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k].reached = state_->contacts.reach().reached(static_cast<int>(k));
  return all;
}
AssemblySample Assembly::sample() const { return state_->sample(); }
EnergyBalance Assembly::energy() const { return state_->sample().energy; }

}  // namespace fiberchain::dem
