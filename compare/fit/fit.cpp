#include "compare/fit/fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/fit/least_squares.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"

namespace fiberchain::compare {
namespace {

void fill_intervals(DampingFit& fit, const LeastSquares& found, std::size_t points) {
  const std::size_t p = fit.parameters.size();
  const double degrees = static_cast<double>(points - p);
  const double variance = found.rss / degrees, t = gsl_cdf_tdist_Pinv(0.975, degrees);
  for (std::size_t i = 0; i < p; ++i) {
    fit.covariance.push_back(found.inverse_normal[i]);
    for (double& entry : fit.covariance[i]) entry *= variance;
    fit.half_widths.push_back(t * std::sqrt(fit.covariance[i][i]));
  }
}

double information_criterion(const DampingModel& model, const std::vector<DampingDatum>& points, double rss) {
  const double n = static_cast<double>(points.size()), k = parameter_count(model.law) + 1;
  if (n <= k + 1) return nan;
  double change_of_variables = 0;
  if (model.kind == FitKind::logarithmic) {
    for (const DampingDatum& p : points) change_of_variables += 2 * std::log(p.slope);
  }
  return n * std::log(rss / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1) + change_of_variables;
}

FitError error_on(const DampingFit& fit, const std::vector<DampingDatum>& points) {
  FitError error{{}, points.empty() ? nan : 0.0, points.empty() ? nan : 0.0};
  for (const DampingDatum& p : points) {
    const double off = damping_law(fit.model.law, fit.parameters, p.aspect_ratio) / p.slope - 1;
    error.residuals.push_back(off);
    error.rms = std::hypot(error.rms, off / std::sqrt(static_cast<double>(points.size())));
    if (std::abs(off) > std::abs(error.largest)) error.largest = off;
  }
  return error;
}

void check(const std::vector<DampingDatum>& points) {
  for (const DampingDatum& p : points) {
    if (p.aspect_ratio < 1)
      throw InputError(fmt::format("aspect ratio {} is not allowed: 1 or more", p.aspect_ratio));
    if (!(p.slope > 0) || !std::isfinite(p.slope)) {
      throw InputError(
          fmt::format("xi_f/xi_b = {} at aspect ratio {} is not allowed: it must be above 0, a motion that "
                      "decays",
                      p.slope, p.aspect_ratio));
    }
  }
}

void check_enough(const DampingModel& model, const std::vector<DampingDatum>& points) {
  std::set<int> different;
  for (const DampingDatum& p : points) different.insert(p.aspect_ratio);
  const int least = parameter_count(model.law) + 1;
  if (static_cast<int>(different.size()) < least) {
    throw InputError(fmt::format("a fit of the {} law needs {} different aspect ratios or more, {} given",
                                 name(model.law), least, different.size()));
  }
}

DampingFit unfitted(const DampingModel& model, std::vector<double> parameters,
                    const std::vector<DampingDatum>& points) {
  check(points);
  DampingFit fit{model, std::move(parameters), {}, {}, {}, {{}, nan, nan}, nan, {}, {}, {}};
  fit.fitted = error_on(fit, points);
  return fit;
}

}  // namespace

std::string_view name(FitKind kind) {
  switch (kind) {
    case FitKind::unweighted:
      return "unweighted";
    case FitKind::logarithmic:
      return "logarithmic";
    case FitKind::published:
      return "published";
    default:
      return "derived";
  }
}

DampingFit fit_damping(const DampingModel& model, const std::vector<DampingDatum>& points) {
  if (model.kind != FitKind::unweighted && model.kind != FitKind::logarithmic) {
    throw InputError(fmt::format("'{}' is no way to fit: unweighted or logarithmic", name(model.kind)));
  }
  check(points);
  check_enough(model, points);
  const LeastSquares found = least_squares(model, points);
  DampingFit fit = unfitted(model, found.parameters, points);
  fill_intervals(fit, found, points.size());
  fit.information_criterion = information_criterion(model, points, found.rss);
  return fit;
}

DampingFit judge(DampingFit fit, const std::vector<DampingDatum>& held_out, const ChainCurve& chain) {
  check(held_out);
  fit.held_out = error_on(fit, held_out);
  fit.within_1 = region_within(fit.model.law, fit.parameters, chain, 0.01);
  fit.within_5 = region_within(fit.model.law, fit.parameters, chain, 0.05);
  fit.within_20 = region_within(fit.model.law, fit.parameters, chain, 0.20);
  return fit;
}

DampingFit published_law(const std::vector<DampingDatum>& points) {
  return unfitted({DampingLaw::exponential, FitKind::published}, {kPaperA, kPaperB}, points);
}

DampingFit derived_law(const std::vector<DampingDatum>& points) {
  return unfitted({DampingLaw::shifted_square, FitKind::derived}, {0.5}, points);
}

std::vector<DampingFit> damping_fits(const std::vector<DampingDatum>& points,
                                     const std::vector<DampingDatum>& held_out, const ChainCurve& chain) {
  for (const DampingDatum& p : held_out) {
    if (std::ranges::find(points, p.aspect_ratio, &DampingDatum::aspect_ratio) != points.end()) {
      throw InputError(fmt::format("aspect ratio {} is both fitted and held out", p.aspect_ratio));
    }
  }
  std::vector<DampingFit> fits;
  for (const DampingLaw law : {DampingLaw::exponential, DampingLaw::power, DampingLaw::shifted_square}) {
    for (const FitKind kind : {FitKind::unweighted, FitKind::logarithmic})
      fits.push_back(fit_damping({law, kind}, points));
  }
  fits.push_back(published_law(points));
  fits.push_back(derived_law(points));
  for (DampingFit& fit : fits) fit = judge(std::move(fit), held_out, chain);
  return fits;
}

}  // namespace fiberchain::compare
