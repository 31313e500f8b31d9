#pragma once

#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/packing/case.hpp"
#include "dem/record/table.hpp"

// What softened contacts change: packings of stiff fibers whose contacts have a lower modulus than their
// bonds, with the spread of seeds beside it.
namespace fiberchain::compare {

/// What is run. Fibers stiff enough that bending under their weight is small, as of metal, glass and wood.
struct SofteningPlan {
  std::vector<double> moduli{1, 0.1, 0.01,
                             0.001};  ///< of contacts over the fibers', the first one compared with
  double stiffness = 100;             ///< of the fibers: factor to Young's modulus of `tables packing`
  int fibers = 300;
  int seeds = 3;
  double duration = kPackingDuration;  ///< simulated [s]
  int samples = 60;                    ///< intervals of the histories
};

/// Seed by seed for each modulus, between periodic sides, half as deep as `tables packing`.
std::vector<PackingCase> softening_cases(const SofteningPlan& plan);

/// A row a modulus: means over the seeds, and standard deviations of one run; the overlaps are the largest of
/// the seeds. A modulus none of whose runs finished is left out.
dem::Table softening_table(const std::vector<PackingRun>& runs);

/// Solid fraction, coordination and bending of every run over the means at the first modulus.
Figure softening_figure(const std::vector<PackingRun>& runs);

}  // namespace fiberchain::compare
