#pragma once

#include <vector>

#include "compare/bench/row.hpp"

// The problems of the bench. Nominal fiber, nu = 0.3; one thread, one chain at a time unless a row says
// otherwise.
namespace fiberchain::compare {

struct BenchOptions {
  bool quick = false;               ///< fewer settings and runs, under half a minute in all
  std::vector<int> aspect_ratio{};  ///< of the damping problems; empty: 10, 30, 100 (quick 10, 30)
  bool leapfrogs_alone = false;     ///< of the integrators that march a release
};

/// How long a row may be timed.
TimingBudget row_budget(const BenchOptions& options);

/// Free end of the cantilever against the Elastica's: |dr|/L by r_f, bond, solved and marched. Reference:
/// closed form in elliptic integrals; its own error from the shooting solution.
PrecisionProblem elastica_problem(double load, const BenchOptions& options);

/// Free end of the chain itself at r_f = 10: what steps, residual limits and the incremental form cost.
/// Reference: GSL's hybrid root search on the balance of forces; its own error from two starts.
PrecisionProblem equilibrium_problem(double load, const BenchOptions& options);

/// Damping ratio xi_f of the first mode at small amplitude, xi_b = 1: relative error. Reference: all modes by
/// a dense eigensolve; its own error from the same chain in other units, which rounds differently, and from
/// the amplitude.
PrecisionProblem damping_problem(int aspect_ratio, const BenchOptions& options);

/// Free end's path after the release from a large deflection, xi_b = 1: largest |dr|/L over three periods.
/// Reference: GSL's Prince-Dormand 8(9) pair on the chain's equations; its own error from a ten times looser
/// tolerance.
PrecisionProblem history_problem(int aspect_ratio, double load, const BenchOptions& options);

/// A hundred orbits (quick: three) of a stiff fiber in shear, in space: error of the change of its orbit
/// constant. The leapfrog has inertia, which takes the fiber toward the flow plane in proportion to the
/// Stokes number: it is made as small as the wanted error asks for, and the step with it. One of its orbits
/// is followed, time and error stand for all.
PrecisionProblem flow_problem(const BenchOptions& options);

}  // namespace fiberchain::compare
