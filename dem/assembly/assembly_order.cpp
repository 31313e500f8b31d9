#include <algorithm>
#include <array>
#include <utility>

#include "dem/assembly/assembly_state.hpp"

// The order of fibers in memory: neighbors in space lie near each other, so that contacts find their spheres
// in the caches and parts have few neighbors. Fibers keep their numbers.
namespace fiberchain::dem {
namespace {

using LaneArrays = std::array<std::vector<double>, FiberBlock::moved_arrays.size()>;

LaneArrays copies_of(FiberBlock& block) {
  LaneArrays copies;
  for (std::size_t n = 0; n < copies.size(); ++n) {
    const std::span<double> from = block.saved_arrays()[FiberBlock::moved_arrays[n]];
    copies[n].assign(from.begin(), from.end());
  }
  return copies;
}

void copy_lane(const LaneArrays& from, int from_lane, FiberBlock& to, int to_lane, int width) {
  for (std::size_t n = 0; n < from.size(); ++n) {
    const std::span<double> numbers = to.saved_arrays()[FiberBlock::moved_arrays[n]];
    for (std::size_t k = 0; k < numbers.size(); k += width) numbers[k + to_lane] = from[n][k + from_lane];
  }
}

/// Rows at their new places, and the pads behind them.
LaneArray moved(const LaneArray& from, const std::vector<std::int32_t>& new_row, int numbers) {
  LaneArray to(from.size());
  for (std::size_t row = 0; row < new_row.size(); ++row)
    std::copy_n(from.data() + row * numbers, numbers,
                to.data() + static_cast<std::size_t>(new_row[row]) * numbers);
  const std::size_t pads = new_row.size() * numbers;
  std::copy(from.data() + pads, from.data() + from.size(), to.data() + pads);
  return to;
}

/// Bonds of a group's fibers to the lanes of their new places.
void move_bonds(const GroupKind& kind, std::span<FiberBlock> blocks, const FiberOrder& before,
                const FiberOrder& after) {
  const int width = kind.kernel->width;
  std::vector<LaneArrays> copies;
  for (FiberBlock& block : blocks) copies.push_back(copies_of(block));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (int lane = 0; lane < width; ++lane) {  // unused lanes repeat the last fiber
      const int place = std::min(static_cast<int>(b) * width + lane, after.count() - 1);
      const int source = before.place(after.fiber(place));
      copy_lane(copies[source / width], source % width, blocks[b], lane, width);
    }
  }
}

}  // namespace

std::int64_t Assembly::State::number_of(std::int64_t row) const {
  const int group = group_of(row);
  const std::int64_t n = kinds[group].spheres(), own = row - group_begin(group);
  return first_sphere(group, order[group].fiber(own / n)) + own % n;
}

std::int64_t Assembly::State::row_of(std::int64_t number) const {
  const int group = group_of(number);
  const std::int64_t n = kinds[group].spheres(), own = number - group_begin(group);
  return first_row(group, static_cast<int>(own / n)) + own % n;
}

/// The group that a row or a number is of.
int Assembly::State::group_of(std::int64_t row) const {
  int group = static_cast<int>(kinds.size()) - 1;
  while (row < group_begin(group)) --group;
  return group;
}

FiberOrder Assembly::State::order_now(int group) const {
  const GroupKind& kind = kinds[group];
  std::vector<Vec<double, 3>> middles;
  for (int fiber = 0; fiber < fibers[group]; ++fiber)
    middles.push_back(rows.position(first_row(group, fiber) + kind.spheres() / 2));
  return order_in_space(std::move(middles), domain.period);
}

std::vector<std::int32_t> Assembly::State::rows_in(const std::vector<FiberOrder>& after) const {
  std::vector<std::int32_t> new_row(rows.count);
  for (int group = 0; group < static_cast<int>(kinds.size()); ++group) {
    for (int fiber = 0; fiber < fibers[group]; ++fiber) {
      const std::int64_t from = first_row(group, fiber), to = first_sphere(group, after[group].place(fiber));
      for (int i = 0; i < kinds[group].spheres(); ++i) new_row[from + i] = static_cast<std::int32_t>(to + i);
    }
  }
  return new_row;
}

/// Tries once neighbor pairs across parts are a quarter more, or those within parts a fifth less, than they
/// were at best since the last try; moves fibers where that pays.
void Assembly::State::sort_where_mixed() {
  constexpr double more = 1.25, less_within = 0.8, least_more = 0.05, worthwhile = 0.95;
  if (!options.sort_in_space || !is_worth_sorting(rows.count)) return;
  const double now = contacts.cross_part_fraction();
  double& best = best_cross_part_fraction;
  best = std::min(best, now);
  if (now <= std::max(std::min(more * best, 1 - less_within * (1 - best)), best + least_more)) return;
  std::vector<FiberOrder> after;
  for (int group = 0; group < static_cast<int>(kinds.size()); ++group) after.push_back(order_now(group));
  const std::vector<std::int32_t> new_row = rows_in(after);
  if (contacts.cross_part_fraction(new_row) < worthwhile * now) move_to(std::move(after), new_row);
  best = contacts.cross_part_fraction();
}

void Assembly::State::move_to(std::vector<FiberOrder> after, const std::vector<std::int32_t>& new_row) {
  for (std::size_t group = 0; group < kinds.size(); ++group) {
    const std::size_t first = first_block[group],
                      end = group + 1 < kinds.size() ? first_block[group + 1] : blocks.size();
    move_bonds(kinds[group], std::span(blocks).subspan(first, end - first), order[group], after[group]);
  }
  rows.position_radius = moved(rows.position_radius, new_row, position_radius_size);
  rows.velocity_spin = moved(rows.velocity_spin, new_row, velocity_spin_size);
  if (rows.oriented()) rows.orientation = moved(rows.orientation, new_row, quaternion_size);
  order = std::move(after);
  ++sort_count;
  part_pieces();
  for (std::int64_t& row : parted) row = new_row[row];
  contacts.reorder_rows(new_row, rows, time(), pool);
  displacement_budget = 0.5 * contacts.skin();
  held.locate(*this);
}

}  // namespace fiberchain::dem
