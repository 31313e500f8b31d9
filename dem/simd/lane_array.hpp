#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

#include "dem/simd/as_numbers.hpp"

namespace fiberchain::dem {

/// Alignment of the arrays that suits every instruction set [bytes].
inline constexpr int lane_alignment = 64;

/// Array of doubles, aligned for every instruction set.
class LaneArray {
 public:
  LaneArray() = default;
  explicit LaneArray(std::size_t size) : data_(take(size)), size_(size) {
    std::fill_n(data_.get(), size, 0.0);
  }

  /// The same numbers in memory of its own.
  LaneArray copy() const {
    LaneArray other(size_);
    std::copy_n(data(), size_, other.data());
    return other;
  }

  std::size_t size() const { return size_; }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

  /// Copies the doubles of `value` to every `stride`th place from `first` on.
  template <class Value>
  void put(const Value& value, std::size_t first, std::size_t stride) {
    put_strided(value, data() + first, stride);
  }

  template <class Value>
  void get(Value& value, std::size_t first, std::size_t stride) const {
    value = get_strided<Value>(data() + first, stride);
  }

 private:
  /// Arrays of a quarter of it [bytes] and more get whole large pages, so that walking through them does not
  /// wait for page tables.
  static constexpr std::size_t large_page = std::size_t{1} << 21;

  static double* take(std::size_t size) {
    const std::size_t bytes = std::max<std::size_t>(size, 1) * sizeof(double);
    const std::size_t alignment = 4 * bytes >= large_page ? large_page : lane_alignment;
    void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == large_page)
      madvise(memory, (bytes + alignment - 1) / alignment * alignment,
              MADV_HUGEPAGE);  // a wish: nothing is lost where it is not met
#endif
    return static_cast<double*>(memory);
  }

  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace fiberchain::dem
