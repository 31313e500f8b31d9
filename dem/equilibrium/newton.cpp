#include "dem/equilibrium/newton.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "dem/equilibrium/stability.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
void check_boundary(const Chain<Dim>& chain, const Boundary<Dim>& boundary) {
  const int last = chain.fiber.aspect_ratio;
  const auto require_sphere = [&](int sphere) {
    if (sphere < 0 || sphere > last) {
      throw InvalidInput(
          fmt::format("sphere = {} is not allowed: the chain has spheres 0 to {}", sphere, last));
    }
  };
  if (boundary.clamped.empty())
    throw InvalidInput("clamped = none is not allowed: an equilibrium needs a clamp");
  for (const int sphere : boundary.clamped) require_sphere(sphere);
  for (const Load<Dim>& load : boundary.loads) {
    require_sphere(load.sphere);
    if (!std::isfinite(dot(load.force, load.force)) || !std::isfinite(dot(load.moment, load.moment))) {
      throw InvalidInput(fmt::format("load at sphere {} is not allowed: it must be finite", load.sphere));
    }
  }
}

/// Loads on the way between two sets: (1 - factor) of the first and factor of the second.
template <int Dim>
Boundary<Dim> between(const Boundary<Dim>& from, const Boundary<Dim>& to, double factor) {
  Boundary<Dim> now{to.clamped, {}};
  for (Load<Dim> load : from.loads) {
    now.loads.push_back({load.sphere, (1 - factor) * load.force, (1 - factor) * load.moment});
  }
  for (Load<Dim> load : to.loads)
    now.loads.push_back({load.sphere, factor * load.force, factor * load.moment});
  return now;
}

/// A turn of more than this in one Newton step leaves the range where the step means anything.
constexpr double largest_turn = 1.0;

/// A slender chain's stretch stiffness over its bending stiffness, 16 r_f^3, times the rounding of a position
/// bounds how small a Newton step can get; steps that stop shrinking below this are there.
constexpr double round_off_step = 1e-6;

/// Whether a chain has come to turn against the way it set out to, the load's own: onto another branch of
/// equilibria.
template <int Dim>
bool turned_back(const ChainVector<Dim>& first, const ChainVector<Dim>& sum) {
  double product = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    product += first[i].template tail<spin_size<Dim>>().dot(sum[i].template tail<spin_size<Dim>>());
  }
  return product < 0;
}

template <int Dim>
std::optional<Poses<Dim>> newton(const Chain<Dim>& chain, Poses<Dim> poses, const Boundary<Dim>& boundary,
                                 double tolerance, const SolveOptions& options, SolveStatistics& statistics) {
  const double length = fiber_length(chain.fiber);
  double previous = largest_turn;
  ChainVector<Dim> first, sum(poses.size(), SphereVector<Dim>::Zero());
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const ChainVector<Dim> motion = remaining_motion(chain, poses, boundary);
    ++statistics.newton_iterations;
    const double step = size_of<Dim>(motion, length);
    const bool at_round_off = step < round_off_step && step > 0.25 * previous;
    if (!(step <= largest_turn) || (iteration > 2 && step > 2 * previous && !at_round_off))
      return std::nullopt;
    move(chain, boundary, poses, motion);
    if (iteration == 0) first = motion;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += motion[i];
    // quadratic convergence: the step taken from below the tolerance ends at round-off
    if (previous < tolerance || step == 0 || at_round_off) {
      if (turned_back<Dim>(first, sum)) return std::nullopt;
      return poses;
    }
    previous = step;
  }
  return std::nullopt;
}

/// Load steps below this part of the largest do not try to stay on a stable path by getting smaller: they
/// leave the unstable one along its lowest mode.
constexpr double least_part_of_step = 1.0 / 64;

/// Off an unstable equilibrium along its lowest mode, `amount` [L, rad] of it, then down in energy to a
/// stable one.
template <int Dim>
Poses<Dim> down_from(const Chain<Dim>& chain, Poses<Dim> poses, const Boundary<Dim>& boundary,
                     const ChainVector<Dim>& mode, double amount, double tolerance,
                     SolveStatistics& statistics) {
  ChainVector<Dim> kick = mode;
  for (auto& part : kick) part *= amount;
  move(chain, boundary, poses, kick);
  return descend(chain, std::move(poses), boundary, tolerance, statistics.newton_iterations);
}

