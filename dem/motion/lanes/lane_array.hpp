#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "dem/motion/lanes/kernel.hpp"

namespace fiberchain::dem {

/// Doubles that a value type consists of.
template <class Value>
inline constexpr std::size_t numbers_of = sizeof(Value) / sizeof(double);

/// Array of doubles, aligned for every instruction set.
class LaneArray {
 public:
  LaneArray() = default;
  explicit LaneArray(std::size_t size)
      : data_(static_cast<double*>(::operator new[](std::max<std::size_t>(size, 1) * sizeof(double),
                                                    std::align_val_t{lane_alignment}))),
        size_(size) {
    std::fill_n(data_.get(), size, 0.0);
  }

  std::size_t size() const { return size_; }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

  /// Copies the doubles of `value` to every `stride`th place from `first` on.
  template <class Value>
  void put(const Value& value, std::size_t first, std::size_t stride) {
    const double* source = reinterpret_cast<const double*>(&value);
    for (std::size_t n = 0; n < sizeof(Value) / sizeof(double); ++n) data_[first + n * stride] = source[n];
  }

  template <class Value>
  void get(Value& value, std::size_t first, std::size_t stride) const {
    double* target = reinterpret_cast<double*>(&value);
    for (std::size_t n = 0; n < sizeof(Value) / sizeof(double); ++n) target[n] = data_[first + n * stride];
  }

 private:
  struct Free {
    void operator()(double* p) const { ::operator delete[](p, std::align_val_t{lane_alignment}); }
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace fiberchain::dem
