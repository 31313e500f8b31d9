#include "dem/vibration/choose.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dem/model/errors.hpp"
#include "dem/motion/stiff_limits.hpp"

namespace fiberchain::dem {
namespace {

/// Time of one bond in one step of a chain alone, over that of the lagged leapfrog, which then runs along the
/// lanes (measured, rounded: only their order matters).
struct Cost {
  double lagged, solved, stiff, implicit;
};
constexpr Cost planar_cost{1, 14, 16, 90}, spatial_cost{1, 22, 24, 100};

/// Damping ratio of the first mode by the dashpots, xi_f = tau w / 2 with bending's retardation time tau.
double first_mode_damping(const Fiber& fiber, double frequency) {
  return 0.5 * frequency * bond_dashpot(fiber).bend / bond_stiffness(fiber).bend;
}

struct Candidate {
  Integrator integrator;
  double step;  ///< largest that keeps the error [s]
  double cost;  ///< of a bond over a period
};

/// Largest turn of the free end in an implicit step [rad]: beyond, Newton's method halves steps of a sudden
/// release (measured).
constexpr double largest_newton_turn = 0.02;

/// Largest w dt with a w dt + b (w dt)^2 <= error.
double largest_angle(double a, double b, double error) {
  return 2 * error / (a + std::sqrt(a * a + 4 * b * error));
}

}  // namespace

template <int Dim>
IntegratorChoice choose_integrator(const Release<Dim>& release, const ReleaseOptions& options) {
  if (!(options.error > 0) || !std::isfinite(options.error)) {
    throw InvalidInput(
        fmt::format("error = {} is not allowed: it must be finite and greater than 0", options.error));
  }
  const Fiber& fiber = release.chain.fiber;
  const Cost cost = Dim == 2 ? planar_cost : spatial_cost;
  const double w = 2 * std::numbers::pi / release.period, xi_f = first_mode_damping(fiber, w);
  const auto candidate = [&](Integrator integrator, double a, double b, double per_step) {
    const double step =
        std::min(largest_angle(a, b, options.error) / w, 0.8 * stable_release_step(fiber, integrator));
    return Candidate{integrator, step, per_step * release.period / step};
  };
  const auto implicit = [&] {
    Candidate own = candidate(Integrator::implicit, 0, 1.0 / 6, cost.implicit);
    // the tip of a beam turns by about 1.4 a/L as it deflects by a
    const double longest = largest_newton_turn / (1.4 * std::max(swing(release), 1e-9) * w);
    own.cost *= std::max(1.0, own.step / longest);
    own.step = std::min(own.step, longest);
    return own;
  };
  std::vector<Candidate> all{candidate(Integrator::leapfrog, xi_f / 2, 1.0 / 24, cost.lagged)};
  if (fiber.rolling_friction == 0) {
    const bool branches = !fiber.branches.empty();
    if (damped(fiber) && !branches)
      all.push_back(candidate(Integrator::leapfrog_damped, 0, 1.0 / 24, cost.solved));
    Candidate stiff = candidate(Integrator::leapfrog_stiff, 0, stiff_beta / 2 + 1.0 / 24, cost.stiff);
    const double bearable = stiff_release_step(release, safe_turn);
    stiff.cost *= std::max(1.0, stiff.step / bearable);
    stiff.step = std::min(stiff.step, bearable);
    all.push_back(stiff);
    if (!branches) all.push_back(implicit());
  }
  const Candidate best = *std::min_element(
      all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::string others;
  for (const Candidate& c : all) {
    if (c.integrator != best.integrator) {
      others +=
          fmt::format("{}{} {:.2g}", others.empty() ? "" : ", ", name(c.integrator), c.cost / best.cost);
    }
  }
  const double t_b = bond_time_step(fiber);
  return {best.integrator, best.step / t_b,
          fmt::format(
              "{} with dt = {:.4g} t_b is the cheapest that keeps an error of {:.2g}{}",
              name(best.integrator), best.step / t_b, options.error,
              others.empty() ? std::string(" and knows rolling friction") : "; times its cost: " + others)};
}

template IntegratorChoice choose_integrator<2>(const Release<2>&, const ReleaseOptions&);
template IntegratorChoice choose_integrator<3>(const Release<3>&, const ReleaseOptions&);

}  // namespace fiberchain::dem
