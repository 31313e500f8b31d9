#include "reference/filament_buckling.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/beam_history.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Degrees of one parity, first, first + 2 ... below `end`: a coefficient each.
std::vector<int> degrees(int first, int end, int step) {
  std::vector<int> all;
  for (int n = first; n < end; n += step) all.push_back(n);
  return all;
}

/// Column k: coefficients of the y whose curvature L y'' is the orthonormal polynomial of degree n_k - 2. By
/// integrating twice, int P_j = (P_{j+1} - P_{j-1})/(2j + 1), in x = 2s/L; translation and rotation left out.
/// Triangular, and with it int y''^2 = |c|^2 for the coefficients c of the curvature.
MatrixXd from_curvature(const std::vector<int>& n) {
  const auto size = static_cast<Index>(n.size());
  MatrixXd f = MatrixXd::Zero(size, size);
  for (Index row = 0; row < size; ++row) {
    for (Index column = 0; column < size; ++column) {
      const int degree = n[static_cast<std::size_t>(row)];
      const int j = n[static_cast<std::size_t>(column)] - 2;
      double p = 0;  // coefficient of P_degree in the double integral of P_j
      if (degree == j + 2) p = 1.0 / ((2 * j + 1) * (2 * j + 3));
      if (degree == j) p = -2.0 / ((2 * j - 1) * (2 * j + 3));
      if (degree == j - 2) p = 1.0 / ((2 * j + 1) * (2 * j - 1));
      f(row, column) = p / 4 * std::sqrt((2 * j + 1) / (2.0 * degree + 1));
    }
  }
  return f;
}

/// q + n (n + 1)/2
VectorXd compression_diagonal(const std::vector<int>& n, double transverse_rate) {
  VectorXd d(static_cast<Index>(n.size()));
  for (Index i = 0; i < d.size(); ++i) {
    const double degree = n[static_cast<std::size_t>(i)];
    d(i) = transverse_rate + degree * (degree + 1) / 2;
  }
  return d;
}

/// One parity of the bending problem.
struct Parity {
  std::vector<int> n;
  MatrixXd shape;    ///< from_curvature
  VectorXd drive;    ///< compression_diagonal
  MatrixXd driving;  ///< shape^T diag(drive) shape
};

Parity parity(int mode, double transverse_rate) {
  const int first = mode % 2 == 1 ? 2 : 3;
  Parity p{degrees(first, filament_polynomials + 2, 2), {}, {}, {}};
  p.shape = from_curvature(p.n);
  p.drive = compression_diagonal(p.n, transverse_rate);
  p.driving = p.shape.transpose() * p.drive.asDiagonal() * p.shape;
  return p;
}

void require_mode(int mode, double transverse_rate) {
  require_between("mode", mode, 1, max_filament_mode);
  require_between("transverse_rate", transverse_rate, 0, 10);
}

/// sigma_0 - sigma = 1/eta: B c = eta (I/number + sigma_0 B - driving) c with sigma_0 above every growth
/// rate, so the matrix on the right is positive definite and the fastest modes have the largest eta: all
/// their digits.
FilamentMode mode_of(const Parity& p, double number, int rank) {
  // a uniform filament under the greatest tension, L^2/8, grows at most at q + number/256
  const double shift = p.drive(0) + number / 200;
  const MatrixXd b = p.shape.transpose() * p.shape;
  const Index size = b.rows();
  const MatrixXd right = MatrixXd::Identity(size, size) / number + shift * b - p.driving;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(b, right);
  const Index column = size - 1 - rank;
  if (solver.info() != Eigen::Success || !(solver.eigenvalues()(column) > 0)) {
    throw NoConvergence("growth rates of a compressed filament");
  }
  VectorXd a = p.shape * solver.eigenvectors().col(column);
  a.normalize();
  double end = 0;
  for (Index i = 0; i < size; ++i) end += a(i) * std::sqrt(2.0 * p.n[static_cast<std::size_t>(i)] + 1);
  if (end < 0) a = -a;
  FilamentMode mode{shift - 1 / solver.eigenvalues()(column),
                    std::vector<double>(filament_polynomials + 2, 0.0)};
  for (Index i = 0; i < size; ++i)
    mode.coefficients[static_cast<std::size_t>(p.n[static_cast<std::size_t>(i)])] = a(i);
  return mode;
}

}  // namespace

