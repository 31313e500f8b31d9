#include "dem/assembly/assembly_state.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_lane.hpp"

namespace fiberchain::dem {
namespace {

/// Larger storage that begins with the rows of `from`.
SphereStorage grown(const SphereStorage& from, std::int64_t count, bool oriented) {
  SphereStorage rows(count, oriented);
  const auto copy = [&](const LaneArray& source, LaneArray& target, int numbers) {
    std::copy_n(source.data(), from.count * numbers, target.data());
  };
  copy(from.position_radius, rows.position_radius, position_radius_size);
  copy(from.velocity_spin, rows.velocity_spin, velocity_spin_size);
  if (oriented && from.count > 0) copy(from.orientation, rows.orientation, quaternion_size);
  return rows;
}

/// Of the fibers of a group that is not there yet.
FiberOrder order_at_start(const FiberGroup& group, bool in_space, const Domain& domain) {
  const std::size_t spheres = group.chain.poses.size();
  if (!in_space) return FiberOrder(static_cast<std::int32_t>(group.fibers.size()));
  std::vector<Vec<double, 3>> middles;
  for (const ChainState<3>& fiber : group.fibers) middles.push_back(fiber.poses[spheres / 2].position);
  return order_in_space(std::move(middles), domain.period);
}

/// Fibers of a block at most, over all instruction sets.
constexpr int widest_block = 8;

/// Sphere numbers are int32, pads included.
constexpr std::int64_t most_spheres = 2'000'000'000;

}  // namespace

int Assembly::State::add(const std::vector<FiberGroup>& groups) {
  std::int64_t count = rows.count;
  for (const FiberGroup& group : groups)
    count += static_cast<std::int64_t>(group.fibers.size()) * group.chain.poses.size();
  if (count > most_spheres)
    throw InvalidInput(fmt::format("spheres = {} is not allowed: at most {}", count, most_spheres));
  contacts.check_periods(groups);
  const bool oriented = options.orientations || packing_law(options).from_poses;
  std::int64_t row = rows.count;
  rows = grown(rows, count, oriented);
  const int first_new = static_cast<int>(blocks.size());
  std::size_t scratch_size = scratch.empty() ? 0 : scratch[0].size();
  for (const FiberGroup& group : groups) {
    const int number = static_cast<int>(kinds.size());
    kinds.push_back(group_kind(group.chain, group.fibers.size(), options, domain, step));
    GroupKind& kind = kinds.back();
    fibers.push_back(static_cast<int>(group.fibers.size()));
    first_block.push_back(static_cast<int>(blocks.size()));
    order.push_back(order_at_start(group, options.sort_in_space && is_worth_sorting(count), domain));
    contacts.add(group.chain, fibers.back());
    may_break = may_break || kind.law->failure_place >= 0;
    scratch_size = std::max(scratch_size, kind.kernel->scratch(group.chain.fiber.aspect_ratio));
    for (std::size_t f = 0; f < group.fibers.size(); f += static_cast<std::size_t>(kind.kernel->width)) {
      const std::size_t end = std::min(group.fibers.size(), f + kind.kernel->width);
      std::vector<ChainState<3>> lanes;
      std::vector<std::int32_t> numbers;
      for (std::size_t place = f; place < end; ++place) {
        numbers.push_back(order.back().fiber(static_cast<std::int64_t>(place)));
        lanes.push_back(group.fibers[numbers.back()]);
      }
      blocks.emplace_back(kind, number, static_cast<int>(blocks.size()) - first_block.back(), row, lanes,
                          numbers, options.account_energy, rows);
      row = blocks.back().end(kind);
    }
    if (gradient.size() == 0) gradient = LaneArray(9 * kind.kernel->width);
  }
  scratch.clear();
  for (int t = 0; t < options.threads; ++t) scratch.emplace_back(scratch_size);
  set_gradient();
  part_pieces();
  const std::vector<double> loads_before = loads.all();
  contacts.begin(rows, partition_of_blocks(), time(), pool);
  loads = ForceBuffers(contacts.parts(), options.threads);
  loads.set(loads_before.data(), loads_before.size());
  displacement_budget = 0.5 * contacts.skin();
  wavefront = WavefrontSchedule(contacts.parts().count());
  paths.assign(contacts.parts().count(), 0);
  part_times.assign(contacts.parts().count(), {});
  watch.contacts_before = watch.both_before = 0;
  best_cross_part_fraction = first_new == 0 ? contacts.cross_part_fraction() : 0;
  held.locate(*this);
  return first_new;
}

/// Parts of whole blocks of the widest kind: the same for every instruction set.
Partition Assembly::State::partition_of_blocks() {
  std::vector<std::int32_t> ends;
  for (std::size_t g = 0; g < kinds.size(); ++g) {
    for (int f = 0; f < fibers[g]; f += widest_block) {
      const int last = std::min(f + widest_block, fibers[g]) - 1;
      ends.push_back(static_cast<std::int32_t>(first_sphere(static_cast<int>(g), last + 1)));
    }
  }
  Partition parts = cache_sized_partition(ends);
  part_blocks.assign(1, 0);
  for (int k = 0; k < parts.count(); ++k) {
    int b = part_blocks.back();
    while (b < static_cast<int>(blocks.size()) && blocks[b].first(0) < parts.end(k)) ++b;
    part_blocks.push_back(b);
  }
  return parts;
}

void Assembly::State::start_blocks(int from) {
  for (std::size_t b = from; b < blocks.size(); ++b) {
    blocks[b].start(kinds[blocks[b].group()], rows, loads.of(part_of(blocks[b])), gradient.data(),
                    gradient_now());
  }
}

Gradient Assembly::State::gradient_now() const {
  return domain.fluid ? gradient_at(domain.fluid->flow, time()) : Gradient{};
}

void Assembly::State::set_gradient() {
  if (!domain.fluid) return;
  const Gradient A = gradient_now();
  const std::size_t width = gradient.size() / 9;
  for (int n = 0; n < 9; ++n) std::fill_n(gradient.data() + n * width, width, A[n / 3][n % 3]);
}

/// First sphere that has blown up: not finite, or its bond ten times too long or short; -1 if none.
std::int64_t Assembly::State::broken() const {
  for (const FiberBlock& block : blocks) {
    const GroupKind& kind = kinds[block.group()];
    const double l = bond_length(kind.chain.fiber);
    for (int lane = 0; lane < block.lanes(); ++lane) {
      for (std::int64_t i = block.first(lane); i < block.first(lane) + kind.spheres(); ++i) {
        const Vec<double, 3> v = rows.velocity(i), w = rows.spin(i);
        const double sum = v[0] + v[1] + v[2] + w[0] + w[1] + w[2];
        const int bond = static_cast<int>(i - block.first(lane)) - 1;  // to the sphere before
        const bool bonded = bond >= 0 && !block.is_broken(kind, lane, bond);
        const double length =
            bonded ? norm(rows.position(i) - rows.position(i - 1)) : l + 0 * norm(rows.position(i));
        if (!std::isfinite(sum) || blown_up(length, l)) return i;
      }
    }
  }
  return -1;
}

std::string Assembly::State::place_of(std::int64_t sphere) const {
  std::int64_t own = number_of(sphere), before = 0;
  for (std::size_t g = 0; g < kinds.size(); ++g) {
    const std::int64_t n = kinds[g].spheres(), of_group = n * fibers[g];
    if (own < of_group) return fmt::format("fiber {}, sphere {}", before + own / n, own % n);
    own -= of_group, before += fibers[g];
  }
  return "a fiber";
}

void Assembly::State::fail(std::int64_t sphere, std::int64_t from) const {
  const bool walls_come =
      std::ranges::any_of(domain.walls, [](const Wall& w) { return w.active_from > 0 || !is_at_rest(w); });
  throw Diverged(
      fmt::format("the run blew up: {} between steps {} and {} (dt = {:.6g} s, t = {:.6g} s); likely cause: "
                  "a step too long "
                  "for the bonds or for how hard contacts press{}",
                  place_of(sphere), from, steps, step, time(),
                  walls_come ? ", or a wall that came upon spheres or moves into them" : ""));
}

}  // namespace fiberchain::dem
