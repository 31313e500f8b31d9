#include "reference/gsl_ode.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "reference/errors.hpp"
#include "reference/gsl_status.hpp"

namespace fiberchain::reference::detail {

OdeIntegrator::OdeIntegrator(std::size_t dimension, OdeRhs rhs, const OdeTolerances& tolerances,
                             std::string name)
    : rhs_(std::move(rhs)),
      name_(std::move(name)),
      steps_left_(tolerances.max_steps),
      system_{&OdeIntegrator::call, nullptr, dimension, this},
      step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, dimension), &gsl_odeiv2_step_free),
      control_(gsl_odeiv2_control_y_new(tolerances.absolute, tolerances.relative), &gsl_odeiv2_control_free),
      evolve_(gsl_odeiv2_evolve_alloc(dimension), &gsl_odeiv2_evolve_free) {
  if (!step_ || !control_ || !evolve_) throw std::bad_alloc();
}

int OdeIntegrator::call(double t, const double state[], double derivative[], void* self) {
  auto& integrator = *static_cast<OdeIntegrator*>(self);
  integrator.rhs_(t, state, derivative);
  // A trial stage may leave the equations' range: anything but success makes GSL retry half the step.
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(derivative, derivative + integrator.system_.dimension, finite) ? GSL_SUCCESS
                                                                                    : GSL_ERANGE;
}

void OdeIntegrator::step(double& t, double t_end, std::span<double> state) {
  if (step_size_ == 0 || (step_size_ > 0) != (t_end > t)) step_size_ = (t_end - t) * 0.01;
  if (steps_left_-- <= 0) throw NoConvergence(name_ + " (too many steps)");
  check_gsl(gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system_, &t, t_end,
                                    &step_size_, state.data()),
            name_);
  for (const double value : state) {
    if (!std::isfinite(value)) throw NoConvergence(name_ + " (not a finite number)");
  }
}

void OdeIntegrator::advance(double& t, double t_end, std::span<double> state) {
  while (t != t_end) step(t, t_end, state);
}

}  // namespace fiberchain::reference::detail
