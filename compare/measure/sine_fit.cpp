#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <cmath>
#include <memory>
#include <numbers>

#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Samples of the window; times from its start, displacements over the largest.
struct Window {
  std::vector<double> time, y;
};

Window window_of(const TipHistory& history, double from, double to) {
  Window window;
  double scale = 0;
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    if (history.time[i] < from || history.time[i] > to) continue;
    window.time.push_back(history.time[i] - from);
    window.y.push_back(history.y[i]);
    scale = std::max(scale, std::abs(history.y[i]));
  }
  for (double& y : window.y) y /= scale;
  return window;
}

/// y = exp(-s t) (a cos(w t) + b sin(w t)); parameters a, b, s, w.
int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
  const Window& window = *static_cast<const Window*>(data);
  const double a = gsl_vector_get(p, 0), b = gsl_vector_get(p, 1), s = gsl_vector_get(p, 2),
               w = gsl_vector_get(p, 3);
  for (std::size_t i = 0; i < window.time.size(); ++i) {
    const double t = window.time[i];
    gsl_vector_set(f, i, std::exp(-s * t) * (a * std::cos(w * t) + b * std::sin(w * t)) - window.y[i]);
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* p, void* data, gsl_matrix* J) {
  const Window& window = *static_cast<const Window*>(data);
  const double a = gsl_vector_get(p, 0), b = gsl_vector_get(p, 1), s = gsl_vector_get(p, 2),
               w = gsl_vector_get(p, 3);
  for (std::size_t i = 0; i < window.time.size(); ++i) {
    const double t = window.time[i], decay = std::exp(-s * t), c = std::cos(w * t), n = std::sin(w * t);
    gsl_matrix_set(J, i, 0, decay * c);
    gsl_matrix_set(J, i, 1, decay * n);
    gsl_matrix_set(J, i, 2, -t * decay * (a * c + b * n));
    gsl_matrix_set(J, i, 3, t * decay * (b * c - a * n));
  }
  return GSL_SUCCESS;
}

struct FreeWorkspace {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
struct FreeMatrix {
  void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
};

}  // namespace

Damping damping_from_sine(const TipHistory& history, double from, double to, const Damping& start) {
  Window window = window_of(history, from, to);
  const std::size_t n = window.time.size();
  if (n < 8)
    throw InputError(
        fmt::format("{} samples between {} s and {} s are too few to fit a damped sine", n, from, to));
  gsl_multifit_nlinear_fdf problem{residuals, jacobian, nullptr, n, 4, &window, 0, 0, 0};
  const gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace> workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, 4));
  const double omega = start.frequency / std::sqrt(1 - start.ratio * start.ratio);
  double guess[4] = {window.y[0], 0, start.ratio * omega, start.frequency};
  const gsl_vector_view first = gsl_vector_view_array(guess, 4);
  int info = 0;
  if (gsl_multifit_nlinear_init(&first.vector, &problem, workspace.get()) != GSL_SUCCESS ||
      gsl_multifit_nlinear_driver(100, 1e-12, 1e-14, 0, nullptr, nullptr, &info, workspace.get()) ==
          GSL_EMAXITER) {
    throw InputError("the fit of a damped sine did not converge");
  }
  const gsl_vector* found = gsl_multifit_nlinear_position(workspace.get());
  std::unique_ptr<gsl_matrix, FreeMatrix> covariance(gsl_matrix_alloc(4, 4));
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace.get()), 0, covariance.get());
  double squares = 0;
  const gsl_vector* left = gsl_multifit_nlinear_residual(workspace.get());
  for (std::size_t i = 0; i < n; ++i) squares += std::pow(gsl_vector_get(left, i), 2);
  const double s = gsl_vector_get(found, 2), w = gsl_vector_get(found, 3), size = std::hypot(s, w);
  const double error =
      std::sqrt(squares / static_cast<double>(n - 4) * gsl_matrix_get(covariance.get(), 2, 2)) *
      gsl_cdf_tdist_Pinv(0.975, static_cast<double>(n - 4));
  return {s / size, error * w * w / (size * size * size), w};
}

}  // namespace fiberchain::compare
