#pragma once

#include <string_view>
#include <vector>

#include "compare/fit/law.hpp"

// Laws of law.hpp fitted to measured dampings, with what the fit is worth.
namespace fiberchain::compare {

/// One measured damping.
struct DampingDatum {
  int aspect_ratio;
  double slope;  ///< xi_f / xi_b
};

/// Where a law's parameters come from.
enum class FitKind {
  unweighted,   ///< least squares of xi_f / xi_b itself, as the paper: the short fibers, damped most, decide
  logarithmic,  ///< least squares of its logarithm: every fiber counts alike
  published,    ///< the paper's a and b
  derived       ///< c = 1/2, from the clamped half-bond
};

std::string_view name(FitKind kind);

struct DampingModel {
  DampingLaw law;
  FitKind kind;
};

/// How far a law is from some points, in parts of the points' values.
struct FitError {
  std::vector<double> residuals;  ///< law / point - 1, in the order of the points
  double rms;                     ///< NaN without points
  double largest;                 ///< by size, with its sign; NaN without points
};

/// A law with its parameters, from a fit or from elsewhere. The points are deterministic: intervals and
/// covariance tell how badly the law fits, as if its misfit were noise, not how exactly the points were
/// measured.
struct DampingFit {
  DampingModel model;
  std::vector<double> parameters;               ///< a, b or c
  std::vector<double> half_widths;              ///< 95 %, Student's t with n - p degrees; empty unless fitted
  std::vector<std::vector<double>> covariance;  ///< s^2 (J^T J)^-1, s^2 = RSS / (n - p); empty unless fitted
  FitError fitted;                              ///< on the points of the fit
  FitError held_out;                            ///< on points that the fit never saw
  /// Corrected Akaike criterion, n ln(RSS/n) + 2 k + 2 k (k + 1)/(n - k - 1), k the parameters and the
  /// variance. A fit in the logarithm gets 2 sum ln(xi_f/xi_b) more, the change of variables of its
  /// likelihood, so that both kinds speak of the density of the same data; a constant n (1 + ln 2 pi) is left
  /// out of both. NaN unless fitted and n > k + 1; minus infinity for a perfect fit.
  double information_criterion;
  std::vector<AspectRange> within_1, within_5,
      within_20;  ///< where it is within so many % of the linear chain
};

/// Fits the law by GSL (multifit_nlinear, Levenberg-Marquardt, analytic Jacobian). Throws InputError for a
/// kind that is no fit, fewer different aspect ratios than parameters and one, an xi_f / xi_b that is not
/// above 0 (no decay), or when the fit does not converge. Errors on held-out points and regions are left
/// empty: judge() fills them.
DampingFit fit_damping(const DampingModel& model, const std::vector<DampingDatum>& points);

/// The same law held against points that were not fitted and the linear chain.
DampingFit judge(DampingFit fit, const std::vector<DampingDatum>& held_out, const ChainCurve& chain);

/// The paper's Eq 20 and the closed form c = 1/2 beside these points: nothing is fitted.
DampingFit published_law(const std::vector<DampingDatum>& points);
DampingFit derived_law(const std::vector<DampingDatum>& points);

/// All three laws fitted both ways, the paper's and the derived one; judged. Throws InputError also when a
/// held-out aspect ratio is among the fitted ones.
std::vector<DampingFit> damping_fits(const std::vector<DampingDatum>& points,
                                     const std::vector<DampingDatum>& held_out, const ChainCurve& chain);

}  // namespace fiberchain::compare
