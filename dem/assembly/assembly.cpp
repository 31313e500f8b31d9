#include "dem/assembly/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "dem/assembly/contact_set.hpp"
#include "dem/errors.hpp"
#include "dem/motion/lanes/block.hpp"
#include "dem/motion/lanes/chain_lane.hpp"

namespace fiberchain::dem {
namespace {

using Sphere = MovingSphere<double, 3>;

constexpr int velocity_number = 7, spin_at = 10, force_at = 13, moment_at = 16;

Physics physics_of(const FiberGroup& group, const Surroundings& surroundings, const AssemblyOptions& options) {
  const Fiber& fiber = group.chain.fiber;
  Physics physics{.dimension = 3, .form = options.form, .damped = damped(fiber), .drag = false,
                  .curved = options.form == BondForm::total && !group.chain.natural.empty()};
  physics.fluid = surroundings.fluid.has_value();
  if (fiber.rolling_friction > 0) physics.rolling = options.rolling, physics.damped = true;
  return physics;
}

/// A block of fibers side by side, with the number of the first sphere of each.
struct FiberBlock {
  MarchingBlock<3> block;
  std::vector<std::int64_t> first_sphere;
  int group;
  int spheres;
  double mass;

  int lanes() const { return block.lanes(); }
};

}  // namespace

struct Assembly::State {
  std::vector<FiberGroup> groups;
  Surroundings surroundings;
  AssemblyOptions options;
  double step;
  std::int64_t steps = 0;
  std::vector<FiberBlock> blocks;
  std::vector<std::int64_t> first_sphere_of_group;
  std::vector<std::pair<int, int>> place_of_fiber;  ///< block and lane, through all groups
  ContactSet contacts;

  State(std::vector<FiberGroup> given, Surroundings around, AssemblyOptions how, double dt)
      : groups(std::move(given)), surroundings(std::move(around)), options(std::move(how)), step(dt),
        contacts(groups, surroundings, options, step) {}

  double time() const { return static_cast<double>(steps) * step; }

  void make_blocks() {
    std::int64_t sphere = 0;
    for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
      first_sphere_of_group.push_back(sphere);
      const FiberGroup& group = groups[g];
      const Physics physics = physics_of(group, surroundings, options);
      const int width = lane_kernel(physics, options.instruction_set).width;
      const int n = group.chain.fiber.aspect_ratio + 1;
      for (std::size_t f = 0; f < group.fibers.size(); f += width) {
        const int lanes = static_cast<int>(std::min<std::size_t>(width, group.fibers.size() - f));
        FiberBlock own{MarchingBlock<3>(std::vector<Chain<3>>(lanes, group.chain), {false, false},
                                        std::vector<double>(lanes, step), std::vector<double>(lanes, 0.0), physics,
                                        options.instruction_set),
                       {}, g, n, sphere_mass(group.chain.fiber)};
        for (int lane = 0; lane < lanes; ++lane, sphere += n) {
          own.first_sphere.push_back(sphere);
          place_of_fiber.push_back({static_cast<int>(blocks.size()), lane});
          if (surroundings.fluid) own.block.set_fluid(lane, *surroundings.fluid);
          put_state(own.block, lane, group.chain, group.fibers[f + lane]);
        }
        own.block.synchronize();
        blocks.push_back(std::move(own));
      }
    }
  }

  std::vector<Vec<double, 3>> positions() const {
    std::vector<Vec<double, 3>> all(contacts.spheres());
    for (const FiberBlock& own : blocks) {
      const double* numbers = own.block.sphere_numbers();
      const std::size_t stride = own.block.number_stride();
      for (int lane = 0; lane < own.lanes(); ++lane) {
        for (int i = 0; i < own.spheres; ++i) {
          const double* at = numbers + own.block.sphere_place(lane, i);
          all[own.first_sphere[lane] + i] = {at[0], at[stride], at[2 * stride]};
        }
      }
    }
    return all;
  }

  /// Positions and motions go to the contacts; true if a sphere moved far, or is nowhere.
  bool hand_over(FiberBlock& own) {
    const std::size_t stride = own.block.number_stride();
    const Vec<double, 3>* listed = contacts.listed_at().data();
    double farthest = 0;
    for (int i = 0; i < own.spheres; ++i) {
      for (int lane = 0; lane < own.lanes(); ++lane) {
        const std::int64_t sphere = own.first_sphere[lane] + i;
        const double* at = own.block.sphere_numbers() + own.block.sphere_place(lane, i);
        double* position = contacts.positions() + sphere * position_numbers;
        double* motion = contacts.motions() + sphere * motion_numbers;
        double squared = 0;
        for (int c = 0; c < 3; ++c) {
          position[c] = at[c * stride];
          const double moved = position[c] - listed[sphere][c];
          squared += moved * moved;
        }
        for (int c = 0; c < 6; ++c) motion[c] = at[(velocity_number + c) * stride];
        if (!(squared <= farthest)) farthest = squared;
      }
    }
    const double limit = 0.5 * contacts.skin();
    return !(farthest <= limit * limit);
  }

