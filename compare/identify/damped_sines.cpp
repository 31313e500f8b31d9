#include "compare/identify/damped_sines.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace fiberchain::compare {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int kIterations = 60;
/// Squares of the residuals over those of the record that are round-off.
constexpr double kExact = 1e-24;

/// Value of the model at a time and its derivatives by the parameters.
double model_at(double t, const Vector& p, Vector& gradient) {
  double y = p[0];
  gradient[0] = 1;
  for (int k = 1; k < p.size(); k += sine_parameters) {
    const double a = p[k], b = p[k + 1], decay = std::exp(-p[k + 2] * t), c = decay * std::cos(p[k + 3] * t),
                 n = decay * std::sin(p[k + 3] * t), own = a * c + b * n;
    y += own;
    gradient[k] = c, gradient[k + 1] = n;
    gradient[k + 2] = -t * own, gradient[k + 3] = t * (b * c - a * n);
  }
  return y;
}

/// The normal equations about p: J^T J, J^T r.
struct Normal {
  Matrix matrix;
  Vector right;
  double squares = 0;
};

Normal normal_at(const RingDownRecord& record, const Vector& p) {
  Normal all{Matrix::Zero(p.size(), p.size()), Vector::Zero(p.size())};
  Vector gradient(p.size());
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double left = record.displacement[i] - model_at(record.time[i] - record.time[0], p, gradient);
    all.matrix.selfadjointView<Eigen::Lower>().rankUpdate(gradient);
    all.right += left * gradient;
    all.squares += left * left;
  }
  all.matrix.triangularView<Eigen::StrictlyUpper>() = all.matrix.transpose();
  return all;
}

Vector parameters_of(double offset, const std::vector<DampedSine>& modes) {
  Vector p(1 + sine_parameters * static_cast<int>(modes.size()));
  int k = 0;
  p[k++] = offset;
  for (const DampedSine& mode : modes) p[k++] = mode.a, p[k++] = mode.b, p[k++] = mode.s, p[k++] = mode.w;
  return p;
}

/// Sizes of the parameters, by which the equations become ones of numbers about 1.
Vector scales_of(const Matrix& normal) {
  return normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
}

void take_result(const RingDownRecord& record, const Vector& p, const Normal& normal, SineFit& fit) {
  fit.offset = p[0];
  fit.modes.clear();
  for (int k = 1; k < p.size(); k += sine_parameters) {
    DampedSine mode{p[k], p[k + 1], p[k + 2], p[k + 3]};
    if (mode.w < 0) mode.w = -mode.w, mode.b = -mode.b;
    fit.modes.push_back(mode);
  }
  const Vector scale = scales_of(normal.matrix);
  const Matrix scaled = scale.asDiagonal() * normal.matrix * scale.asDiagonal();
  fit.covariance = scale.asDiagonal() * scaled.fullPivLu().inverse() * scale.asDiagonal();
  fit.squares = normal.squares;
  fit.residuals.clear();
  Vector gradient(p.size());
  for (std::size_t i = 0; i < record.time.size(); ++i)
    fit.residuals.push_back(record.displacement[i] - model_at(record.time[i] - record.time[0], p, gradient));
}

}  // namespace

double SineFit::criterion() const {
  const auto n = static_cast<double>(residuals.size());
  return n * std::log(std::max(squares, 1e-300) / n) + parameters() * std::log(n);
}

SineFit mean_of(const RingDownRecord& record) {
  SineFit fit;
  const auto n = static_cast<double>(record.displacement.size());
  fit.offset = std::reduce(record.displacement.begin(), record.displacement.end()) / n;
  for (const double y : record.displacement) {
    fit.residuals.push_back(y - fit.offset);
    fit.squares += fit.residuals.back() * fit.residuals.back();
  }
  fit.covariance = Matrix::Constant(1, 1, 1 / n);
  fit.converged = true;
  return fit;
}

SineFit fit_sines(const RingDownRecord& record, double offset, const std::vector<DampedSine>& start) {
  SineFit fit;
  Vector p = parameters_of(offset, start);
  Normal now = normal_at(record, p);
  const double exact = kExact * mean_of(record).squares;
  double damping = 1e-3;
  for (int n = 0; n < kIterations && !fit.converged && damping < 1e12;) {
    const Vector scale = scales_of(now.matrix);
    const Matrix scaled = scale.asDiagonal() * now.matrix * scale.asDiagonal();
    Matrix damped = scaled;
    damped.diagonal().array() += damping;
    const Vector step = scale.asDiagonal() * damped.ldlt().solve(scale.asDiagonal() * now.right).eval();
    const Vector next = p + step;
    const Normal there = next.allFinite() ? normal_at(record, next) : now;
    if (!(there.squares < now.squares)) {
      // where no step makes it less, the least is reached
      fit.converged = damping <= 1e-3 && step.cwiseQuotient(scale).norm() <= 1e-7 * std::sqrt(now.squares);
      damping *= 8, ++n;
      continue;
    }
    // Gauss-Newton's own measure: what the step takes of the residuals, against these
    fit.converged =
        step.cwiseQuotient(scale).norm() <= 1e-9 * std::sqrt(there.squares) || there.squares <= exact;
    p = next, now = there;
    damping = std::max(damping / 10, 1e-12), ++n;
  }
  // steps of Levenberg and Marquardt end at round-off: Gauss-Newton's would be as small
  const Vector scale = scales_of(now.matrix);
  const Vector left = scale.asDiagonal() * now.right;
  fit.converged = fit.converged || left.norm() <= 1e-6 * std::sqrt(now.squares);
  take_result(record, p, now, fit);
  fit.converged = fit.converged && fit.covariance.allFinite();
  return fit;
}

double nyquist_frequency(const RingDownRecord& record) {
  const double duration = record.time.back() - record.time.front();
  return std::numbers::pi * static_cast<double>(record.time.size() - 1) / duration;
}

}  // namespace fiberchain::compare
