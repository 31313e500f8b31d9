#include "compare/fit/least_squares.hpp"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>
#include <new>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

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

/// Straight line through the logarithms, or the mean of the c that each point has by itself; then a little
/// off, so that there is a step to take even where that is the answer.
std::vector<double> start_values(const Problem& problem) {
  std::vector<double> x, y;
  for (const DampingDatum& p : problem.points) {
    x.push_back(problem.model.law == DampingLaw::power ? std::log(p.aspect_ratio) : p.aspect_ratio);
    y.push_back(std::log(p.slope));
  }
  if (problem.model.law == DampingLaw::shifted_square) {
    double c = 0;
    for (const DampingDatum& p : problem.points) {
      c += (std::sqrt(long_chain_coefficient() / p.slope) - p.aspect_ratio) /
           static_cast<double>(problem.points.size());
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

Workspace solved(Problem& problem) {
  const std::size_t n = problem.points.size(),
                    p = static_cast<std::size_t>(parameter_count(problem.model.law));
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.solver = gsl_multifit_nlinear_solver_qr;
  Workspace workspace{gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, p),
                      gsl_multifit_nlinear_free};
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
    throw InputError(fmt::format("the {} fit of the {} law does not converge on these points",
                                 name(problem.model.kind), name(problem.model.law)));
  }
  return workspace;
}

std::vector<std::vector<double>> inverse_normal(const gsl_matrix* J) {
  const std::size_t p = J->size2;
  const Matrix inverse{gsl_matrix_alloc(p, p), gsl_matrix_free};
  gsl_multifit_nlinear_covar(J, 0.0, inverse.get());
  std::vector<std::vector<double>> rows(p);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) rows[i].push_back(gsl_matrix_get(inverse.get(), i, j));
  }
  return rows;
}

}  // namespace

LeastSquares least_squares(const DampingModel& model, const std::vector<DampingDatum>& points) {
  Problem problem{model, points};
  const Workspace workspace = solved(problem);
  const double size = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(workspace.get()));
  return {to_vector(gsl_multifit_nlinear_position(workspace.get())),
          inverse_normal(gsl_multifit_nlinear_jac(workspace.get())), size * size};
}

}  // namespace fiberchain::compare