  /// Contact loads and gravity come onto the spheres.
  void take_loads(FiberBlock& own) {
    const std::size_t stride = own.block.number_stride();
    const Vec<double, 3> weight = own.mass * surroundings.gravity;
    for (int i = 0; i < own.spheres; ++i) {
      for (int lane = 0; lane < own.lanes(); ++lane) {
        double* at = own.block.sphere_numbers() + own.block.sphere_place(lane, i);
        const double* load = contacts.loads() + (own.first_sphere[lane] + i) * force_numbers;
        for (int c = 0; c < 3; ++c) at[(force_at + c) * stride] += load[c] + weight[c];
        for (int c = 0; c < 3; ++c) at[(moment_at + c) * stride] += load[3 + c];
      }
    }
  }

  void list_pairs() {
    contacts.list_pairs(positions(), time());
    for (FiberBlock& own : blocks) hand_over(own);
  }

  void start() {
    make_blocks();
    list_pairs();
    for (int k = 0; k < contacts.stripes(); ++k) contacts.work_out(k, 0);
    for (int k = 0; k < contacts.stripes(); ++k) contacts.gather_loads(k);
    for (FiberBlock& own : blocks) {
      take_loads(own);
      step_back(own);
    }
  }

  /// The half step back that synchronize() made was under the bonds' loads alone.
  void step_back(FiberBlock& own) {
    const std::size_t stride = own.block.number_stride();
    for (int lane = 0; lane < own.lanes(); ++lane) {
      const auto& p = own.block.parameters(lane);
      for (int i = 0; i < own.spheres; ++i) {
        double* at = own.block.sphere_numbers() + own.block.sphere_place(lane, i);
        const double* load = contacts.loads() + (own.first_sphere[lane] + i) * force_numbers;
        for (int c = 0; c < 3; ++c) {
          at[(velocity_number + c) * stride] -= 0.5 * p.impulse * (load[c] + own.mass * surroundings.gravity[c]);
          at[(spin_at + c) * stride] -= 0.5 * p.angular_impulse * load[3 + c];
        }
      }
    }
  }

  /// First sphere that has blown up, or -1.
  std::int64_t broken() const {
    for (const FiberBlock& own : blocks) {
      for (int lane = 0; lane < own.lanes(); ++lane) {
        const int sphere = broken_sphere(own.block, lane, groups[own.group].chain.fiber);
        if (sphere >= 0) return own.first_sphere[lane] + sphere;
      }
    }
    return -1;
  }

  [[noreturn]] void fail(std::int64_t sphere, std::int64_t from) const {
    int fiber = 0;
    std::int64_t first = 0;
    for (; fiber + 1 < static_cast<int>(place_of_fiber.size()); ++fiber, first = next_first(fiber)) {
      if (sphere < next_first(fiber + 1)) break;
    }
    throw Diverged(fmt::format("the run blew up: fiber {}, sphere {} between steps {} and {} (dt = {:.6g} s, t = {:.6g} s); "
                               "likely cause: a step too long for the bonds or for how hard contacts press",
                               fiber, sphere - first, from, steps, step, time()));
  }

  std::int64_t next_first(int fiber) const {
    const auto [block, lane] = place_of_fiber[fiber];
    return blocks[block].first_sphere[lane];
  }

  void march(std::int64_t count);
  void march_some(int count);
};

/// Steps between two looks at all spheres.
constexpr int kStepsBetweenLooks = 256;

void Assembly::State::march_some(int count) {
  const int n_blocks = static_cast<int>(blocks.size()), n_stripes = contacts.stripes();
  bool stop = false, far = false;  // far: a sphere has moved half the skin since the pairs were listed
#pragma omp parallel num_threads(options.threads) if (options.threads > 1)
  for (int n = 0; n < count && !stop; ++n) {
#pragma omp for schedule(static) reduction(|| : far)
    for (int b = 0; b < n_blocks; ++b) {
      if (n > 0) take_loads(blocks[b]);
      blocks[b].block.march(1);
      far = hand_over(blocks[b]) || far;
    }
#pragma omp single
    {
      ++steps;
      if (std::exchange(far, false) || contacts.walls_moved_far(time())) {
        try {
          list_pairs();
        } catch (const InvalidInput&) {  // not finite: looked for below
          stop = true;
        }
      }
    }
    if (stop) break;
    const double now = time();
#pragma omp for schedule(static)
    for (int k = 0; k < n_stripes; ++k) contacts.work_out(k, now);
#pragma omp for schedule(static)
    for (int k = 0; k < n_stripes; ++k) contacts.gather_loads(k);
  }
  for (FiberBlock& own : blocks) take_loads(own);
}

