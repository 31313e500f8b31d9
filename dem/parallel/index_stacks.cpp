#include "dem/parallel/index_stacks.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::uint64_t kChange = std::uint64_t{1} << 32;

std::uint32_t top_of(std::uint64_t word) { return static_cast<std::uint32_t>(word); }

std::uint64_t changed_to(std::uint64_t word, std::uint32_t top) {
  return (word & ~(kChange - 1)) + kChange + top;
}

}  // namespace

void IndexStacks::push(int stack, int index) {
  std::atomic<std::uint64_t>& head = heads_[stack].word;
  const std::uint32_t top = static_cast<std::uint32_t>(index) + 1;
  std::uint64_t word = head.load(std::memory_order_relaxed);
  do {
    below_[index].store(top_of(word), std::memory_order_relaxed);
  } while (!head.compare_exchange_weak(word, changed_to(word, top), std::memory_order_acq_rel,
                                       std::memory_order_relaxed));
}

int IndexStacks::pop(int stack) {
  std::atomic<std::uint64_t>& head = heads_[stack].word;
  std::uint64_t word = head.load(std::memory_order_acquire);
  while (top_of(word) != 0) {
    const std::uint32_t below = below_[top_of(word) - 1].load(std::memory_order_relaxed);
    if (head.compare_exchange_weak(word, changed_to(word, below), std::memory_order_acq_rel,
                                   std::memory_order_acquire)) {
      return static_cast<int>(top_of(word)) - 1;
    }
  }
  return -1;
}

}  // namespace fiberchain::dem
