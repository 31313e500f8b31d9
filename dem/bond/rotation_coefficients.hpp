#pragma once

#include <Eigen/Core>
#include <cmath>

namespace fiberchain::dem::tangent_detail {

/// Coefficients of the rotation maps as functions of w = |Omega|^2:
/// c = h / sin h, b = (1 - c) / w, k = tan(|Omega|/4) / |Omega|, with their derivatives by w.
struct RotationCoefficients {
  double c, c_w, b, b_w, k, k_w;
};

inline RotationCoefficients rotation_coefficients_series(double w) {
  constexpr double a1 = 1.0 / 24, a2 = 7.0 / 5760, a3 = 31.0 / 967680, a4 = 127.0 / 154828800,
                   a5 = 73.0 / 3503554560;
  constexpr double t1 = 1.0 / 192, t2 = 1.0 / 7680, t3 = 17.0 / 5160960, t4 = 31.0 / 371589120;
  return {1 + w * (a1 + w * (a2 + w * (a3 + w * (a4 + w * a5)))),
          a1 + w * (2 * a2 + w * (3 * a3 + w * (4 * a4 + w * 5 * a5))),
          -(a1 + w * (a2 + w * (a3 + w * (a4 + w * a5)))),
          -(a2 + w * (2 * a3 + w * (3 * a4 + w * 4 * a5))),
          0.25 + w * (t1 + w * (t2 + w * (t3 + w * t4))),
          t1 + w * (2 * t2 + w * (3 * t3 + w * 4 * t4))};
}

inline RotationCoefficients rotation_coefficients(double w) {
  if (w < 0.04) return rotation_coefficients_series(w);
  const double angle = std::sqrt(w), h = angle / 2, t = std::tan(angle / 4);
  const double c = h / std::sin(h);
  const double c_w = (std::sin(h) - h * std::cos(h)) / (std::sin(h) * std::sin(h)) / (4 * angle);
  const double b = (1 - c) / w;
  const double k = t / angle;
  return {c, c_w, b, -(c_w + b) / w, k, ((1 + t * t) / 4 - k) / (2 * w)};
}

/// d(S^-1 m)/dOmega at fixed m, with S^-1 m = c m + b Omega (Omega.m)
inline Eigen::Matrix3d conjugate_derivative(const RotationCoefficients& q, const Eigen::Vector3d& Omega,
                                            const Eigen::Vector3d& m) {
  const double along = Omega.dot(m);
  return 2 * (q.c_w * m + q.b_w * along * Omega) * Omega.transpose() +
         q.b * (along * Eigen::Matrix3d::Identity() + Omega * m.transpose());
}

}  // namespace fiberchain::dem::tangent_detail