double buckling_threshold(int mode, double transverse_rate) {
  require_mode(mode, transverse_rate);
  // sigma = 0: driving c = c/number
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(parity(mode, transverse_rate).driving,
                                                       Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success) throw NoConvergence("buckling thresholds of a filament");
  return 1 / solver.eigenvalues()(solver.eigenvalues().size() - 1 - (mode - 1) / 2);
}

FilamentMode filament_mode(double number, int mode, double transverse_rate) {
  require_mode(mode, transverse_rate);
  require_positive("number", number);
  require_between("number", number, 0, max_filament_number);
  return mode_of(parity(mode, transverse_rate), number, (mode - 1) / 2);
}

std::vector<double> growth_rates(double number, int modes, double transverse_rate) {
  require_between("modes", modes, 1, max_filament_mode);
  std::vector<double> growth;
  for (int mode = 1; mode <= modes; ++mode)
    growth.push_back(filament_mode(number, mode, transverse_rate).growth);
  return growth;
}

std::vector<double> filament_deflection(const std::vector<double>& coefficients,
                                        const std::vector<double>& positions) {
  std::vector<double> y;
  for (const double s : positions) {
    require_between("position", s, -0.5, 0.5);
    const double x = 2 * s;
    double before = 0;
    double p = 1;
    double sum = 0;
    for (std::size_t n = 0; n < coefficients.size(); ++n) {
      const double degree = static_cast<double>(n);
      sum += coefficients[n] * std::sqrt(2 * degree + 1) * p;
      const double next = ((2 * degree + 1) * x * p - degree * before) / (degree + 1);
      before = p;
      p = next;
    }
    y.push_back(sum);
  }
  return y;
}

std::function<double(double)> shear_compression(double angle) {
  if (!(angle > 0 && angle < std::numbers::pi)) throw InvalidArgument("angle", angle, "above 0, below pi");
  const double start = 1 / std::tan(angle);
  return [start](double t) {
    const double cotangent = start + t;
    return -cotangent / (1 + cotangent * cotangent);
  };
}

FilamentHistory deflection_history(double number, const std::function<double(double)>& compression,
                                   const std::vector<double>& start, const std::vector<double>& times,
                                   const CvodeTolerances& tolerances) {
  require_positive("number", number);
  require_between("number", number, 0, max_filament_number);
  require_between("number of coefficients", static_cast<double>(start.size()), 2, filament_polynomials + 2);
  require_times(times);
  const auto size = static_cast<Index>(start.size());
  const VectorXd drive = compression_diagonal(degrees(0, static_cast<int>(size), 1), 1);
  MatrixXd bending = MatrixXd::Zero(size, size);
  if (size > 2) {
    const MatrixXd curvature = from_curvature(degrees(2, static_cast<int>(size), 1)).inverse();
    bending.bottomRightCorner(size - 2, size - 2) = curvature.transpose() * curvature / number;
  }
  const auto rhs = [&](double t, std::span<const double> a, std::span<double> rate) {
    const Eigen::Map<const VectorXd> value(a.data(), size);
    Eigen::Map<VectorXd>(rate.data(), size) = compression(t) * drive.cwiseProduct(value) - bending * value;
  };
  const auto jacobian = [&](double t, std::span<const double>, std::span<double> j) {
    Eigen::Map<MatrixXd> entries(j.data(), size, size);
    entries = -bending;
    entries.diagonal() += compression(t) * drive;
  };
  detail::Cvode cvode(CvodeMethod::bdf, rhs, jacobian, 0, start, tolerances, "deflection of a filament");
  FilamentHistory history;
  for (const double time : times) {
    const std::span<const double> a = time == 0 ? std::span<const double>(start) : cvode.advance(time);
    history.coefficients.emplace_back(a.begin(), a.end());
  }
  history.statistics = cvode.statistics();
  return history;
}

}  // namespace fiberchain::reference
