#include "reference/jeffery.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <unsupported/Eigen/MatrixFunctions>

#include "reference/beam_history.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double largest_aspect_ratio = 1e7;
constexpr double unbounded = std::numeric_limits<double>::infinity();

Matrix3d matrix(const VelocityGradient& gradient) {
  Matrix3d g;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) g(i, j) = gradient[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return g;
}

/// Omega + Lambda E
Matrix3d carrying_gradient(double bretherton, const Matrix3d& g) {
  return (g - g.transpose()) / 2 + bretherton * (g + g.transpose()) / 2;
}

Vector3d unit(const Direction& p) {
  const Vector3d v(p[0], p[1], p[2]);
  const double length = v.stableNorm();
  require_positive("length of the direction", length);
  return v / length;
}

Direction direction(const Vector3d& v) { return {v(0), v(1), v(2)}; }

void require_aspect_ratio(double aspect_ratio) {
  require_positive("aspect_ratio", aspect_ratio);
  require_between("aspect_ratio", aspect_ratio, 0, largest_aspect_ratio);
}

void validate(const JefferyOrbit& orbit) {
  require_aspect_ratio(orbit.aspect_ratio);
  require_positive("rate", orbit.rate);
  if (!(orbit.constant >= 0)) throw InvalidArgument("constant", orbit.constant, "0 to infinity");
  require_between("phase", orbit.phase, -std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::max());
}

}  // namespace

VelocityGradient simple_shear(double rate) {
  VelocityGradient gradient{};
  gradient[0][1] = rate;
  return gradient;
}

double bretherton_constant(double aspect_ratio) {
  require_aspect_ratio(aspect_ratio);
  return (aspect_ratio - 1) * (aspect_ratio + 1) / (aspect_ratio * aspect_ratio + 1);
}

double equivalent_aspect_ratio(double bretherton) {
  if (!(std::abs(bretherton) < 1)) throw InvalidArgument("bretherton", bretherton, "above -1, below 1");
  return std::sqrt((1 + bretherton) / (1 - bretherton));
}

Direction jeffery_rate(double bretherton, const VelocityGradient& gradient, const Direction& p) {
  const Vector3d v(p[0], p[1], p[2]);
  const Matrix3d g = matrix(gradient);
  // p . Omega p = 0, so only E is left in the product
  return direction(carrying_gradient(bretherton, g) * v - bretherton * v.dot(g * v) * v);
}

double jeffery_period(double aspect_ratio, double rate) {
  require_aspect_ratio(aspect_ratio);
  require_positive("rate", rate);
  return 2 * std::numbers::pi * (aspect_ratio + 1 / aspect_ratio) / rate;
}

double orbit_constant(double aspect_ratio, const Direction& p) {
  require_aspect_ratio(aspect_ratio);
  const Vector3d v = unit(p);
  return v(2) == 0 ? unbounded : std::hypot(v(1), v(0) / aspect_ratio) / std::abs(v(2));
}

JefferyOrbit jeffery_orbit(double aspect_ratio, double rate, const Direction& p) {
  require_positive("rate", rate);
  const double constant = orbit_constant(aspect_ratio, p);
  const double sign = p[2] < 0 ? -1 : 1;
  const double phase = constant == 0 ? 0 : std::atan2(sign * p[0] / aspect_ratio, sign * p[1]);
  return {aspect_ratio, rate, constant, phase, p[2] < 0};
}

double bounded_orbit_constant(double constant) {
  if (!(constant >= 0)) throw InvalidArgument("constant", constant, "0 to infinity");
  return std::isinf(constant) ? 1 : constant / (1 + constant);
}

Direction direction_on_orbit(const JefferyOrbit& orbit, double t) {
  validate(orbit);
  const double r = orbit.aspect_ratio;
  const double tau = orbit.phase + orbit.rate * t / (r + 1 / r);
  const bool in_plane = std::isinf(orbit.constant);
  const double across = in_plane ? 1 : orbit.constant;
  const Vector3d v(across * r * std::sin(tau), across * std::cos(tau), in_plane ? 0 : 1);
  return direction((orbit.reversed ? -1 : 1) * v.stableNormalized());
}

double mean_axial_spin(const JefferyOrbit& orbit) {
  validate(orbit);
  if (std::isinf(orbit.constant)) return 0;
  double a = std::hypot(1, orbit.constant);
  double b = std::hypot(1, orbit.constant * orbit.aspect_ratio);
  for (int iteration = 0; iteration < 60 && std::abs(a - b) > 1e-15 * a; ++iteration) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return (orbit.reversed ? 1 : -1) * orbit.rate / (2 * a);
}

Direction jeffery_by_exponential(double bretherton, const VelocityGradient& gradient, const Direction& start,
                                 double t) {
  const Matrix3d a = carrying_gradient(bretherton, matrix(gradient)) * t;
  require_between("|Omega + Lambda E| t", a.norm(), 0, 300);
  const Matrix3d carried = a.exp();
  return direction((carried * unit(start)).normalized());
}

JefferyHistory jeffery_by_cvode(double bretherton, const std::function<VelocityGradient(double)>& gradient,
                                const Direction& start, const std::vector<double>& times,
                                const CvodeTolerances& tolerances) {
  require_between("bretherton", bretherton, -1e6, 1e6);
  require_times(times);
  const Direction initial = direction(unit(start));
  const auto rhs = [&](double t, std::span<const double> p, std::span<double> rate) {
    const Direction d = jeffery_rate(bretherton, gradient(t), {p[0], p[1], p[2]});
    for (std::size_t i = 0; i < 3; ++i) rate[i] = d[i];
  };
  const auto jacobian = [&](double t, std::span<const double> p, std::span<double> entries) {
    const Matrix3d g = matrix(gradient(t));
    const Vector3d v(p[0], p[1], p[2]);
    Eigen::Map<Matrix3d> j(entries.data());
    j = carrying_gradient(bretherton, g) - bretherton * v.dot(g * v) * Matrix3d::Identity() -
        bretherton * v * ((g + g.transpose()) * v).transpose();
  };
  detail::Cvode cvode(CvodeMethod::adams, rhs, jacobian, 0, initial, tolerances, "Jeffery's equation");
  JefferyHistory history;
  for (const double time : times) {
    const std::span<const double> p = time == 0 ? std::span<const double>(initial) : cvode.advance(time);
    history.directions.push_back({p[0], p[1], p[2]});
  }
  history.statistics = cvode.statistics();
  return history;
}

JefferyHistory jeffery_by_cvode(double bretherton, const VelocityGradient& gradient, const Direction& start,
                                const std::vector<double>& times, const CvodeTolerances& tolerances) {
  return jeffery_by_cvode(
      bretherton, [&](double) { return gradient; }, start, times, tolerances);
}

}  // namespace fiberchain::reference
