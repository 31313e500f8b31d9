#include "dem/assembly/contact_memory.hpp"

#include <algorithm>

namespace fiberchain::dem {

void ContactMemory::reset(std::size_t size) {
  touched.assign(size, 0);
  if (rows.size() < size * memory_numbers) rows = LaneArray(2 * size * memory_numbers);
  if (booked && work.size() < size * work_numbers) work = LaneArray(2 * size * work_numbers);
}

void ContactMemory::carry(std::size_t i, const ContactMemory& from, std::size_t p) {
  if (from.touched[p] == 0) return;
  touched[i] = 1;
  std::copy_n(from.rows.data() + p * memory_numbers, memory_numbers, rows.data() + i * memory_numbers);
  if (booked) std::copy_n(from.work.data() + p * work_numbers, work_numbers, work.data() + i * work_numbers);
}

KeptContact ContactMemory::at(std::size_t i, std::int64_t first, std::int64_t second) const {
  const double* n = rows.data() + i * memory_numbers;
  KeptContact contact{first, second, {n[0], n[1], n[2]}, n[3], n[4]};
  if (booked) std::copy_n(work.data() + i * work_numbers, work_numbers, contact.work);
  return contact;
}

void ContactMemory::put(std::size_t i, const KeptContact& c) {
  double* n = rows.data() + i * memory_numbers;
  for (int k = 0; k < 3; ++k) n[k] = c.spring[k];
  n[3] = c.root, n[4] = c.opening;
  if (booked) std::copy_n(c.work, work_numbers, work.data() + i * work_numbers);
  touched[i] = 1;
}

}  // namespace fiberchain::dem
