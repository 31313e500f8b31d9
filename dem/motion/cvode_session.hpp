#pragma once

#include <functional>
#include <memory>
#include <vector>

namespace fiberchain::dem {

/// An initial value problem y' = f(t, y) for CVODE, with its own linear solver.
struct CvodeProblem {
  std::vector<double> start;
  std::vector<double> tolerances;  ///< allowed local error of each number
  long max_steps;                  ///< from one call of at() to the next
  std::function<void(double time, const double* y, double* rate)> rates;  ///< may throw: at() lets it through
  /// Solves (I - gamma df/dy) x = b with df/dy at, or near enough to, `y`. `again` counts the calls since
  /// CVODE's last change of time or gamma: high where a df/dy kept from earlier no longer serves.
  struct Newton {
    double time, gamma;
    const double* y;
    int again;
  };
  std::function<void(const Newton& at, const double* b, double* x)> solve;
};

/// SUNDIALS' CVODE (BDF, variable order and step) with a matrix-embedded linear solver. With
/// vector_operations.cpp the one place in dem/ that knows SUNDIALS.
class CvodeSession {
 public:
  /// Throws InvalidInput for tolerances that are not positive and finite.
  explicit CvodeSession(CvodeProblem problem);
  ~CvodeSession();
  CvodeSession(CvodeSession&&) noexcept;

  /// y at a time, interpolated within CVODE's last step; times must not fall. Throws Diverged with CVODE's
  /// reason when it gives up.
  const double* at(double time);

  double steps() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace fiberchain::dem
