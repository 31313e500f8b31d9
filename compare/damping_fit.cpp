#include "compare/damping_fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

#include "compare/errors.hpp"

namespace fiberchain::compare {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>;
using Matrix = std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>;

struct Problem {
  DampingModel model;
  const std::vector<DampingDatum>& points;
};

std::vector<double> to_vector(const gsl_vector* v) {
  std::vector<double> values(v->size);
  for (std::size_t i = 0; i < v->size; ++i) values[i] = gsl_vector_get(v, i);
  return values;
}

int residuals(const gsl_vector* x, void* data, gsl_vector* f) {
  const auto& [model, points] = *static_cast<const Problem*>(data);
  const std::vector<double> parameters = to_vector(x);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double y = damping_law(model.law, parameters, points[i].aspect_ratio);
    const bool plain = model.kind == FitKind::unweighted;
    const double off = plain ? y - points[i].slope : std::log(y / points[i].slope);
    if (!std::isfinite(off)) return GSL_EDOM;  // a step too far: the solver takes a shorter one
    gsl_vector_set(f, i, off);
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* x, void* data, gsl_matrix* J) {
  const auto& [model, points] = *static_cast<const Problem*>(data);
  const std::vector<double> parameters = to_vector(x);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double y = damping_law(model.law, parameters, points[i].aspect_ratio);
    const std::vector<double> slopes = damping_law_slopes(model.law, parameters, points[i].aspect_ratio);
    for (std::size_t j = 0; j < slopes.size(); ++j) {
      gsl_matrix_set(J, i, j, model.kind == FitKind::unweighted ? slopes[j] : slopes[j] / y);
    }
  }
  return GSL_SUCCESS;
}

/// Straight line through the logarithms, or the mean of the c that each point has by itself; then a little off, so that
/// there is a step to take even where that is the answer.
std::vector<double> start_values(const Problem& problem) {
  std::vector<double> x, y;
  for (const DampingDatum& p : problem.points) {
    x.push_back(problem.model.law == DampingLaw::power ? std::log(p.aspect_ratio) : p.aspect_ratio);
    y.push_back(std::log(p.slope));
  }
  if (problem.model.law == DampingLaw::shifted_square) {
    double c = 0;
    for (const DampingDatum& p : problem.points) {
      c += (std::sqrt(long_chain_coefficient() / p.slope) - p.aspect_ratio) / static_cast<double>(problem.points.size());
    }
    return {c + 0.01};
  }
  double intercept, slope, c00, c01, c11, rest;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &c00, &c01, &c11, &rest);
  return {std::exp(intercept) * 1.01, -slope};
}

/// At a minimum the residuals are orthogonal to the Jacobian's columns, or nothing is left of them.
bool is_minimum(const Problem& problem, const gsl_multifit_nlinear_workspace* w) {
  const gsl_vector* f = gsl_multifit_nlinear_residual(w);
  const gsl_matrix* J = gsl_multifit_nlinear_jac(w);
  double scale = 0;
  for (const DampingDatum& p : problem.points) {
    scale = std::hypot(scale, problem.model.kind == FitKind::unweighted ? p.slope : 1.0);
  }
  const double size = gsl_blas_dnrm2(f);
  if (size <= 1e-13 * scale) return true;
  for (std::size_t j = 0; j < J->size2; ++j) {
    const gsl_vector_const_view column = gsl_matrix_const_column(J, j);
    double product = 0;
    gsl_blas_ddot(&column.vector, f, &product);
    if (!(std::abs(product) <= 1e-7 * gsl_blas_dnrm2(&column.vector) * size)) return false;
  }
  return true;
}

void fill_intervals(DampingFit& fit, const gsl_multifit_nlinear_workspace* w) {
  const gsl_matrix* J = gsl_multifit_nlinear_jac(w);
  const std::size_t n = J->size1, p = J->size2;
  const Matrix covariance{gsl_matrix_alloc(p, p), gsl_matrix_free};
  gsl_multifit_nlinear_covar(J, 0.0, covariance.get());
  const double size = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(w));
  const double variance = size * size / static_cast<double>(n - p);
  const double t = gsl_cdf_tdist_Pinv(0.975, static_cast<double>(n - p));
  for (std::size_t i = 0; i < p; ++i) {
    fit.covariance.emplace_back();
    for (std::size_t j = 0; j < p; ++j) fit.covariance[i].push_back(variance * gsl_matrix_get(covariance.get(), i, j));
    fit.half_widths.push_back(t * std::sqrt(fit.covariance[i][i]));
  }
}

