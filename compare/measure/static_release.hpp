#pragma once

#include <optional>
#include <vector>

#include "compare/measure/peaks.hpp"
#include "compare/study/jobs.hpp"
#include "dem/model/fiber.hpp"
#include "dem/motion/physics.hpp"

// Damping as the paper measures it: the chain under a dead load at its free end, in equilibrium, let go.
namespace fiberchain::compare {

struct StaticReleaseRequest {
  dem::Fiber fiber;              ///< damped
  double load;                   ///< P L^2 / (E I)
  std::vector<PeakRange> peaks;  ///< each gives one xi_f from the same motion
  dem::BondForm form = dem::BondForm::incremental;
  std::optional<double> step_ratio = std::nullopt;  ///< dt / t_b; as dem::ReleaseOptions
};

struct StaticReleaseResult {
  std::vector<Damping> damping;  ///< one for each range of peaks asked for
  TipHistory history;            ///< of the free end across the fiber: y over L, time in seconds
};

/// The free end of every chain after its release, and its damping. Chains of equal length go side by side in
/// lanes, and `jobs` threads take the blocks; a result does not depend on its neighbors. Throws InputError,
/// naming the case, for a fiber without damping, an overdamped first mode, a load of 0, or a range of peaks
/// that is no range; what dem::solve_equilibrium and dem::ring_down throw.
std::vector<StaticReleaseResult> static_release_damping(const std::vector<StaticReleaseRequest>& requests,
                                                        const Jobs& jobs = 1);

}  // namespace fiberchain::compare
