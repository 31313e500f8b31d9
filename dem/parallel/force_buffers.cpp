#include "dem/parallel/force_buffers.hpp"

#include <algorithm>

#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {

ForceBuffers::ForceBuffers(const Partition& parts, int threads)
    : parts_(parts), rows_(parts.count(), nullptr), free_(threads), mutex_(std::make_unique<std::mutex>()) {
  for (int k = 0; k < parts_.count(); ++k) {
    size_ = std::max(size_, static_cast<std::size_t>(parts_.end(k) - parts_.begin(k)) * load_size);
  }
}

LoadRange ForceBuffers::take(int part, int thread) {
  if (rows_[part] == nullptr) {
    const std::lock_guard lock(*mutex_);
    std::vector<double*>* from = &free_[thread];
    if (from->empty()) from = &*std::ranges::max_element(free_, {}, &std::vector<double*>::size);
    if (from->empty()) from->push_back(arrays_.emplace_back(size_).data());
    rows_[part] = from->back();
    from->pop_back();
  }
  return of(part);
}

void ForceBuffers::give_back(int part, int thread) {
  const std::lock_guard lock(*mutex_);
  free_[thread].push_back(rows_[part]);
  rows_[part] = nullptr;
}

std::vector<double> ForceBuffers::all() const {
  std::vector<double> numbers;
  for (int k = 0; k < parts_.count(); ++k) {
    const double* own = rows_[k];
    numbers.insert(numbers.end(), own, own + static_cast<std::ptrdiff_t>(parts_.end(k) - parts_.begin(k)) * load_size);
  }
  return numbers;
}

void ForceBuffers::set(const double* numbers, std::size_t count) {
  for (int k = 0; k < parts_.count(); ++k) {
    const std::size_t begin = static_cast<std::size_t>(parts_.begin(k)) * load_size, end = static_cast<std::size_t>(parts_.end(k)) * load_size;
    double* own = take(k, 0).rows;
    std::copy(numbers + std::min(begin, count), numbers + std::min(end, count), own);
  }
}

}  // namespace fiberchain::dem
