#include "dem/assembly/fiber_reader.hpp"

#include <cmath>

#include "dem/motion/half_step.hpp"

// Fibers one by one or all: their states and bonds.
namespace fiberchain::dem {
namespace {

/// Orientations that are not followed are not numbers.
ChainState<3> known_part(const Assembly::State& s, ChainState<3> state) {
  if (s.rows.oriented()) return state;
  const double unknown = std::nan("");
  for (auto& pose : state.poses) pose.orientation = {unknown, {unknown, unknown, unknown}};
  return state;
}

/// visit(fiber, reader, lane) for all fibers of a group, in no order.
template <class Visit>
void each_fiber(const Assembly::State& s, int group, const Visit& visit) {
  FiberReader reader(s);
  for (int place = 0, b = s.first_block[group]; place < s.fibers[group]; ++b) {
    const FiberBlock& block = s.blocks[b];
    reader.take(block);
    for (int lane = 0; lane < block.lanes(); ++lane, ++place)
      visit(s.order[group].fiber(place), reader, lane);
  }
}

}  // namespace

void FiberReader::take(const FiberBlock& block) {
  block_ = &block;
  kind_ = &all_.kinds[block.group()];
  const LoadRange loads = all_.loads.of(all_.part_of(block));
  block.snapshot(*kind_, all_.rows, loads, all_.gradient.data(), now_);
  block.to_this_moment(*kind_, all_.rows, loads, all_.gradient.data(), now_);
}

const ChainState<3>& FiberReader::read(int lane) {
  const auto spheres = static_cast<std::size_t>(kind_->spheres());
  state_.poses.resize(spheres), state_.velocity.resize(spheres), state_.spin.resize(spheres);
  for (int i = 0; i < kind_->spheres(); ++i) {
    MovingSphere<double, 3> s = block_->sphere(*kind_, now_, lane, i);
    if (kind_->kernel->half_kick == nullptr)
      move_half_step(s, kind_->half_of(i), EndLoad<double, 3>{}, gradient_, false);
    state_.poses[i] = s.pose, state_.velocity[i] = s.velocity, state_.spin[i] = s.spin;
  }
  const std::ptrdiff_t block = block_ - all_.blocks.data();
  if (!all_.held.in_block(static_cast<std::size_t>(block))) return state_;
  spheres_.clear();
  for (int i = 0; i < kind_->spheres(); ++i) spheres_.push_back(block_->sphere(*kind_, now_, lane, i));
  all_.held.correct(all_, static_cast<int>(block), lane, spheres_, state_);
  return state_;
}

const std::vector<BondState>& FiberReader::bonds(int lane) {
  bonds_.resize(static_cast<std::size_t>(kind_->chain.fiber.aspect_ratio));
  for (int i = 0; i + 1 < kind_->spheres(); ++i)
    bonds_[i] = kind_->law->state(kind_->parameters.bond, kind_->chain, state_, i, history(lane, i),
                                  kind_->kernel->width);
  return bonds_;
}

ChainState<3> Assembly::state(int group, int fiber) const {
  const State::Slot at = state_->slot(group, fiber);
  FiberReader reader(*state_);
  reader.take(state_->blocks[at.block]);
  return known_part(*state_, reader.read(at.lane));
}

std::vector<BondState> Assembly::bonds(int group, int fiber) const {
  const State::Slot at = state_->slot(group, fiber);
  FiberReader reader(*state_);
  reader.take(state_->blocks[at.block]);
  reader.read(at.lane);
  return reader.bonds(at.lane);
}

std::vector<ChainState<3>> Assembly::states(int group) const {
  std::vector<ChainState<3>> all(state_->fibers[group]);
  each_fiber(*state_, group, [&](int fiber, FiberReader& reader, int lane) {
    all[fiber] = known_part(*state_, reader.read(lane));
  });
  return all;
}

std::vector<std::vector<BondState>> Assembly::bonds(int group) const {
  std::vector<std::vector<BondState>> all(state_->fibers[group]);
  each_fiber(*state_, group, [&](int fiber, FiberReader& reader, int lane) {
    reader.read(lane);
    all[fiber] = reader.bonds(lane);
  });
  return all;
}

void Assembly::visit(int group, const FiberVisit& visitor) const {
  State& s = *state_;
  const int first = s.first_block[group], width = s.kinds[group].kernel->width,
            last = first + (s.fibers[group] + width - 1) / width;
  for_blocks(s, first, last, [&](int b, FiberReader& reader) {
    reader.take(s.blocks[b]);
    for (int lane = 0; lane < s.blocks[b].lanes(); ++lane) {
      const ChainState<3>& state = reader.read(lane);
      visitor(s.order[group].fiber((b - first) * width + lane), state, reader.bonds(lane));
    }
  });
}

}  // namespace fiberchain::dem
