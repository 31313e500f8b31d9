#include "dem/assembly/contact_memory.hpp"

#include <algorithm>

namespace fiberchain::dem {
namespace {

LaneArray grown(const LaneArray& from, std::size_t size) {
  LaneArray larger(size);
  std::copy_n(from.data(), from.size(), larger.data());
  return larger;
}

}  // namespace

void ContactMemory::reset() {
  free_count = 0;
  for (auto number = static_cast<std::int32_t>(free.size()) - 1; number > 0; --number) give_back(number);
}

void ContactMemory::make_room(std::size_t numbers) {
  const auto there = static_cast<std::size_t>(free_count);
  if (there >= numbers && !free.empty()) return;
  const std::size_t before = std::max<std::size_t>(free.size(), 1), after = before + (numbers - there) + numbers / 4 + 16;
  rows = grown(rows, after * memory_numbers);
  if (booked) work = grown(work, after * work_numbers);
  free.resize(after);
  for (std::size_t number = after - 1; number >= before; --number) give_back(static_cast<std::int32_t>(number));
}

KeptContact ContactMemory::at(std::int32_t number, std::int64_t first, std::int64_t second) const {
  const double* n = rows.data() + static_cast<std::ptrdiff_t>(number) * memory_numbers;
  KeptContact contact{first, second, {n[0], n[1], n[2]}, n[3], n[4], n[5]};
  if (booked) std::copy_n(work.data() + static_cast<std::ptrdiff_t>(number) * work_numbers, work_numbers, contact.work);
  return contact;
}

void ContactMemory::put(std::int32_t number, const KeptContact& c) {
  double* n = rows.data() + static_cast<std::ptrdiff_t>(number) * memory_numbers;
  for (int k = 0; k < 3; ++k) n[k] = c.spring[k];
  n[3] = c.root, n[4] = c.opening, n[5] = c.rolling_power;
  if (booked) std::copy_n(c.work, work_numbers, work.data() + static_cast<std::ptrdiff_t>(number) * work_numbers);
}

}  // namespace fiberchain::dem
