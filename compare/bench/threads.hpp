#pragma once

#include <string>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::compare {

/// A scene's step on a number of threads.
struct ThreadRow {
  std::string scene;
  std::int64_t spheres;
  int threads;
  double measured;  ///< a step [s]; not a number beyond two threads
  double modeled;   ///< [s]; the first scene's on two threads is what the model is fixed on
  double speedup;   ///< one thread's over `modeled`
  double start, dependencies, end,
      serial;  ///< idle, over all of the threads' time; not numbers where not measured
};

struct NamedScene {
  std::string name;
  dem::PackingScene scene;
};

/// Every scene on one thread and on two, window by window in turns; the model of the schedule
/// (schedule_model.hpp) is fixed on the first scene and says what two, 4, 16 and 64 give on each.
std::vector<ThreadRow> thread_times(const std::vector<NamedScene>& scenes, const BenchOptions& options);

dem::Table thread_table(const std::vector<ThreadRow>& rows);

}  // namespace fiberchain::compare
