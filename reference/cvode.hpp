#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fiberchain::reference {

/// What a CVODE run cost.
struct CvodeStatistics {
  long steps = 0;
  long right_hand_sides = 0;
  long jacobians = 0;
  long linear_setups = 0;
  long newton_iterations = 0;
  long error_test_failures = 0;
  long convergence_failures = 0;  ///< of the nonlinear iteration
};

/// Formula family: bdf for damped (stiff) motion, adams (up to order 12) for undamped.
enum class CvodeMethod { bdf, adams };

/// Local error allowed in each component: relative |component| + absolute.
struct CvodeTolerances {
  double relative = 1e-10;
  double absolute = 1e-12;
  long max_steps = 5000000;  ///< between two output times
};

namespace detail {

/// derivative = f(t, state)
using CvodeRhs = std::function<void(double t, std::span<const double> state, std::span<double> derivative)>;
/// Entry (i, j) of df/dstate goes to jacobian[i + j dimension]; all entries are zero beforehand.
using CvodeJacobian =
    std::function<void(double t, std::span<const double> state, std::span<double> jacobian)>;

/// An initial-value problem stepped by CVODE with Newton's iteration, a dense matrix and the Jacobian given.
/// This class is the only place where SUNDIALS is used.
class Cvode {
 public:
  /// Throws InvalidArgument for tolerances that are not positive, NoConvergence if CVODE refuses. `name`
  /// says what is integrated, for messages.
  Cvode(CvodeMethod method, CvodeRhs rhs, CvodeJacobian jacobian, double t, std::span<const double> state,
        const CvodeTolerances& tolerances, std::string name);
  ~Cvode();
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;

  /// Integrates to t (later than the time reached) and returns the state there, interpolated within
  /// CVODE's last step to the order of the method. An exception of rhs or jacobian comes through.
  std::span<const double> advance(double t);

  CvodeStatistics statistics() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace detail
}  // namespace fiberchain::reference
