#pragma once

#include <functional>
#include <vector>

// Wall-clock time of short computations: warm, repeated, the least taken. The median says how quiet the
// machine was.
namespace fiberchain::compare {

struct Timing {
  double least = 0;   ///< [s]
  double median = 0;  ///< [s]
  int runs = 0;
};

struct TimingBudget {
  double seconds = 0.5;  ///< no further run is begun after this
  int least_runs = 2;
  int most_runs = 15;
  double long_run = 2;  ///< [s]; a first run longer than this is the only one
};

/// Times runs of `work`, which the caller has run before, so that caches and clocks are warm. What takes less
/// than 50 microseconds is repeated within a run.
Timing time_warm(const std::function<void()>& work, const TimingBudget& budget);

/// Time of one run [s].
double time_once(const std::function<void()>& work);

/// The same for several computations in turns, so that a disturbance of the machine meets all of them: ratios
/// of the results are of one run. Each is run once before.
std::vector<Timing> time_in_turns(const std::vector<std::function<void()>>& works,
                                  const TimingBudget& budget_each);

}  // namespace fiberchain::compare
