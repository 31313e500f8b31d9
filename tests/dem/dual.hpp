#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

/// Eigen's AutoDiffScalar without its expression types, so that `auto`-free templates accept it.
template <int N>
struct Dual {
  using Scalar = Eigen::AutoDiffScalar<Eigen::Matrix<double, N, 1>>;
  Scalar x;

  Dual() : x(0.0) {}
  explicit Dual(double value) : x(value) { x.derivatives().setZero(); }
  Dual(double value, int variable) : x(value, N, variable) {}
  explicit Dual(Scalar scalar) : x(std::move(scalar)) {}

  double value() const { return x.value(); }
  double derivative(int i) const { return x.derivatives()[i]; }

  friend Dual operator+(const Dual& a, const Dual& b) { return Dual(Scalar(a.x + b.x)); }
  friend Dual operator-(const Dual& a, const Dual& b) { return Dual(Scalar(a.x - b.x)); }
  friend Dual operator*(const Dual& a, const Dual& b) { return Dual(Scalar(a.x * b.x)); }
  friend Dual operator/(const Dual& a, const Dual& b) { return Dual(Scalar(a.x / b.x)); }
  friend Dual operator-(const Dual& a) { return Dual(Scalar(-a.x)); }
  friend Dual sqrt(const Dual& a) { return Dual(Scalar(sqrt(a.x))); }
  friend Dual sin(const Dual& a) { return Dual(Scalar(sin(a.x))); }
  friend Dual cos(const Dual& a) { return Dual(Scalar(cos(a.x))); }
  friend Dual atan(const Dual& a) { return Dual(Scalar(atan2(a.x, Scalar(1.0)))); }
};
