#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/packing/case.hpp"
#include "dem/record/table.hpp"

// Figs 11 and 12: the packings of the paper, how they differ, and how much of that is the seed's.
namespace fiberchain::compare {

/// What is run.
struct PackingPlan {
  int fibers = 2000;        ///< of the packings of the first seed, drawn and tabled one by one; 0: none
  int seeds = 3;            ///< of the smaller packings, from which spreads come; 0: none
  int spread_fibers = 500;  ///< of those; as deep, on a smaller floor with periodic sides
  double duration = kPackingDuration;            ///< simulated [s]
  int samples = 140;                             ///< intervals of the histories
  std::vector<double> bond_dampings{0.1, 1, 5};  ///< xi_b, each without rolling friction
  std::vector<double> rolling_frictions{1, 2};   ///< xi_r, each at the first xi_b
  std::vector<double> stiffnesses{20};  ///< likewise: bends next to nothing, at a step that can still be paid
};

/// The packings of one seed. The first is that of Fig 11: pictures are kept and energy is accounted.
std::vector<PackingCase> figure_cases(const PackingPlan& plan);
/// The same of more seeds, not accounted, and those of the first at half the step.
std::vector<PackingCase> spread_cases(const PackingPlan& plan);

/// Runs that differ in nothing but the seed.
struct SeedGroup {
  PackingCase asked;  ///< with the first seed
  std::vector<const PackingRun*> runs;
};
std::vector<SeedGroup> seed_groups(const std::vector<PackingRun>& runs);

/// Bending parts over the seeds of a group; runs that did not finish are left out.
struct BendingSpread {
  Spread peak, trough, plateau;
};
BendingSpread bending_spread(const SeedGroup& group);

/// Difference a - b of a part of Fig 12 between runs of the same seed. Throws InputError if they share none.
Spread paired_difference(const SeedGroup& a, const SeedGroup& b, double BendingParts::*part);

// Tables.
dem::Table run_table(const std::vector<PackingRun>& runs);          ///< a row a run
dem::Table stage_table(const std::vector<PackingRun>& runs);        ///< a row a run and stage
dem::Table spread_table(const std::vector<PackingRun>& runs);       ///< a row a group of seeds
dem::Table history_table(const std::vector<PackingRun>& runs);      ///< a row a run and sample
dem::Table density_table(const std::vector<PackingRun>& runs);      ///< a row a run and slab, at rest
dem::Table orientation_table(const std::vector<PackingRun>& runs);  ///< a row a run and class of angles
dem::Table energy_table(const PackingRun& accounted);               ///< a row a sample
dem::Table comparison_table(
    const std::vector<PackingRun>& runs);  ///< a row a group: less the first, seed by seed

/// By the name of their files.
std::vector<std::pair<std::string, Figure>> packing_figures(const std::vector<PackingRun>& figure_runs,
                                                            const std::vector<PackingRun>& spread_runs);

/// Largest departure of the total energy from that at the start, over what the fall has given. Throws
/// InputError if energy is not accounted.
double energy_drift(const PackingRun& accounted);

/// "xi_b = 1, xi_r = 0", with the stiffness where it is not 1.
std::string label_of(const PackingCase& asked);

/// What the runs say, as Markdown.
std::string packing_notes(const std::vector<PackingRun>& figure_runs,
                          const std::vector<PackingRun>& spread_runs);

}  // namespace fiberchain::compare