/// Of the two stable equilibria on either side of an unstable one, that of less energy; the one the mode
/// points to where they are equal.
template <int Dim>
Poses<Dim> buckled(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary,
                   double tolerance, SolveStatistics& statistics) {
  constexpr double amount = 0.02, tie = 1e-10;
  const ChainVector<Dim> mode = lowest_mode(chain, poses, boundary).mode;
  Poses<Dim> ahead = down_from(chain, poses, boundary, mode, amount, tolerance, statistics);
  Poses<Dim> behind = down_from(chain, poses, boundary, mode, -amount, tolerance, statistics);
  const double energy_ahead = potential_energy(chain, ahead, boundary),
               energy_behind = potential_energy(chain, behind, boundary);
  ++statistics.bucklings;
  return energy_behind < energy_ahead - tie * std::abs(energy_ahead) ? behind : ahead;
}

}  // namespace

template <int Dim>
ChainVector<Dim> remaining_motion(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                  const Boundary<Dim>& boundary) {
  ChainVector<Dim> motion = net_forces(chain, poses, boundary, 1.0);
  ChainTangent<Dim> K = stiffness(chain, poses, boundary);
  solve_in_place(K, motion);
  return motion;
}

template <int Dim>
ChainVector<Dim> linear_response(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                 const Boundary<Dim>& boundary) {
  ChainVector<Dim> motion = applied_loads(boundary, static_cast<int>(poses.size()));
  ChainTangent<Dim> K = stiffness(chain, poses, boundary);
  solve_in_place(K, motion);
  return motion;
}

template <int Dim>
Equilibrium<Dim> continue_equilibrium(const Chain<Dim>& chain, const Poses<Dim>& start,
                                      const Boundary<Dim>& from, const Boundary<Dim>& boundary,
                                      const SolveOptions& options) {
  check_boundary(chain, from);
  check_boundary(chain, boundary);
  SolveStatistics statistics{};
  Poses<Dim> poses = start;
  const double largest_step = 1.0 / std::max(options.load_steps, 1);
  double factor = 0, step = largest_step;
  Stability stability = Stability::undecided;
  while (factor < 1) {
    const double next = step >= 1 - factor ? 1.0 : factor + step;
    const double tolerance = next == 1.0 ? options.tolerance : 1e-3;
    const Boundary<Dim> loads = between(from, boundary, next);
    auto found = newton(chain, poses, loads, tolerance, options, statistics);
    if (found && (!options.allow_unstable || next == 1.0)) stability = stability_of(chain, *found, loads);
    if (found && !options.allow_unstable && stability == Stability::unstable) {
      if (step > least_part_of_step * largest_step) {
        found.reset();
      } else {
        found = buckled(chain, *found, loads, tolerance, statistics);
        stability = stability_of(chain, *found, loads);
      }
    }
    if (found) {
      poses = *found;
      factor = next;
      step = std::min(2 * step, largest_step);
      ++statistics.load_steps;
    } else {
      step /= 2;
      ++statistics.halvings;
    }
    if (step < options.smallest_load_step || statistics.load_steps > options.max_load_steps) {
      throw NoConvergence(
          fmt::format("no equilibrium found beyond {:.6g} of the load ({} load steps, {} Newton iterations): "
                      "the chain may "
                      "be unstable there",
                      factor, statistics.load_steps, statistics.newton_iterations));
    }
  }
  const Imbalance residual =
      imbalance(poses, net_forces(chain, poses, boundary, 1.0), boundary, fiber_length(chain.fiber));
  return {std::move(poses), residual, statistics, stability};
}

template <int Dim>
Equilibrium<Dim> solve_equilibrium(const Chain<Dim>& chain, const Boundary<Dim>& boundary,
                                   const SolveOptions& options) {
  return continue_equilibrium(chain, chain.poses, Boundary<Dim>{boundary.clamped, {}}, boundary, options);
}

template ChainVector<2> remaining_motion<2>(const Chain<2>&, const Poses<2>&, const Boundary<2>&);
template ChainVector<3> remaining_motion<3>(const Chain<3>&, const Poses<3>&, const Boundary<3>&);
template ChainVector<2> linear_response<2>(const Chain<2>&, const Poses<2>&, const Boundary<2>&);
template ChainVector<3> linear_response<3>(const Chain<3>&, const Poses<3>&, const Boundary<3>&);
template Equilibrium<2> continue_equilibrium<2>(const Chain<2>&, const Poses<2>&, const Boundary<2>&,
                                                const Boundary<2>&, const SolveOptions&);
template Equilibrium<3> continue_equilibrium<3>(const Chain<3>&, const Poses<3>&, const Boundary<3>&,
                                                const Boundary<3>&, const SolveOptions&);
template Equilibrium<2> solve_equilibrium<2>(const Chain<2>&, const Boundary<2>&, const SolveOptions&);
template Equilibrium<3> solve_equilibrium<3>(const Chain<3>&, const Boundary<3>&, const SolveOptions&);

}  // namespace fiberchain::dem
