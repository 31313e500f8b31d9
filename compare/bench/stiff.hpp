#pragma once

#include <string>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

// What bonds solved for within the step cost and save: releases, and the step of a packing.
namespace fiberchain::compare {

/// xi_f of the first mode, and the free end's path after a load PL^2/EI = 0.5 is gone, by the leapfrogs
/// alone; r_f = 10, 20, 50, 100 (quick: 10 and 20).
std::vector<PrecisionProblem> stiff_release_problems(const BenchOptions& options);

/// Their rows by the time of a period, beside that of the explicit leapfrog at its largest step.
dem::Table release_time_table(const std::vector<PrecisionProblem>& problems);

/// A sphere-step of a packing by one scheme at the step that it chooses, one thread.
struct StiffStepTime {
  double bond_damping;  ///< xi_b
  std::string bed;      ///< "falling" or "stack"
  dem::Integrator integrator;
  double step, step_ratio;         ///< dt [s], and over t_b
  double contacts_a_sphere;        ///< at the end
  double bonds, contacts, search;  ///< [ns]; bonds with the motion
  double slice;                    ///< simulated by the steps that were measured [s]
  double scene_time;               ///< [s] that the whole scene takes at that cost, extrapolated

  double all() const { return bonds + contacts + search; }
};

/// `scene` by the explicit leapfrog and leapfrog-stiff, window by window in turns, for xi_b = 0.1 and 1: from
/// its own start, where no fibers touch, and as a stack of parallel fibers between tight walls, each sphere
/// in four contacts. Bonds and contacts are those of the fastest window, the search the mean of all.
std::vector<StiffStepTime> stiff_step_times(const dem::PackingScene& scene, const BenchOptions& options);

/// With cost and gain over the explicit scheme in the same bed.
dem::Table stiff_step_table(const std::vector<StiffStepTime>& times);

}  // namespace fiberchain::compare
