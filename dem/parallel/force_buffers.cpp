#include "dem/parallel/force_buffers.hpp"

#include <algorithm>

#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {

ForceBuffers::ForceBuffers(const Partition& parts, int threads)
    : parts_(parts),
      rows_(parts.count(), nullptr),
      buffer_(parts.count(), -1),
      free_(threads + 1, parts.count()),
      threads_(threads),
      arrays_(parts.count()) {
  for (int k = parts_.count() - 1; k >= 0; --k) {
    size_ = std::max(size_, static_cast<std::size_t>(parts_.end(k) - parts_.begin(k)) * load_size);
    free_.push(threads_, k);
  }
}

/// From the thread's own stack, else another thread's, else a new one.
int ForceBuffers::free_buffer(int thread) {
  while (true) {  // there are as many buffers as parts: one is free, though it may change stacks during the
                  // search
    for (int k = 0; k < threads_; ++k) {
      if (const int buffer = free_.pop((thread + k) % threads_); buffer >= 0) return buffer;
    }
    if (const int buffer = free_.pop(threads_); buffer >= 0) {
      arrays_[buffer] = LaneArray(size_);
      return buffer;
    }
  }
}

LoadRange ForceBuffers::take(int part, int thread) {
  if (rows_[part] == nullptr) {
    buffer_[part] = free_buffer(thread);
    rows_[part] = arrays_[buffer_[part]].data();
  }
  return of(part);
}

void ForceBuffers::give_back(int part, int thread) {
  rows_[part] = nullptr;
  free_.push(thread, buffer_[part]);
}

std::vector<double> ForceBuffers::all() const {
  std::vector<double> numbers;
  if (parts_.count() > 0)
    numbers.reserve(static_cast<std::size_t>(parts_.end(parts_.count() - 1)) * load_size);
  for (int k = 0; k < parts_.count(); ++k) {
    const double* own = rows_[k];
    numbers.insert(numbers.end(), own,
                   own + static_cast<std::ptrdiff_t>(parts_.end(k) - parts_.begin(k)) * load_size);
  }
  return numbers;
}

void ForceBuffers::set(const double* numbers, std::size_t count) {
  for (int k = 0; k < parts_.count(); ++k) {
    const std::size_t begin = static_cast<std::size_t>(parts_.begin(k)) * load_size,
                      end = static_cast<std::size_t>(parts_.end(k)) * load_size;
    double* own = take(k, 0).rows;
    std::copy(numbers + std::min(begin, count), numbers + std::min(end, count), own);
  }
}

}  // namespace fiberchain::dem
