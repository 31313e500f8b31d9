#include "dem/vibration/first_mode.hpp"

#include <cmath>
#include <numbers>

#include "dem/chain/chain_state.hpp"
#include "dem/chain/residual.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using Motion = ChainVector<2>;

double inner_product(const Motion& a, const Motion& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

/// M u, zero at the clamped sphere.
Motion momentum(const Fiber& fiber, const Motion& u) {
  Motion p = u;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = p[i].cwiseProduct(sphere_inertias<2>(fiber, static_cast<int>(i))).eval();
  p[0].setZero();
  return p;
}

/// Repeats u <- K^-1 M u: the second mode, (omega_2/omega_1)^2 = 39, falls by that in each pass.
Motion undamped_mode(const Chain<2>& chain) {
  constexpr int passes = 16;
  const ChainFactors<3> K(stiffness<2>(chain, chain.poses, {{0}, {}}));
  const double length = fiber_length(chain.fiber);
  Motion u(chain.poses.size(), SphereVector<2>::Zero());
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double x = chain.poses[i].position[0] / length;
    u[i] << 0, x * x * length, 2 * x;
  }
  for (int n = 0; n < passes; ++n) {
    u = momentum(chain.fiber, u);
    K.solve_in_place(u);
    const double scale = length / u.back()[1];
    for (auto& motion : u) motion *= scale;
  }
  return u;
}

}  // namespace

FirstMode first_mode(const Fiber& fiber) {
  const Chain<2> chain = straight_chain<2>(fiber);
  const Motion u = undamped_mode(chain), Mu = momentum(fiber, u);
  Motion softened = Mu;  // K^-1 M u
  ChainFactors<3>(stiffness<2>(chain, chain.poses, {{0}, {}})).solve_in_place(softened);
  // m lambda^2 + c lambda + k = 0
  const double m = inner_product(u, Mu), k = m * m / inner_product(Mu, softened),
               c = -inner_product(u, dashpot_forces<2>(chain, chain.poses, u));
  const double frequency = std::sqrt(k / m), damping = c / (2 * std::sqrt(k * m));
  if (!(damping < 1))
    throw InvalidInput("bond damping: the first mode is overdamped, there is no vibration to watch");
  return {frequency, damping, 2 * std::numbers::pi / (frequency * std::sqrt(1 - damping * damping))};
}

}  // namespace fiberchain::dem
