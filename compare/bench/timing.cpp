#include "compare/bench/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace fiberchain::compare {
namespace {

constexpr double shortest_run = 50e-6;  // [s]: a thousand ticks of the clock
constexpr int most_repetitions = 100000;

double seconds_of(const std::function<void()>& work, int repetitions) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < repetitions; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / repetitions;
}

/// One computation being timed.
struct Clocked {
  const std::function<void()>* work;
  int repetitions;
  double spent;
  std::vector<double> seconds;

  Clocked(const std::function<void()>& what, double once)
      : work(&what),
        repetitions(std::clamp(static_cast<int>(std::ceil(shortest_run / std::max(once, 1e-9))), 1,
                               most_repetitions)),
        spent(0) {}

  bool done(const TimingBudget& budget) const {
    const int runs = static_cast<int>(seconds.size());
    return runs >= budget.least_runs && (spent > budget.seconds || runs >= budget.most_runs);
  }

  void run() {
    seconds.push_back(seconds_of(*work, repetitions));
    spent += seconds.back() * repetitions;
  }

  Timing timing() {
    std::ranges::sort(seconds);
    const std::size_t n = seconds.size();
    const double median = n % 2 ? seconds[n / 2] : (seconds[n / 2 - 1] + seconds[n / 2]) / 2;
    return {seconds[0], median, static_cast<int>(n)};
  }
};

}  // namespace

double time_once(const std::function<void()>& work) { return seconds_of(work, 1); }

Timing time_warm(const std::function<void()>& work, const TimingBudget& budget) {
  Clocked first(work, shortest_run);
  first.run();
  Clocked clocked(work, first.seconds[0]);
  // a run as long as a timed one is as good as one
  if (clocked.repetitions == 1) clocked.seconds = first.seconds, clocked.spent = first.spent;
  while (!clocked.done(budget)) clocked.run();
  return clocked.timing();
}

std::vector<Timing> time_in_turns(const std::vector<std::function<void()>>& works,
                                  const TimingBudget& budget_each) {
  std::vector<Clocked> all;
  for (const auto& work : works) {
    seconds_of(work, 1);
    all.emplace_back(work, seconds_of(work, 1));
  }
  const auto unfinished = [&](const Clocked& c) { return !c.done(budget_each); };
  while (std::ranges::any_of(all, unfinished)) {
    for (Clocked& clocked : all) clocked.run();
  }
  std::vector<Timing> timings;
  for (Clocked& clocked : all) timings.push_back(clocked.timing());
  return timings;
}

}  // namespace fiberchain::compare
