#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace fiberchain::dem {

/// Stacks of the indices 0, 1, ..., each of which lies on one of them at most. Any thread pushes and pops
/// without a lock.
class IndexStacks {
 public:
  IndexStacks() = default;
  IndexStacks(int stacks, int indices) : heads_(stacks), below_(indices) {}

  /// What was written to the thing of that index before is visible to the thread that pops it.
  void push(int stack, int index);
  /// The index pushed last; -1 if there is none.
  int pop(int stack);

 private:
  /// Index + 1 of the top, 0 of an empty stack, in the low half. The high half counts the changes: a top that
  /// was popped and pushed again in between differs (ABA problem).
  struct alignas(64) Head {
    std::atomic<std::uint64_t> word{0};
  };
  std::vector<Head> heads_;
  std::vector<std::atomic<std::uint32_t>>
      below_;  ///< of each index: index + 1 of the one below it, 0 at the bottom
};

}  // namespace fiberchain::dem