double information_criterion(const Problem& problem, const gsl_vector* f) {
  const double n = static_cast<double>(f->size), k = parameter_count(problem.model.law) + 1, size = gsl_blas_dnrm2(f);
  if (n <= k + 1) return nan;
  double jacobian_term = 0;
  if (problem.model.kind == FitKind::logarithmic) {
    for (const DampingDatum& p : problem.points) jacobian_term += 2 * std::log(p.slope);
  }
  return n * std::log(size * size / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1) + jacobian_term;
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
    if (p.aspect_ratio < 1) throw InputError(fmt::format("aspect ratio {} is not allowed: 1 or more", p.aspect_ratio));
    if (!(p.slope > 0) || !std::isfinite(p.slope)) {
      throw InputError(fmt::format("xi_f/xi_b = {} at aspect ratio {} is not allowed: it must be above 0, a motion that "
                                   "decays", p.slope, p.aspect_ratio));
    }
  }
}

void check_enough(const DampingModel& model, const std::vector<DampingDatum>& points) {
  std::set<int> different;
  for (const DampingDatum& p : points) different.insert(p.aspect_ratio);
  const int least = parameter_count(model.law) + 1;
  if (static_cast<int>(different.size()) < least) {
    throw InputError(fmt::format("a fit of the {} law needs {} different aspect ratios or more, {} given", name(model.law),
                                 least, different.size()));
  }
}

DampingFit unfitted(const DampingModel& model, std::vector<double> parameters, const std::vector<DampingDatum>& points) {
  check(points);
  DampingFit fit{model, std::move(parameters), {}, {}, {}, {{}, nan, nan}, nan, {}, {}, {}};
  fit.fitted = error_on(fit, points);
  return fit;
}

Workspace solved(Problem& problem) {
  const std::size_t n = problem.points.size(), p = static_cast<std::size_t>(parameter_count(problem.model.law));
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.solver = gsl_multifit_nlinear_solver_qr;
  Workspace workspace{gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, p), gsl_multifit_nlinear_free};
  if (!workspace) throw std::bad_alloc();
  gsl_multifit_nlinear_fdf functions{residuals, jacobian, nullptr, n, p, &problem, 0, 0, 0};
  std::vector<double> start = start_values(problem);
  const gsl_vector_view x = gsl_vector_view_array(start.data(), p);
  int status = gsl_multifit_nlinear_init(&x.vector, &functions, workspace.get());
  int why = 0;
  if (status == GSL_SUCCESS) {
    status = gsl_multifit_nlinear_driver(200, 1e-13, 0, 0, nullptr, nullptr, &why, workspace.get());
  }
  if ((status != GSL_SUCCESS && status != GSL_EMAXITER && status != GSL_ENOPROG) ||
      !is_minimum(problem, workspace.get())) {
    throw InputError(fmt::format("the {} fit of the {} law does not converge on these points", name(problem.model.kind),
                                 name(problem.model.law)));
  }
  return workspace;
}

}  // namespace

std::string_view name(FitKind kind) {
  switch (kind) {
    case FitKind::unweighted: return "unweighted";
    case FitKind::logarithmic: return "logarithmic";
    case FitKind::published: return "published";
    default: return "derived";
  }
}

DampingFit fit_damping(const DampingModel& model, const std::vector<DampingDatum>& points) {
  if (model.kind != FitKind::unweighted && model.kind != FitKind::logarithmic) {
    throw InputError(fmt::format("'{}' is no way to fit: unweighted or logarithmic", name(model.kind)));
  }
  check(points);
  check_enough(model, points);
  Problem problem{model, points};
  const Workspace workspace = solved(problem);
  DampingFit fit = unfitted(model, to_vector(gsl_multifit_nlinear_position(workspace.get())), points);
  fill_intervals(fit, workspace.get());
  fit.information_criterion = information_criterion(problem, gsl_multifit_nlinear_residual(workspace.get()));
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

std::vector<DampingFit> damping_fits(const std::vector<DampingDatum>& points, const std::vector<DampingDatum>& held_out,
                                     const ChainCurve& chain) {
  for (const DampingDatum& p : held_out) {
    if (std::ranges::find(points, p.aspect_ratio, &DampingDatum::aspect_ratio) != points.end()) {
      throw InputError(fmt::format("aspect ratio {} is both fitted and held out", p.aspect_ratio));
    }
  }
  std::vector<DampingFit> fits;
  for (const DampingLaw law : {DampingLaw::exponential, DampingLaw::power, DampingLaw::shifted_square}) {
    for (const FitKind kind : {FitKind::unweighted, FitKind::logarithmic}) fits.push_back(fit_damping({law, kind}, points));
  }
  fits.push_back(published_law(points));
  fits.push_back(derived_law(points));
  for (DampingFit& fit : fits) fit = judge(std::move(fit), held_out, chain);
  return fits;
}

}  // namespace fiberchain::compare