void Assembly::State::march(std::int64_t count) {
  for (std::int64_t done = 0; done < count;) {
    const std::int64_t from = steps;
    march_some(static_cast<int>(std::min<std::int64_t>(kStepsBetweenLooks, count - done)));
    const std::int64_t sphere = broken();
    if (sphere >= 0) fail(sphere, from);
    done += steps - from;
  }
}

Assembly::Assembly(std::vector<FiberGroup> groups, Surroundings surroundings, AssemblyOptions options) {
  if (groups.empty()) throw InvalidInput("fibers = none is not allowed: an assembly needs at least one");
  for (const FiberGroup& group : groups) {
    check(group.chain.fiber);
    if (group.fibers.empty()) throw InvalidInput("a group of fibers without a fiber is not allowed");
    for (const auto& fiber : group.fibers) {
      if (fiber.poses.size() != group.chain.poses.size() || fiber.velocity.size() != fiber.poses.size() ||
          fiber.spin.size() != fiber.poses.size()) {
        throw InvalidInput("a fiber needs a pose, a velocity and a spin for every sphere of its chain");
      }
    }
  }
  if (options.threads < 1) throw InvalidInput(fmt::format("threads = {} is not allowed: 1 or more", options.threads));
  const double step = options.step ? *options.step : assembly_time_step(groups, surroundings).step;
  if (!(step > 0) || !std::isfinite(step)) {
    throw InvalidInput(fmt::format("step = {} s is not allowed: it must be finite and greater than 0", step));
  }
  state_ = std::make_unique<State>(std::move(groups), std::move(surroundings), std::move(options), step);
  state_->start();
}

Assembly::~Assembly() = default;
Assembly::Assembly(Assembly&&) noexcept = default;

void Assembly::march(std::int64_t steps) { state_->march(steps); }
double Assembly::step() const { return state_->step; }
std::int64_t Assembly::steps() const { return state_->steps; }
double Assembly::time() const { return state_->time(); }
std::int64_t Assembly::spheres() const { return state_->contacts.spheres(); }
int Assembly::groups() const { return static_cast<int>(state_->groups.size()); }
const Chain<3>& Assembly::chain(int group) const { return state_->groups[group].chain; }
int Assembly::fibers(int group) const { return static_cast<int>(state_->groups[group].fibers.size()); }

PlacedSpheres Assembly::placed() const {
  PlacedSpheres all;
  all.position = state_->positions();
  for (const FiberGroup& group : state_->groups) {
    const std::size_t n = group.fibers.size() * group.chain.poses.size();
    all.radius.insert(all.radius.end(), n, group.chain.fiber.diameter / 2);
  }
  return all;
}

void Assembly::insert(FiberGroup) { throw InvalidInput("insert: comes with the next commit"); }

double total(const EnergyBalance& e) {
  return e.kinetic + e.bonds + e.contacts + e.gravity + e.bond_damping + e.bond_friction + e.contact_normal +
         e.contact_tangential + e.contact_rolling + e.fluid - e.wall_work - e.inserted;
}

std::int64_t Assembly::first_sphere(int group, int fiber) const {
  return state_->first_sphere_of_group[group] +
         static_cast<std::int64_t>(fiber) * (state_->groups[group].chain.fiber.aspect_ratio + 1);
}

ChainState<3> Assembly::state(int group, int fiber) const {
  int before = 0;
  for (int g = 0; g < group; ++g) before += static_cast<int>(state_->groups[g].fibers.size());
  const auto [block, lane] = state_->place_of_fiber[before + fiber];
  return state_now(state_->blocks[block].block, lane, state_->blocks[block].spheres);
}

std::vector<BondState> Assembly::bonds(int group, int fiber) const {
  const State& s = *state_;
  int before = 0;
  for (int g = 0; g < group; ++g) before += static_cast<int>(s.groups[g].fibers.size());
  const auto [block, lane] = s.place_of_fiber[before + fiber];
  const ChainState<3> now = state(group, fiber);
  const Chain<3>& chain = s.groups[group].chain;
  const BondParameters<double> law = bond_parameters(chain.fiber);
  std::vector<BondState> bonds;
  for (std::size_t i = 0; i + 1 < now.poses.size(); ++i) {
    const BondHistory<double, 3> history = s.blocks[block].block.history(lane, static_cast<int>(i));
    const auto line = bond_vector<double, 3>(now.poses[i + 1].position - now.poses[i].position, 1 / chain.fiber.diameter);
    const RelativeMotion<double, 3> motion{now.velocity[i + 1] - now.velocity[i], 0.5 * (now.spin[i] + now.spin[i + 1]),
                                           now.spin[i + 1] - now.spin[i]};
    const Vec<double, 3> e = line.inverse_length * line.vector;
    bonds.push_back({incremental_action<true>(law, history, line, motion).force,
                     norm(history.rotation - dot(history.rotation, e) * e)});
  }
  return bonds;
}

