#include "dem/motion/physics_of.hpp"

#include <algorithm>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

template <int Dim>
Physics physics_of(std::span<const Chain<Dim>> chains, const MarchOptions& options) {
  const bool any_damped = std::ranges::any_of(chains, [](const Chain<Dim>& c) { return damped(c.fiber); });
  const bool any_curved = std::ranges::any_of(chains, [](const Chain<Dim>& c) { return !c.natural.empty(); });
  const bool any_rolls =
      options.rolling != Rolling::none &&
      std::ranges::any_of(chains, [](const Chain<Dim>& c) { return c.fiber.rolling_friction > 0; });
  // what settles to an equilibrium has relaxed
  const bool any_branches = !options.settling_damping && std::ranges::any_of(chains, [](const Chain<Dim>& c) {
    return !c.fiber.branches.empty();
  });
  if (any_branches && options.fluid)
    throw InvalidInput("Maxwell branches are not allowed: they are not built for fibers in a fluid");
  const bool any_fails = std::ranges::any_of(chains, [](const Chain<Dim>& c) { return fails(c.fiber); });
  return {.dimension = Dim,
          .form = options.form,
          // rolling friction, branches, breaking and solved springs are built with dashpots only
          .damped = any_damped || any_rolls || any_branches || any_fails || options.solved == Solved::bonds,
          .settling_damping = options.settling_damping,
          .curved = from_poses(options.form) && any_curved,
          .solved = any_damped || options.solved == Solved::bonds ? options.solved : Solved::nothing,
          .rolling = any_rolls ? options.rolling : Rolling::none,
          .fluid = options.fluid,
          .branches = any_branches,
          .fails = any_fails};
}

template Physics physics_of<2>(std::span<const Chain<2>>, const MarchOptions&);
template Physics physics_of<3>(std::span<const Chain<3>>, const MarchOptions&);

}  // namespace fiberchain::dem
