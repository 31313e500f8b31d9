#pragma once

#include <vector>

#include "compare/fit/fit.hpp"

namespace fiberchain::compare {

/// Where a law is closest to some points.
struct LeastSquares {
  std::vector<double> parameters;
  std::vector<std::vector<double>> inverse_normal;  ///< (J^T J)^-1
  double rss;                                       ///< sum of the squared residuals, of the model's kind
};

/// Unweighted or logarithmic least squares by GSL's multifit_nlinear: Levenberg-Marquardt, QR, analytic
/// Jacobian, from a straight line through the logarithms. The points are above 0 and enough. Throws
/// InputError when it does not converge.
LeastSquares least_squares(const DampingModel& model, const std::vector<DampingDatum>& points);

}  // namespace fiberchain::compare
