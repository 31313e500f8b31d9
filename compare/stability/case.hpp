#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/stability/run.hpp"
#include "compare/study/jobs.hpp"

// The largest stable step of a chain: theory of the endless and of the finite chain, measurement, and the
// paper's rules.
namespace fiberchain::compare {

/// In units of t_b the limit depends on nothing but these. The fiber is the nominal one.
struct StabilityCase {
  int aspect_ratio = 10;
  double poisson_ratio = 0.3;
  double bond_damping = 1;
  dem::BondModel bond = dem::BondModel::paper;
  dem::Integrator scheme = dem::Integrator::leapfrog;
  reference::ChainEnds ends = reference::ChainEnds::clamped_free;
  int dimension = 2;
  dem::BondForm form = dem::BondForm::incremental;
};

struct StabilityPoint {
  StabilityCase asked;
  double endless;                 ///< limit of the endless chain over t_b, spectral radius by wave number
  double modes;                   ///< of this chain over t_b, by its modes
  double measured;                ///< by running it: middle of the bracket
  double half_width;              ///< half the bracket over t_b
  double difference;              ///< measured / modes - 1
  double quarter_growth;          ///< largest |z| of a mode at 0.25 t_b: 1 if stable
  std::string bond_time_verdict;  ///< what a run at t_b does: stable or unstable
  std::string quarter_verdict;    ///< the same at 0.25 t_b
  double steps;                   ///< time steps marched for all this
  std::string status;
};

struct StabilityOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// The scheme in the reference's words. Throws InputError for one that is none of the leapfrogs.
reference::TimeScheme time_scheme(dem::Integrator scheme);

/// Whether the scheme grows beyond a step: leapfrog and leapfrog_damped do.
bool has_stable_step(dem::Integrator scheme);

/// The case as it is run.
StabilityRun run_of(const StabilityCase& asked);

/// Throws InputError or dem::InvalidInput for a case out of range.
void check(const StabilityCase& asked);

/// The fiber of a case.
dem::Fiber stability_fiber(const StabilityCase& asked);

/// Limit over t_b of the finite chain by its modes.
double modal_limit(const StabilityCase& asked);

/// Limit over t_b of the endless chain by its waves.
double endless_limit(const StabilityCase& asked);

/// Every case in the order given. Throws InputError or dem::InvalidInput for a case out of range, or of a
/// scheme without a stable step.
std::vector<StabilityPoint> stability_points(const std::vector<StabilityCase>& cases,
                                             const StabilityOptions& options = {});

}  // namespace fiberchain::compare
