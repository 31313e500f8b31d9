#include "dem/assembly/fiber_order.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "dem/contact/linked_cell_list.hpp"
#include "dem/math/hilbert_curve.hpp"
#include "dem/model/errors.hpp"
#include "dem/parallel/partition.hpp"

namespace fiberchain::dem {
namespace {

std::vector<std::int32_t> rising_numbers(std::size_t count) {
  std::vector<std::int32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::uint64_t place_on_curve(const Vec<double, 3>& point, const Vec<double, 3>& low, double cell) {
  constexpr double most = (1 << hilbert_bits) - 1;
  std::array<std::uint32_t, 3> at{};
  for (int c = 0; c < 3; ++c)
    at[c] = static_cast<std::uint32_t>(std::clamp((point[c] - low[c]) / cell, 0.0, most));
  return hilbert_index(at);
}

}  // namespace

FiberOrder::FiberOrder(std::int32_t fibers)
    : fiber_(rising_numbers(static_cast<std::size_t>(fibers))), place_(fiber_) {}

FiberOrder::FiberOrder(std::vector<std::int32_t> fiber_of_place)
    : fiber_(std::move(fiber_of_place)), place_(fiber_.size(), -1) {
  for (std::int32_t place = 0; place < count(); ++place) {
    const std::int32_t fiber = fiber_[place];
    if (fiber < 0 || fiber >= count() || place_[fiber] >= 0)
      throw InvalidInput(fmt::format("an order of {} fibers with {} at place {} is not allowed: each once",
                                     count(), fiber, place));
    place_[fiber] = place;
  }
}

bool is_worth_sorting(std::int64_t spheres) { return spheres > 2 * cache_sized_part; }

FiberOrder order_in_space(std::vector<Vec<double, 3>> middles, const Vec<double, 3>& period) {
  if (middles.empty()) return {};
  for (Vec<double, 3>& x : middles) {
    for (int c = 0; c < 3; ++c) {
      if (period[c] > 0) x[c] -= period[c] * std::floor(x[c] / period[c]);
    }
  }
  const Box box = box_around(middles);
  const Vec<double, 3> sides = box.high - box.low;
  const double longest = std::max({sides[0], sides[1], sides[2], 1e-300});
  std::vector<std::uint64_t> on_curve;
  for (const Vec<double, 3>& x : middles)
    on_curve.push_back(place_on_curve(x, box.low, longest / ((1 << hilbert_bits) - 1)));
  std::vector<std::int32_t> fibers = rising_numbers(middles.size());
  std::ranges::stable_sort(fibers, {}, [&](std::int32_t fiber) { return on_curve[fiber]; });
  return FiberOrder(std::move(fibers));
}

}  // namespace fiberchain::dem
