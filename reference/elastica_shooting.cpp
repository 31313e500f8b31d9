#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/elastica.hpp"
#include "reference/elastica_bounds.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_ode.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

using detail::OdeIntegrator;

// v, v', dv/dv(0), dv'/dv(0), and the integrals of sin(theta)/c and (1 - cos(theta))/c^2 from the free end
enum Component : std::size_t { kV, kVPrime, kSlope, kSlopePrime, kRise, kShortening, kSize };
using State = std::array<double, kSize>;

/// w = c v and sigma = tau / kappa bring every load to order one: v'' = 1 + c tanh(c v) v'^2.
struct Scales {
  explicit Scales(double load) : c(std::min(1.0, load)), kappa(std::max(1.0, std::sqrt(load))) {}
  double c;
  double kappa;
};

State start_at(double v_tip) { return {v_tip, 0, 1, 0, 0, 0}; }

/// theta = -gd(w), so sin(theta) = -tanh(w) and 1 - cos(theta) = tanh(w) tanh(w/2), free of cancellation.
detail::OdeRhs equations(double c) {
  return [c](double, const double* y, double* dy) {
    const double tanh_w = std::tanh(c * y[kV]);
    dy[kV] = y[kVPrime];
    dy[kVPrime] = 1 + c * tanh_w * y[kVPrime] * y[kVPrime];
    dy[kSlope] = y[kSlopePrime];
    dy[kSlopePrime] = c * c * (1 - tanh_w * tanh_w) * y[kVPrime] * y[kVPrime] * y[kSlope] +
                      2 * c * tanh_w * y[kVPrime] * y[kSlopePrime];
    dy[kRise] = -tanh_w / c;
    dy[kShortening] = (tanh_w / c) * (std::tanh(c * y[kV] / 2) / c);
  };
}

OdeIntegrator integrator(const Scales& scales, const ShootingTolerances& tolerances) {
  return OdeIntegrator(kSize, equations(scales.c), {tolerances.absolute, tolerances.relative},
                       "Elastica by shooting");
}

struct Solution {
  double v_tip;
  State clamp;  ///< state at the clamp
};

Solution solve(double load, const Scales& scales, const ShootingTolerances& tolerances) {
  Solution solution{};
  const auto residual = [&](double v_tip) {
    solution = {v_tip, start_at(v_tip)};
    double tau = 0;
    integrator(scales, tolerances).advance(tau, scales.kappa, solution.clamp);
    return detail::ValueSlope{solution.clamp[kV], solution.clamp[kSlope]};
  };
  detail::find_root_newton(residual, detail::elastica_tip_bound(load) / scales.c, tolerances.root_step,
                           tolerances.max_iterations, "angle of the Elastica's free end");
  return solution;
}

double angle_at(const Scales& scales, double v) { return -2 * std::atan(std::tanh(scales.c * v / 2)); }

void check(double load, const ShootingTolerances& tolerances) {
  require_between("load", load, 0, max_elastica_load);
  require_positive("absolute tolerance", tolerances.absolute);
  require_positive("relative tolerance", tolerances.relative);
  require_positive("root_step", tolerances.root_step);
}

}  // namespace

TipState elastica_shooting(double load, const ShootingTolerances& tolerances) {
  check(load, tolerances);
  if (load == 0) return {0, 0, 0};
  const Scales scales(load);
  const Solution solution = solve(load, scales, tolerances);
  return {scales.c / scales.kappa * solution.clamp[kRise],
          scales.c * scales.c / scales.kappa * solution.clamp[kShortening], angle_at(scales, solution.v_tip)};
}

BeamShape elastica_shape(double load, std::size_t n) {
  check(load, {});
  require_between("n", static_cast<double>(n), 2, 1e7);
  BeamShape shape{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n),
                  std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    shape.x[i] = shape.s[i] = static_cast<double>(i) / static_cast<double>(n - 1);
  }
  if (load == 0) return shape;
  const Scales scales(load);
  const Solution solution = solve(load, scales, {});
  OdeIntegrator path = integrator(scales, {});
  State state = start_at(solution.v_tip);
  double tau = 0;
  for (std::size_t i = n; i-- > 1;) {
    path.advance(tau, scales.kappa * (1 - shape.s[i]), state);
    const double shortening = solution.clamp[kShortening] - state[kShortening];
    shape.y[i] = scales.c / scales.kappa * (solution.clamp[kRise] - state[kRise]);
    shape.x[i] = shape.s[i] - scales.c * scales.c / scales.kappa * shortening;
    shape.theta[i] = angle_at(scales, state[kV]);
  }
  return shape;
}

}  // namespace fiberchain::reference
