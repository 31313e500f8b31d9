#pragma once

#include <gsl/gsl_odeiv2.h>

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace fiberchain::reference::detail {

/// Local error a step may make in each component: absolute + relative |component|.
struct OdeTolerances {
  double absolute = 1e-14;
  double relative = 1e-13;
  int max_steps = 100000;
};

/// derivative = f(t, state), both of the dimension given to the integrator.
using OdeRhs = std::function<void(double t, const double* state, double* derivative)>;

/// An initial-value problem stepped by GSL's Prince-Dormand 8(9) pair with error control.
class OdeIntegrator {
 public:
  /// `name` says what is integrated, for the message of NoConvergence.
  OdeIntegrator(std::size_t dimension, OdeRhs rhs, const OdeTolerances& tolerances, std::string name);
  OdeIntegrator(const OdeIntegrator&) = delete;
  OdeIntegrator& operator=(const OdeIntegrator&) = delete;

  /// One accepted step from t toward, and never past, t_end; t and state are updated.
  void step(double& t, double t_end, std::span<double> state);

  /// Steps until t equals t_end.
  void advance(double& t, double t_end, std::span<double> state);

 private:
  static int call(double t, const double state[], double derivative[], void* self);

  OdeRhs rhs_;
  std::string name_;
  int steps_left_;
  double step_size_ = 0;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step_;
  std::unique_ptr<gsl_odeiv2_control, decltype(&gsl_odeiv2_control_free)> control_;
  std::unique_ptr<gsl_odeiv2_evolve, decltype(&gsl_odeiv2_evolve_free)> evolve_;
};

}  // namespace fiberchain::reference::detail