std::int64_t Assembly::touching() const { return state_->contacts.touching(); }

std::vector<ContactState> Assembly::contacts() const { return state_->contacts.states(state_->time()); }

EnergyBalance Assembly::energy() const {
  const State& s = *state_;
  EnergyBalance sum{};
  for (int g = 0; g < static_cast<int>(s.groups.size()); ++g) {
    const Chain<3>& chain = s.groups[g].chain;
    const double m = sphere_mass(chain.fiber), J = sphere_inertia(chain.fiber);
    for (int f = 0; f < static_cast<int>(s.groups[g].fibers.size()); ++f) {
      const ChainState<3> now = state(g, f);
      for (std::size_t i = 0; i < now.poses.size(); ++i) {
        sum.kinetic += 0.5 * (m * dot(now.velocity[i], now.velocity[i]) + J * dot(now.spin[i], now.spin[i]));
        sum.gravity -= m * dot(s.surroundings.gravity, now.poses[i].position);
      }
    }
  }
  for (const FiberBlock& own : s.blocks) {
    const Chain<3>& chain = s.groups[own.group].chain;
    const BondParameters<double> bond = bond_parameters(chain.fiber);
    for (int lane = 0; lane < own.lanes(); ++lane) {
      const Poses<3> poses = own.block.poses(lane);
      if (s.options.form == BondForm::total) {
        sum.bonds += elastic_energy(chain, poses);
        continue;
      }
      for (int i = 0; i + 1 < own.spheres; ++i) {
        sum.bonds += stored_energy(bond, own.block.history(lane, i), unit(poses[i + 1].position - poses[i].position));
      }
    }
  }
  sum.contacts = s.contacts.stored_energy();
  const ContactBook<double> taken = s.contacts.taken();
  sum.contact_normal = taken.normal_dashpot;
  sum.contact_tangential = taken.sliding;
  sum.contact_rolling = taken.rolling;
  sum.wall_work = s.contacts.wall_work();
  return sum;
}

std::vector<double> Assembly::saved() const {
  const State& s = *state_;
  std::vector<double> all{static_cast<double>(s.steps), s.contacts.listed_time()};
  for (const auto& x : s.contacts.listed_at()) all.insert(all.end(), x.c, x.c + 3);
  const std::vector<KeptContact> kept = s.contacts.kept();
  all.push_back(static_cast<double>(kept.size()));
  for (const KeptContact& c : kept) {
    all.insert(all.end(), {static_cast<double>(c.first), static_cast<double>(c.second), c.spring[0], c.spring[1],
                           c.spring[2], c.overlap, c.opening});
  }
  for (const FiberBlock& own : s.blocks) {
    const std::vector<double> block = own.block.saved();
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

void Assembly::restore(const std::vector<double>& saved) {
  State& s = *state_;
  const std::size_t n = s.contacts.spheres(), block_numbers = [&] {
    std::size_t sum = 0;
    for (const FiberBlock& own : s.blocks) sum += own.block.saved().size();
    return sum;
  }();
  const std::size_t contacts_at = 2 + 3 * n;
  if (saved.size() <= contacts_at || !(saved[contacts_at] >= 0) ||
      static_cast<double>(saved.size()) != static_cast<double>(contacts_at + 1 + block_numbers) + 7 * saved[contacts_at]) {
    throw InvalidInput("these numbers are not a state of this assembly");
  }
  s.steps = static_cast<std::int64_t>(saved[0]);
  std::vector<Vec<double, 3>> listed(n);
  const double* from = saved.data() + 2;
  for (auto& x : listed) x = {from[0], from[1], from[2]}, from += 3;
  const auto count = static_cast<std::size_t>(*from++);
  std::vector<KeptContact> kept(count);
  for (KeptContact& c : kept) {
    c = {static_cast<std::int64_t>(from[0]), static_cast<std::int64_t>(from[1]), {from[2], from[3], from[4]}, from[5], from[6]};
    from += 7;
  }
  s.contacts.list_pairs(listed, saved[1]);
  s.contacts.forget();
  s.contacts.remember(kept);
  for (FiberBlock& own : s.blocks) {
    const std::size_t size = own.block.saved().size();
    own.block.restore({from, from + size});
    from += size;
    s.hand_over(own);
  }
}

}  // namespace fiberchain::dem
