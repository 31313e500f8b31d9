#pragma once

#include <functional>
#include <string>

namespace fiberchain::reference::detail {

/// When a root search stops: the residual is within `residual`, or the bracket within `interval` of the
/// root's own size.
struct RootTolerances {
  double residual = 0;
  double interval = 1e-15;
  int max_iterations = 200;
};

/// Root of a continuous function with a change of sign between lower and upper, by GSL's Brent-Dekker
/// search. Throws NoConvergence, naming `what`, if the signs agree or the iterations run out.
double find_root(const std::function<double(double)>& function, double lower, double upper,
                 const RootTolerances& tolerances, const std::string& what);

/// Value and first derivative of a function.
struct ValueSlope {
  double value;
  double slope;
};

/// Root by GSL's Newton iteration from `start`; stops when a step is within `step` (relative), so that the
/// error left is of the order of its square. The function's last call is at the root returned.
double find_root_newton(const std::function<ValueSlope(double)>& function, double start, double step,
                        int max_iterations, const std::string& what);

}  // namespace fiberchain::reference::detail
