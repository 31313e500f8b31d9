#include "dem/assembly/bond_breaks.hpp"

#include <algorithm>
#include <numbers>

#include "dem/assembly/assembly_state.hpp"
#include "dem/insertion/random_numbers.hpp"
#include "dem/model/errors.hpp"

// Bonds that break: what they bear, which have broken in a step, the pieces that are left.
namespace fiberchain::dem {
namespace {

double section_area(const Fiber& fiber) {
  return std::numbers::pi * sphere_radius(fiber) * sphere_radius(fiber);
}

/// Of a bond's strengths: a function of the seed, the fiber and the bond alone.
double spread_of(const Fiber& fiber, std::uint64_t group, std::uint64_t number, int bond) {
  if (!fiber.strength->weibull) return 1;
  const WeibullSpread& spread = *fiber.strength->weibull;
  const auto n = static_cast<std::uint64_t>(bond);
  const double u = uniform_numbers(spread.seed, {number, group, n / 4})[n % 4];
  return weibull_factor(spread, bond_length(fiber), u);
}

}  // namespace

BondFailure<double> FiberBlock::failure(const GroupKind& kind, int lane, int bond) const {
  const auto width = static_cast<std::size_t>(kind.kernel->width);
  const double* numbers = kind.history_of(history_, lane, bond) + kind.law->failure_place * width;
  return get_strided<BondFailure<double>>(numbers, width);
}

void FiberBlock::put(const GroupKind& kind, int lane, int bond, const BondFailure<double>& failure) {
  const auto width = static_cast<std::size_t>(kind.kernel->width);
  put_strided(failure, kind.history_of(history_, lane, bond) + kind.law->failure_place * width, width);
}

void FiberBlock::put_limits(const GroupKind& kind, const std::vector<std::int32_t>& numbers) {
  if (kind.law->failure_place < 0) return;
  const Fiber& fiber = kind.chain.fiber;
  for (int lane = 0; lane < kind.kernel->width; ++lane) {  // unused lanes repeat the last fiber
    const auto number = static_cast<std::uint64_t>(numbers[std::min(lane, lanes_ - 1)]);
    for (int i = 0; i < fiber.aspect_ratio; ++i) {
      BondFailure<double> own = failure(kind, lane, i);
      if (fiber.yield) own.yield = std::max(fiber.yield->moment, own.yield < no_limit ? own.yield : 0);
      if (fiber.strength) {
        const BondStrength& strength = *fiber.strength;
        const double scale = section_area(fiber) * spread_of(fiber, group_, number, i);
        const std::optional<double> stresses[] = {strength.tension, strength.compression, strength.shear,
                                                  strength.torsion};
        for (int n = 0; n < 4; ++n) own.limit[n] = stresses[n] ? scale * *stresses[n] : no_limit;
      }
      put(kind, lane, i, own);
    }
  }
}

bool FiberBlock::look_for_breaks(const GroupKind& kind) const {
  const std::ptrdiff_t width = kind.kernel->width,
                       bond = static_cast<std::ptrdiff_t>(kind.memory.bond) * width;
  const double* flags = history_ + kind.law->intact_place * width;
  for (int i = 0; i < kind.chain.fiber.aspect_ratio; ++i, flags += bond) {
    if (std::any_of(flags, flags + width, [](double intact) { return intact == 0.5; })) return true;
  }
  return false;
}

std::vector<FiberBlock::Broken> FiberBlock::settle_breaks(const GroupKind& kind) {
  std::vector<Broken> all;
  for (int lane = 0; lane < kind.kernel->width; ++lane) {
    for (int i = 0; i < kind.chain.fiber.aspect_ratio; ++i) {
      BondFailure<double> own = failure(kind, lane, i);
      if (own.intact != 0.5) continue;
      if (lane < lanes_) all.push_back({lane, i, own});
      own.intact = 0;
      put(kind, lane, i, own);
      if (previous_.size() == 0) continue;
      // half a kick: all numbers of the loads, of a bond that is solved for the part that counts
      const auto width = static_cast<std::size_t>(kind.kernel->width);
      double* numbers = previous_.data() + i * bond_account_size * width + lane;
      const bool solved = kind.kernel->half_kick != nullptr;
      constexpr int counted = 12;  // PreviousMotion::counted
      for (int n = solved ? counted : 0; n < (solved ? counted + 1 : bond_account_size); ++n)
        numbers[n * width] *= 0.5;
    }
  }
  has_breaks_ = false;
  return all;
}

std::int64_t FiberBlock::begin_failures(const GroupKind& kind) {
  std::int64_t broken = 0;
  for (int lane = 0; lane < kind.kernel->width; ++lane) {
    for (int i = 0; i < kind.chain.fiber.aspect_ratio; ++i) {
      BondFailure<double> own = failure(kind, lane, i);
      own.work = 0;
      put(kind, lane, i, own);
      broken += lane < lanes_ && own.intact == 0 ? 1 : 0;
    }
  }
  return broken;
}

void FiberBlock::break_bond(const GroupKind& kind, int lane, int bond) {
  if (kind.law->intact_place < 0) throw InvalidInput("a broken bond is not allowed: this bond law has none");
  const int end = lane + 1 == lanes_ ? kind.kernel->width : lane + 1;  // unused lanes repeat the last fiber
  for (int k = lane; k < end; ++k) {
    if (kind.law->failure_place < 0) {
      *intact(kind, kind.history_of(history_, k, bond)) = 0;
      continue;
    }
    BondFailure<double> own = failure(kind, k, bond);
    if (own.intact == 1) own.cause = static_cast<double>(BreakCause::by_hand);
    put(kind, k, bond, own);
  }
}

void Assembly::State::settle_breaks() {
  if (!may_break) return;
  bool any = false;
  for (FiberBlock& block : blocks) {
    if (!block.has_breaks()) continue;
    any = true;
    const GroupKind& kind = kinds[block.group()];
    const int first_place = static_cast<int>((block.first(0) - group_begin(block.group())) / kind.spheres());
    for (const FiberBlock::Broken& broken : block.settle_breaks(kind)) {
      const std::int64_t row = block.first(broken.lane) + broken.bond;
      const BondFailure<double>& failure = broken.failure;
      const auto cause = static_cast<BreakCause>(static_cast<int>(failure.cause));
      // both spheres have moved on since
      const Vec<double, 3> middle = 0.5 * (rows.position(row) + rows.position(row + 1)) -
                                    0.5 * step * (rows.velocity(row) + rows.velocity(row + 1));
      breaks.push_back(
          {.step = steps - 1,
           .time = time() - step,
           .group = block.group(),
           .fiber = order[block.group()].fiber(first_place + broken.lane),
           .bond = broken.bond,
           .cause = cause,
           .stress = cause == BreakCause::by_hand ? 0 : failure.stress / section_area(kind.chain.fiber),
           .energy = failure.energy,
           .place = middle});
      released += failure.energy;
      ++broken_bonds;
      parted.push_back(row);
    }
  }
  if (!any) return;
  released += contacts.held_by_segments(parted);
  part_pieces();
  rebuild_neighbor_list();
  sort_where_mixed();
}

void Assembly::State::part_pieces() {
  if (!may_break) return;
  std::vector<std::int64_t> all;
  for (const FiberBlock& block : blocks) {
    const GroupKind& kind = kinds[block.group()];
    if (kind.law->failure_place < 0) continue;
    for (int lane = 0; lane < block.lanes(); ++lane) {
      for (int i = 0; i < kind.chain.fiber.aspect_ratio; ++i) {
        if (block.is_broken(kind, lane, i)) all.push_back(block.first(lane) + i);
      }
    }
  }
  contacts.part_behind(all);
}

void Assembly::State::adopt_failures(int groups) {
  if (!may_break) return;
  broken_bonds = 0;
  for (FiberBlock& block : blocks) {
    const GroupKind& kind = kinds[block.group()];
    if (block.group() >= groups || kind.law->failure_place < 0) continue;
    const FiberOrder& places = order[block.group()];
    const int first_place = static_cast<int>((block.first(0) - group_begin(block.group())) / kind.spheres());
    std::vector<std::int32_t> numbers;
    for (int lane = 0; lane < block.lanes(); ++lane) numbers.push_back(places.fiber(first_place + lane));
    block.put_limits(kind, numbers);
    broken_bonds += block.begin_failures(kind);
  }
  if (broken_bonds == 0) return;
  part_pieces();
  rebuild_neighbor_list();
  for (int k = 0; k < contacts.parts().count(); ++k) loads.take(k, 0);
  touch();  // contacts of parted spheres are there from now on
}

void Assembly::State::account_parted() {
  if (parted.empty()) return;
  released -= contacts.brought_behind(parted);
  parted.clear();
}

std::vector<BondBreak> Assembly::take_breaks() { return std::exchange(state_->breaks, {}); }

std::int64_t Assembly::pieces() const {
  std::int64_t all = state_->broken_bonds;
  for (const int fibers : state_->fibers) all += fibers;
  return all;
}

}  // namespace fiberchain::dem
