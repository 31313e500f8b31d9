#include "dem/assembly/stripe_loads.hpp"

#include <algorithm>

#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

StripeLoads::StripeLoads(const Stripes& stripes, int threads)
    : stripes_(stripes), rows_(stripes.count(), nullptr), free_(threads), mutex_(std::make_unique<std::mutex>()) {
  for (int k = 0; k < stripes_.count(); ++k) {
    size_ = std::max(size_, static_cast<std::size_t>(stripes_.end(k) - stripes_.begin(k)) * load_numbers);
  }
}

LoadRange StripeLoads::take(int stripe, int thread) {
  if (rows_[stripe] == nullptr) {
    const std::lock_guard lock(*mutex_);
    std::vector<double*>* from = &free_[thread];
    if (from->empty()) from = &*std::ranges::max_element(free_, {}, &std::vector<double*>::size);
    if (from->empty()) from->push_back(arrays_.emplace_back(size_).data());
    rows_[stripe] = from->back();
    from->pop_back();
  }
  return of(stripe);
}

void StripeLoads::give_back(int stripe, int thread) {
  const std::lock_guard lock(*mutex_);
  free_[thread].push_back(rows_[stripe]);
  rows_[stripe] = nullptr;
}

std::vector<double> StripeLoads::all() const {
  std::vector<double> numbers;
  for (int k = 0; k < stripes_.count(); ++k) {
    const double* own = rows_[k];
    numbers.insert(numbers.end(), own, own + static_cast<std::ptrdiff_t>(stripes_.end(k) - stripes_.begin(k)) * load_numbers);
  }
  return numbers;
}

void StripeLoads::set(const double* numbers, std::size_t count) {
  for (int k = 0; k < stripes_.count(); ++k) {
    const std::size_t begin = static_cast<std::size_t>(stripes_.begin(k)) * load_numbers, end = static_cast<std::size_t>(stripes_.end(k)) * load_numbers;
    double* own = take(k, 0).rows;
    std::copy(numbers + std::min(begin, count), numbers + std::min(end, count), own);
  }
}

}  // namespace fiberchain::dem
