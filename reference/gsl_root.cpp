#include "reference/gsl_root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <exception>
#include <memory>
#include <new>

#include "reference/errors.hpp"
#include "reference/gsl_status.hpp"

namespace fiberchain::reference::detail {
namespace {

using Function = std::function<double(double)>;
using SlopeFunction = std::function<ValueSlope(double)>;

/// A function under search. An exception must not travel through GSL's C frames, and a value that is not
/// finite would call GSL's error handler: both are kept here and look like a root to GSL, which stops.
struct Guarded {
  const SlopeFunction& function;
  ValueSlope last{0, 1};
  std::exception_ptr failure;

  ValueSlope operator()(double x) noexcept {
    constexpr ValueSlope stop{0, 1};
    if (failure) return stop;
    try {
      last = function(x);
      if (std::isfinite(last.value) && std::isfinite(last.slope) && last.slope != 0) return last;
      throw NoConvergence("the function under a root search is not finite or has no slope");
    } catch (...) {
      failure = std::current_exception();
    }
    return stop;
  }
  void rethrow() const {
    if (failure) std::rethrow_exception(failure);
  }
};

double call_value(double x, void* guarded) { return (*static_cast<Guarded*>(guarded))(x).value; }

double call_slope(double x, void* guarded) { return (*static_cast<Guarded*>(guarded))(x).slope; }

void call_both(double x, void* guarded, double* value, double* slope) {
  const ValueSlope both = (*static_cast<Guarded*>(guarded))(x);
  *value = both.value;
  *slope = both.slope;
}

}  // namespace

double find_root(const Function& function, double lower, double upper, const RootTolerances& tolerances,
                 const std::string& what) {
  // GSL would call its (aborting) error handler for a bracket without a change of sign: look first.
  const double at_lower = function(lower);
  const double at_upper = function(upper);
  const auto known = [&](double x) { return x == lower ? at_lower : x == upper ? at_upper : function(x); };
  if (std::abs(at_lower) <= tolerances.residual) return lower;
  if (std::abs(at_upper) <= tolerances.residual) return upper;
  if (!(at_lower * at_upper < 0)) throw NoConvergence(what + " (the bracket holds no root)");

  std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
  if (!solver) throw std::bad_alloc();
  const SlopeFunction sloped = [&](double x) { return ValueSlope{known(x), 1}; };
  Guarded guarded{sloped, {}, {}};
  gsl_function wrapped{&call_value, &guarded};
  check_gsl(gsl_root_fsolver_set(solver.get(), &wrapped, lower, upper), what);
  for (int i = 0; i < tolerances.max_iterations; ++i) {
    check_gsl(gsl_root_fsolver_iterate(solver.get()), what);
    guarded.rethrow();
    const double low = gsl_root_fsolver_x_lower(solver.get());
    const double high = gsl_root_fsolver_x_upper(solver.get());
    const double root = gsl_root_fsolver_root(solver.get());
    if (std::abs(high - low) <= tolerances.interval * std::abs(root)) return root;
    if (std::abs(guarded.last.value) <= tolerances.residual) return root;
  }
  throw NoConvergence(what + " (too many iterations)");
}

double find_root_newton(const SlopeFunction& function, double start, double step, int max_iterations,
                        const std::string& what) {
  std::unique_ptr<gsl_root_fdfsolver, decltype(&gsl_root_fdfsolver_free)> solver(
      gsl_root_fdfsolver_alloc(gsl_root_fdfsolver_newton), &gsl_root_fdfsolver_free);
  if (!solver) throw std::bad_alloc();
  Guarded guarded{function, {}, {}};
  gsl_function_fdf wrapped{&call_value, &call_slope, &call_both, &guarded};
  check_gsl(gsl_root_fdfsolver_set(solver.get(), &wrapped, start), what);
  guarded.rethrow();
  double previous = start;
  for (int i = 0; i < max_iterations; ++i) {
    check_gsl(gsl_root_fdfsolver_iterate(solver.get()), what);
    guarded.rethrow();
    const double root = gsl_root_fdfsolver_root(solver.get());
    if (std::abs(root - previous) <= step * std::abs(root)) return root;
    previous = root;
  }
  throw NoConvergence(what + " (too many iterations)");
}

}  // namespace fiberchain::reference::detail
