#include "compare/bench/schedule_model.hpp"

#include <algorithm>
#include <utility>

#include "dem/parallel/wavefront_schedule.hpp"

namespace fiberchain::compare {
namespace {

constexpr double open = -1;  ///< not taken by any thread

/// The wave through all parts, event by event: the thread whose time is earliest acts next.
class Wave {
 public:
  Wave(const std::vector<dem::PartTimes>& parts, int threads)
      : parts_(parts),
        reach_(reached_by(parts)),
        first_end_(parts.size(), open),
        moved_(parts.size(), false) {
    for (int thread = 0; thread < threads; ++thread)
      threads_.push_back({0, turns(thread, threads), 0, {}, -1});
  }

  /// When the last thread has nothing left [s].
  double end() {
    double last = 0;
    while (Thread* next = earliest()) act(*next);
    for (const Thread& thread : threads_) last = std::max(last, thread.time);
    return last;
  }

 private:
  struct Thread {
    double time;
    std::vector<int> turns;  ///< parts in the order of its looking at them
    std::size_t turn;
    std::vector<int> firsts;  ///< contacts that its part still needs, the next one last
    int part;                 ///< that it has taken; -1: none
  };

  static dem::PartDependencies reached_by(const std::vector<dem::PartTimes>& parts) {
    std::vector<std::vector<int>> reached;
    for (const dem::PartTimes& part : parts) reached.push_back(part.reached);
    return dem::PartDependencies(std::move(reached));
  }

  std::vector<int> turns(int thread, int threads) const {
    std::vector<int> all;
    dem::each_turn(static_cast<int>(parts_.size()), thread, threads, [&](int k) { all.push_back(k); });
    return all;
  }

  Thread* earliest() {
    Thread* next = nullptr;
    for (Thread& thread : threads_) {
      const bool done = thread.part < 0 && thread.turn == thread.turns.size();
      if (!done && (next == nullptr || thread.time < next->time)) next = &thread;
    }
    return next;
  }

  void act(Thread& thread) {
    if (thread.part < 0) return take(thread);
    while (!thread.firsts.empty()) {
      const int k = thread.firsts.back();
      thread.firsts.pop_back();
      if (first_end_[k] != open) continue;
      thread.time = first_end_[k] = thread.time + parts_[k].contacts;
      return;
    }
    double begin = std::max(thread.time, first_end_[thread.part]);
    for (const int before : reach_.dependencies(thread.part)) begin = std::max(begin, first_end_[before]);
    thread.time = begin + parts_[thread.part].bonds_and_motion;
    thread.part = -1;
  }

  void take(Thread& thread) {
    const int k = thread.turns[thread.turn++];
    if (moved_[k]) return;
    moved_[k] = true;
    thread.part = k;
    thread.firsts = reach_.dependencies(k);  // the latest part before it comes first, after its own
    thread.firsts.push_back(k);
  }

  const std::vector<dem::PartTimes>& parts_;
  dem::PartDependencies reach_;
  std::vector<double> first_end_;
  std::vector<bool> moved_;
  std::vector<Thread> threads_;
};

}  // namespace

double modeled_step(const StepWork& work, int threads, const SharingCosts& costs) {
  const double wave = Wave(work.parts, threads).end();
  if (threads == 1) return wave + work.search + work.serial;
  return costs.slowdown * (wave + work.search / threads) + work.serial + costs.meeting;
}

}  // namespace fiberchain::compare
