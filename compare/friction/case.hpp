#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/measure/peaks.hpp"
#include "compare/study/jobs.hpp"
#include "dem/model/fiber.hpp"
#include "dem/motion/physics.hpp"

// Rolling friction of the bonds (Eq 21) and what it does to a fiber let go from its equilibrium under a load.
namespace fiberchain::compare {

/// One fiber let go. At a given load P L^2/(E I) the result does not depend on E, d and density.
struct RollingCase {
  int aspect_ratio = 30;
  double poisson_ratio = 0.3;
  double load = 1;  ///< P L^2 / (E I) before the release
  std::optional<double> amplitude =
      std::nullopt;             ///< of the free end over L: let go from the first mode, without load
  double bond_damping = 1;      ///< xi_b
  double rolling_friction = 0;  ///< xi_r
  dem::Rolling law = dem::Rolling::set_valued;
  std::optional<double> step_ratio = std::nullopt;  ///< dt / t_b; left out: 0.8 of the chain's stable step
  PeakRange peaks{1, 5};                            ///< peak 0 is the point of release
};

struct RollingPoint {
  RollingCase asked;
  double damping;           ///< xi_f of the peaks asked for, as the paper measures it
  double half_width;        ///< 95 %, of its fit: what the decay lacks of an exponential
  double first, last;       ///< xi_f of the first two and of the last two of these peaks alone
  double without;           ///< xi_f of the linear chain without friction
  double as_bond;           ///< the same with dashpots xi_b + xi_r: if xi_r acted as xi_b does
  double weak;              ///< without + small_friction_damping() at the mean amplitude of these peaks
  std::vector<Peak> peaks;  ///< from peak 0 to the last asked for, over L
  double time_step;         ///< [s]
  double steps;
  std::string status;  ///< "measured", else why not, and every number is NaN
};

using RollingPoints = std::vector<RollingPoint>;

struct RollingOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};                 ///< called after each case, from any thread
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// Every case in the order given; one that cannot be measured keeps its row with its status. Throws
/// dem::InvalidInput or InputError for a case out of range.
RollingPoints rolling_points(const std::vector<RollingCase>& cases, const RollingOptions& options = {});

/// The chain of a case.
dem::Fiber rolling_fiber(const RollingCase& asked);

}  // namespace fiberchain::compare
