#include "dem/assembly/fiber_block.hpp"

#include <algorithm>

#include "dem/bond/branch_steps.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/half_step.hpp"
#include "dem/motion/physics_of.hpp"
#include "dem/motion/relaxation.hpp"
#include "dem/motion/stiff_limits.hpp"

namespace fiberchain::dem {
namespace {

using Moving = MovingSphere<double, 3>;

/// Lanes of `dissipated_`: three sums a lane.
constexpr int taken_numbers = 3;

double sum_of_lanes(const double* numbers, int lanes) {
  double sum = 0;
  for (int k = 0; k < lanes; ++k) sum += numbers[k];
  return sum;
}

void put_rows(SphereStorage& rows, std::int64_t row, const ChainState<3>& state, double radius) {
  for (std::size_t i = 0; i < state.poses.size(); ++i, ++row) {
    double *slot = rows.position_row(row), *motion = rows.velocity_row(row);
    for (int c = 0; c < 3; ++c) {
      slot[c] = state.poses[i].position[c];
      motion[c] = state.velocity[i][c];
      motion[spin_offset + c] = state.spin[i][c];
    }
    slot[radius_offset] = radius;
    if (!rows.oriented()) continue;
    const Quaternion<double>& turn = state.poses[i].orientation;
    double* q = rows.orientation.data() + row * quaternion_size;
    q[0] = turn.w;
    for (int c = 0; c < 3; ++c) q[1 + c] = turn.v[c];
  }
}

/// Branches of the kind's bonds, the same in every lane.
void put_branches(GroupKind& kind, double step) {
  kind.memory.bond = kind.kernel->history;
  const BranchSteps own = branch_steps(kind.chain.fiber, step, 3);
  if (own.steps.empty()) return;
  const std::size_t width = kind.kernel->width, size = numbers_of<BranchStep<double>>;
  kind.lane_branches = LaneArray(own.steps.size() * size * width);
  for (std::size_t j = 0; j < own.steps.size(); ++j) {
    for (std::size_t lane = 0; lane < width; ++lane)
      kind.lane_branches.put(own.steps[j], j * size * width + lane, width);
  }
  kind.memory = memory_view<3>(own, kind.lane_branches.data(), kind.law->form, kind.kernel->history);
}

}  // namespace

GroupKind group_kind(const Chain<3>& chain, std::size_t fibers, const AssemblyOptions& options,
                     const Domain& domain, double step) {
  const Fiber& fiber = chain.fiber;
  const PackingLaw& law = packing_law(options, fiber);
  const Physics physics = physics_of(chain, {.form = law.form,
                                             .solved = solved_by(options.integrator),
                                             .rolling = options.rolling,
                                             .fluid = domain.fluid.has_value()});
  GroupKind kind{.chain = chain,
                 .law = &law,
                 .kernel = &law.kernel(physics, options.instruction_set),
                 .parameters = {},
                 .histories = {},
                 .lane_branches = {},
                 .memory = {},
                 .lane_parameters = {},
                 .lane_natural = {},
                 .drag = {},
                 .weight = {},
                 .mass = sphere_mass(fiber),
                 .inertia = sphere_inertia(fiber),
                 .half = {},
                 .end_half = {}};
  kind.weight = kind.mass * domain.gravity;
  if (domain.fluid) kind.drag = stokes_drag(*domain.fluid, fiber);
  kind.parameters = march_parameters<3>(fiber, kind.drag, step);
  if (physics.fails) {
    BondParameters<double>& bond = kind.parameters.bond;
    bond.own[inverse_radius_place] = 2 / sphere_radius(fiber);
    // plastic angle takes 1/H of what the whole takes by 1/(h K) and the elastic one by 1/K
    const double h = fiber.yield ? fiber.yield->hardening : 0;
    bond.own[hardening_place] = h / (1 - h) * bond.bend;
  }
  if (physics.solved == Solved::bonds) kind.bearable_tension = largest_tension(fiber, step);
  kind.half = half_step(fiber, 1, kind.drag, step);
  kind.end_half = half_step(fiber, end_mass_share(fiber), kind.drag, step);
  const std::size_t width = kind.kernel->width;
  put_branches(kind, step);
  kind.histories = LaneArray((fibers + width - 1) / width * kind.history_size());
  const std::size_t ends = numbers_of<NaturalEnds<double, 3>>;
  kind.lane_parameters = LaneArray(numbers_of<MarchParameters<double, 3>> * width);
  kind.lane_natural = LaneArray(chain.natural.size() * ends * width);
  for (std::size_t lane = 0; lane < width; ++lane) {
    kind.lane_parameters.put(kind.parameters, lane, width);
    for (std::size_t i = 0; i < chain.natural.size(); ++i)
      kind.lane_natural.put(chain.natural[i], i * ends * width + lane, width);
  }
  return kind;
}

FiberBlock::FiberBlock(GroupKind& kind, int group, int number, std::int64_t first,
                       const std::vector<ChainState<3>>& fibers, const std::vector<std::int32_t>& numbers,
                       bool accounted, SphereStorage& rows)
    : group_(group),
      lanes_(static_cast<int>(fibers.size())),
      history_(kind.histories.data() + number * kind.history_size()),
      history_size_(kind.history_size()) {
  const int width = kind.kernel->width, bonds = kind.chain.fiber.aspect_ratio;
  workspace_ = LaneArray(kind.kernel->workspace(bonds) * width);
  const bool accounts = accounted && kind.kernel->account != nullptr;
  previous_ = LaneArray(accounts ? static_cast<std::size_t>(bonds) * bond_account_size * width : 0);
  dissipated_ = LaneArray(taken_numbers * width);
  for (int lane = 0; lane < width; ++lane) {
    const int fiber = std::min(lane, lanes_ - 1);
    first_.push_back(first + static_cast<std::int64_t>(fiber) * kind.spheres());
    for (int i = 0; i < bonds; ++i) {
      kind.law->start(kind.chain, fibers[fiber], i, kind.history_of(history_, lane, i), width);
    }
  }
  put_limits(kind, numbers);
  for (int lane = 0; lane < lanes_; ++lane)
    put_rows(rows, first_[lane], fibers[lane], sphere_radius(kind.chain.fiber));
}

PackingBlock FiberBlock::view(const GroupKind& kind, SphereStorage& rows, LoadRange loads, LaneArray& scratch,
                              const double* gradient) {
  return {.bonds = kind.chain.fiber.aspect_ratio,
          .first = first_.data(),
          .position_radius = rows.position_radius.data(),
          .velocity_spin = rows.velocity_spin.data(),
          .loads = loads.rows,
          .first_loaded = loads.first,
          .orientation = rows.oriented() ? rows.orientation.data() : nullptr,
          .history = history_,
          .natural = kind.lane_natural.data(),
          .parameters = kind.lane_parameters.data(),
          .workspace = workspace_.data(),
          .scratch = scratch.data(),
          .weight = {kind.weight[0], kind.weight[1], kind.weight[2]},
          .end_share = end_mass_share(kind.chain.fiber),
          .gradient = gradient,
          .next_history = nullptr,
          .rows_ahead = 0,
          .previous_step = previous_step_,
          .extremes = &extremes_,
          .memory = kind.memory};
}

double FiberBlock::step(const GroupKind& kind, SphereStorage& rows, LoadRange loads, LaneArray& scratch,
                        const double* gradient, const FiberBlock* next, std::int64_t rows_ahead) {
  PackingBlock block = view(kind, rows, loads, scratch, gradient);
  block.rows_ahead = rows_ahead;
  block.may_break = true;
  if (next != nullptr) block.next_history = next->history_;
  const double fastest = kind.kernel->step(block);
  previous_step_ = kind.parameters.step;
  if (kind.law->failure_place >= 0) has_breaks_ = look_for_breaks(kind);
  return fastest;
}

void FiberBlock::account(const GroupKind& kind, SphereStorage& rows, LaneArray& scratch) {
  if (previous_.size() == 0) return;
  const int width = kind.kernel->width;
  double* sums = dissipated_.data();
  kind.kernel->account(view(kind, rows, {nullptr, first_[0]}, scratch, nullptr),
                       {previous_.data(), sums, sums + width, sums + 2 * width});
}

FiberBlock::Taken FiberBlock::taken(const GroupKind& kind, const SphereStorage& rows) const {
  if (previous_.size() == 0) return {};
  LaneArray previous = previous_.copy(), dissipated = dissipated_.copy(), unused;
  // reads all but these
  PackingBlock now = const_cast<FiberBlock*>(this)->view(kind, const_cast<SphereStorage&>(rows),
                                                         {nullptr, first_[0]}, unused, nullptr);
  const int width = kind.kernel->width;
  double* sums = dissipated.data();
  if (moved()) kind.kernel->account(now, {previous.data(), sums, sums + width, sums + 2 * width});
  return {sum_of_lanes(sums, lanes_), sum_of_lanes(sums + width, lanes_),
          sum_of_lanes(sums + 2 * width, lanes_)};
}

BlockSnapshot FiberBlock::snapshot(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                                   const double* gradient) const {
  BlockSnapshot all;
  snapshot(kind, rows, loads, gradient, all);
  return all;
}

void FiberBlock::snapshot(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                          const double* gradient, BlockSnapshot& into, bool may_break) const {
  const auto fit = [](LaneArray& array, std::size_t size) {
    if (array.size() != size) array = LaneArray(size);
  };
  fit(into.spheres, kind.kernel->scratch(kind.chain.fiber.aspect_ratio));
  fit(into.history, history_size_);
  fit(into.workspace, workspace_.size());
  std::copy_n(history_, history_size_, into.history.data());
  std::copy_n(workspace_.data(), workspace_.size(), into.workspace.data());
  PackingBlock view = snapshot_view(kind, rows, loads, gradient, into);
  view.may_break = may_break;
  kind.kernel->snapshot(view);
}

PackingBlock FiberBlock::snapshot_view(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                                       const double* gradient, BlockSnapshot& into) const {
  // what a snapshot writes are its own copies
  PackingBlock view = const_cast<FiberBlock*>(this)->view(kind, const_cast<SphereStorage&>(rows), loads,
                                                          into.spheres, gradient);
  view.history = into.history.data();
  view.workspace = into.workspace.data();
  return view;
}

void FiberBlock::to_this_moment(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                                const double* gradient, BlockSnapshot& snapshot) const {
  if (kind.kernel->half_kick != nullptr)
    kind.kernel->half_kick(snapshot_view(kind, rows, loads, gradient, snapshot), false);
}

Moving FiberBlock::sphere(const GroupKind& kind, const BlockSnapshot& snapshot, int lane, int index) const {
  const std::size_t width = kind.kernel->width;
  Moving sphere{};
  snapshot.spheres.get(sphere, index * numbers_of<Moving> * width + lane, width);
  return sphere;
}

void FiberBlock::start(const GroupKind& kind, SphereStorage& rows, LoadRange loads, const double* gradient,
                       const Gradient& A) {
  BlockSnapshot now = snapshot(kind, rows, loads, gradient);
  const bool together = kind.kernel->half_kick != nullptr;
  if (together) kind.kernel->half_kick(snapshot_view(kind, rows, loads, gradient, now), true);
  for (int lane = 0; lane < lanes_; ++lane) {
    for (int i = 0; i < kind.spheres(); ++i) {
      Moving s = sphere(kind, now, lane, i);
      if (!together) move_half_step(s, kind.half_of(i), EndLoad<double, 3>{}, A, true);
      double* own = rows.velocity_row(first_[lane] + i);
      for (int c = 0; c < 3; ++c) own[c] = s.velocity[c], own[spin_offset + c] = s.spin[c];
    }
  }
}

std::array<std::span<double>, 6> FiberBlock::saved_arrays() {
  const auto all = [](LaneArray& array) { return std::span(array.data(), array.size()); };
  return {std::span(&previous_step_, 1),
          std::span(&fluid_dissipated_, 1),
          std::span(history_, history_size_),
          all(workspace_),
          all(previous_),
          all(dissipated_)};
}

}  // namespace fiberchain::dem
