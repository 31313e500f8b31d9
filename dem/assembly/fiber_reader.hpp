#pragma once

#include <exception>
#include <mutex>
#include <vector>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/fiber_block.hpp"

namespace fiberchain::dem {

/// Reads the fibers of a block as they are now, one after the other, into memory of its own that it keeps.
class FiberReader {
 public:
  explicit FiberReader(const Assembly::State& all) : all_(all), gradient_(all.gradient_now()) {}

  void take(const FiberBlock& block);
  /// Velocities of this moment. Orientations stand as they are: not followed, they mean nothing.
  const ChainState<3>& read(int lane);
  /// The fiber read last.
  const ChainState<3>& state() const { return state_; }
  /// Bonds of the fiber read last, which is that of `lane`.
  const std::vector<BondState>& bonds(int lane);
  /// History of a bond now, its numbers the kernel's width apart.
  const double* history(int lane, int bond) const {
    return kind_->history_of(now_.history.data(), lane, bond);
  }

 private:
  const Assembly::State& all_;
  Gradient gradient_;
  const FiberBlock* block_ = nullptr;
  const GroupKind* kind_ = nullptr;
  BlockSnapshot now_;
  ChainState<3> state_;
  std::vector<BondState> bonds_;
  std::vector<MovingSphere<double, 3>> spheres_;  ///< of a fiber that is held
};

/// work(block, reader) for all blocks from `from` to before `to`, on all threads of the assembly, each with
/// a reader of its own.
/// @throws the first exception of the work
template <class Work>
void for_blocks(Assembly::State& s, int from, int to, const Work& work) {
  std::vector<FiberReader> readers;
  for (int t = 0; t < s.pool.threads(); ++t) readers.emplace_back(s);
  std::exception_ptr error;
  std::mutex mutex;
  s.pool.parallel_for(to - from, [&](int n, int thread) {
    try {
      work(from + n, readers[thread]);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  });
  if (error) std::rethrow_exception(error);
}

}  // namespace fiberchain::dem
