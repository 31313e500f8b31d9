#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/study/jobs.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

// A small packing of steel fibers in full, explicit and with bonds solved for within steps of several
// lengths: what the step changes in the packing at rest, beside what the seed does.
namespace fiberchain::compare {

/// What is run. The usual one is data/scenes/steel-wool.yaml with fewer fibers on a smaller floor.
struct StiffPackingPlan {
  int fibers = 100;
  int seeds = 3;
  std::vector<double> step_ratios{10, 25, 50, 80, 120};  ///< dt / t_b of leapfrog-stiff
  double bond_damping = 0.1;                             ///< xi_b
  double side = 0.5e-3;                                  ///< of the square floor [m]
  double height = 0.8e-3;                                ///< that fibers fall from, at most [m]
  double duration = 0.02;                                ///< of the fall and the coming to rest [s]
};

/// One packing at rest.
struct RestingPacking {
  dem::Integrator integrator;
  double step_ratio;  ///< dt / t_b
  std::uint64_t seed;
  double step = 0;  ///< [s]
  double solid_fraction = 0, coordination = 0;
  double bending = 0;  ///< of a bond, mean over the last fifth of the time [rad]
  double overlap_mean = 0, overlap_peak = 0;
  double run_time = 0;      ///< [s]
  std::string status = {};  ///< "finished", or why not
};

/// Explicit at the step it chooses first, then each step of leapfrog-stiff; every seed.
std::vector<RestingPacking> resting_packings(const StiffPackingPlan& plan, const Jobs& jobs);

/// A row a run.
dem::Table resting_table(const std::vector<RestingPacking>& runs);

/// A row for each observable and step: mean and spread over the seeds, and how far it is off the explicit
/// scheme's in units of the larger spread. Runs that did not finish are left out.
dem::Table step_effect_table(const std::vector<RestingPacking>& runs);

}  // namespace fiberchain::compare
