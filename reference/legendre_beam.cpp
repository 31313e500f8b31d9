#include "reference/legendre_beam.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/errors.hpp"

namespace fiberchain::reference::detail {
namespace {

/// P_0 ... P_{count-1} at each x = 2 s - 1 (rows).
Eigen::MatrixXd legendre(const Eigen::VectorXd& s, int count) {
  Eigen::MatrixXd p(s.size(), count);
  const Eigen::ArrayXd x = 2 * s.array() - 1;
  p.col(0).setOnes();
  p.col(1) = x;
  for (int k = 1; k + 1 < count; ++k) {
    p.col(k + 1) = ((2 * k + 1) * x * p.col(k).array() - k * p.col(k - 1).array()) / (k + 1);
  }
  return p;
}

/// phi_k(s) = int_0^s sqrt(2k+1) P_k = (P_{k+1} - P_{k-1}) / (2 sqrt(2k+1)), phi_0 = s.
Eigen::MatrixXd integrated(const Eigen::VectorXd& s, int count) {
  const Eigen::MatrixXd p = legendre(s, count + 1);
  Eigen::MatrixXd phi(s.size(), count);
  phi.col(0) = s;
  for (int k = 1; k < count; ++k) phi.col(k) = (p.col(k + 1) - p.col(k - 1)) / (2 * std::sqrt(2.0 * k + 1));
  return phi;
}

/// Zeros of P_n by Newton's iteration from Tricomi's estimate, weights 1 / ((1 - x^2) P_n'(x)^2) for unit
/// length. (GSL's tables for arbitrary n are good to 1e-10 only.)
void set_gauss_points(LegendreBeam& beam, int n) {
  beam.nodes.resize(n);
  beam.weights.resize(n);
  for (int j = 0; j < n; ++j) {
    double x = -std::cos(std::numbers::pi * (j + 0.75) / (n + 0.5));
    double slope = 0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double previous = 1;
      double p = x;
      for (int k = 1; k < n; ++k) previous = std::exchange(p, ((2 * k + 1) * x * p - k * previous) / (k + 1));
      slope = n * (x * p - previous) / ((x - 1) * (x + 1));
      x -= p / slope;
    }
    beam.nodes(j) = (1 + x) / 2;
    beam.weights(j) = 1 / ((1 - x) * (1 + x) * slope * slope);
  }
}

}  // namespace

LegendreBeam legendre_beam(int modes, int nodes) {
  require_between("modes", modes, 2, 60);
  require_between("nodes", nodes, modes + 2, 200);
  LegendreBeam beam{{}, {}, {}, Eigen::VectorXd::Unit(modes, 0), Eigen::VectorXd::Ones(modes), {}};
  set_gauss_points(beam, nodes);
  beam.phi = integrated(beam.nodes, modes);
  // f -> its coefficients int p_i f -> sum of int_0^s p_i
  Eigen::MatrixXd p = legendre(beam.nodes, nodes);
  for (int i = 0; i < nodes; ++i) p.col(i) *= std::sqrt(2.0 * i + 1);
  beam.integral = integrated(beam.nodes, nodes) * p.transpose() * beam.weights.asDiagonal();
  return beam;
}

LegendreBeam in_modal_coordinates(const LegendreBeam& beam, const Eigen::MatrixXd& factor) {
  // stiffness 1: mass u = (1/omega^2) u, and u omega has unit mass
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(factor, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd omega = svd.singularValues().cwiseInverse();
  const Eigen::MatrixXd change = svd.matrixV() * omega.asDiagonal();
  LegendreBeam modal = beam;
  modal.phi = beam.phi * change;
  modal.phi_tip = change.transpose() * beam.phi_tip;
  modal.stiffness = omega.cwiseAbs2();
  return modal;
}

Eigen::MatrixXd mass_factor(const LegendreBeam& beam) {
  return beam.weights.cwiseSqrt().asDiagonal() * beam.integral * beam.phi;
}

}  // namespace fiberchain::reference::detail
