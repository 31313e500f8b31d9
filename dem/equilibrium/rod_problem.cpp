#include "dem/equilibrium/rod_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "dem/chain/pivots.hpp"
#include "dem/equilibrium/rod_loads.hpp"
#include "dem/equilibrium/rod_supports.hpp"
#include "dem/equilibrium/stability.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

bool is_zero(const V& v) { return dot(v, v) == 0; }
bool is_finite(const V& v) { return std::isfinite(dot(v, v)); }

void require_sphere(const RodProblem& problem, int sphere, std::string_view what) {
  const int last = problem.chain.fiber.aspect_ratio;
  if (sphere < 0 || sphere > last) {
    throw InvalidInput(
        fmt::format("{} at sphere {} is not allowed: the rod has spheres 0 to {}", what, sphere, last));
  }
}

void require_finite(const V& v, std::string_view what, int sphere) {
  if (!is_finite(v)) {
    throw InvalidInput(fmt::format("{} at sphere {} is not allowed: it must be finite", what, sphere));
  }
}

void check_loads(const RodProblem& problem) {
  for (const RodPointLoad& load : problem.point_loads) {
    require_sphere(problem, load.sphere, "a load");
    require_finite(load.force, "a force", load.sphere);
    require_finite(load.moment, "a moment", load.sphere);
  }
  for (const RodLineLoad& load : problem.line_loads) {
    require_sphere(problem, load.first, "a line load");
    require_sphere(problem, load.last, "a line load");
    require_finite(load.force, "a line load", load.first);
    if (load.first >= load.last) {
      throw InvalidInput(fmt::format("a line load from sphere {} to {} is not allowed: it must go up",
                                     load.first, load.last));
    }
  }
  if (!is_finite(problem.gravity)) throw InvalidInput("gravity is not allowed: it must be finite");
}

bool holds_anything(const RodSupport& support) {
  const auto yes = [](bool held) { return held; };
  return std::ranges::any_of(support.hold_displacement, yes) ||
         std::ranges::any_of(support.hold_rotation, yes);
}

void check_support(const RodProblem& problem, const RodSupport& support) {
  const int sphere = support.sphere;
  require_sphere(problem, sphere, "a support");
  require_finite(support.moved, "a prescribed displacement", sphere);
  require_finite(support.turned, "a prescribed turn", sphere);
  const double size = support.axes.w * support.axes.w + dot(support.axes.v, support.axes.v);
  if (!(std::abs(size - 1) < 1e-9)) {
    throw InvalidInput(
        fmt::format("axes of the support at sphere {} are not allowed: no unit quaternion", sphere));
  }
  if (!holds_anything(support)) {
    throw InvalidInput(fmt::format("a support at sphere {} that holds nothing is not allowed", sphere));
  }
  if (!is_zero(support.turned) &&
      !std::ranges::all_of(support.hold_rotation, [](bool held) { return held; })) {
    throw InvalidInput(
        fmt::format("a prescribed turn at sphere {} is not allowed: all its turns must be held", sphere));
  }
  if (std::ranges::count(problem.supports, sphere, &RodSupport::sphere) > 1) {
    throw InvalidInput(fmt::format("two supports at sphere {} are not allowed", sphere));
  }
}

/// Everything that acts lies in the plane, and what turns does so about its normal.
void check_plane(const RodProblem& problem) {
  const auto require = [](bool in_plane, std::string_view what, int sphere) {
    if (!in_plane) {
      throw InvalidInput(
          fmt::format("{} at sphere {} is not allowed: the rod is planar, in x and y", what, sphere));
    }
  };
  const auto about_z = [](const V& v) { return v[0] == 0 && v[1] == 0; };
  for (const RodPointLoad& load : problem.point_loads) {
    require(load.force[2] == 0, "a force along z", load.sphere);
    require(about_z(load.moment), "a moment about x or y", load.sphere);
  }
  for (const RodLineLoad& load : problem.line_loads)
    require(load.force[2] == 0, "a line load along z", load.first);
  for (const RodSupport& support : problem.supports) {
    require(support.axes.v[0] == 0 && support.axes.v[1] == 0, "a support turned about x or y",
            support.sphere);
    require(support.moved[2] == 0 && about_z(support.turned), "a prescribed motion", support.sphere);
  }
  require(problem.gravity[2] == 0, "gravity along z", 0);
  for (std::size_t i = 0; i < problem.chain.poses.size(); ++i) {
    const V along = axis(problem.chain.poses[i]);
    require(std::abs(along[2]) < 1e-9 &&
                std::abs(problem.chain.poses[i].position[2] - problem.chain.poses[0].position[2]) <
                    1e-9 * fiber_length(problem.chain.fiber),
            "a rest shape out of it", static_cast<int>(i));
  }
}

/// The unloaded rod at rest has no motion without energy.
void check_held(const RodProblem& problem) {
  RodProblem bare{.chain = problem.chain, .supports = problem.supports, .planar = problem.planar};
  const RodSystem system = rod_system(bare, bare.chain.poses, bare.chain.poses, 0);
  if (negative_pivots(held_tangent(bare, system, zero_eigenvalue(bare.chain))) > 0) {
    throw InvalidInput(
        "supports are not enough: the rod can move or turn without bending (a rod between two balls turns "
        "about "
        "their line: hold that turn at one end)");
  }
}

/// Whether a moment on a sphere turns it about an axis fixed in space, or not at all.
bool turns_about_one_axis(const RodProblem& problem, int sphere) {
  if (problem.planar) return true;
  const auto support = std::ranges::find(problem.supports, sphere, &RodSupport::sphere);
  if (support == problem.supports.end()) return false;
  const auto& hold = support->hold_rotation;
  return hold[0] + hold[1] + hold[2] >= 2;
}

}  // namespace

void check(const RodProblem& problem) {
  check(problem.chain.fiber);
  refuse_branches(problem.chain.fiber, "rods");
  const auto spheres = static_cast<std::size_t>(problem.chain.fiber.aspect_ratio) + 1;
  if (problem.chain.fiber.aspect_ratio > most_rod_bonds) {
    throw InvalidInput(fmt::format(
        "{} bonds are not allowed: at most {}, rounding of the stretch leaves no more of the bending",
        problem.chain.fiber.aspect_ratio, most_rod_bonds));
  }
  if (problem.chain.poses.size() != spheres || (!problem.start.empty() && problem.start.size() != spheres)) {
    throw InvalidInput(fmt::format("poses are not allowed: the rod has {} spheres", spheres));
  }
  if (problem.supports.empty())
    throw InvalidInput("supports = none is not allowed: an equilibrium needs one");
  for (const RodSupport& support : problem.supports) check_support(problem, support);
  check_loads(problem);
  if (problem.planar) check_plane(problem);
  check_held(problem);
}

ChainVector<3> rod_forces(const RodProblem& problem, const Poses<3>& poses, double factor) {
  ChainVector<3> forces = bond_forces(problem.chain, poses);
  add_loads(problem, poses, {.steady = 1, .scaled = factor}, forces);
  return forces;
}

ChainTangent<3> rod_stiffness(const RodProblem& problem, const Poses<3>& poses, double factor) {
  ChainTangent<3> K = stiffness(problem.chain, poses, Boundary<3>{});
  add_load_stiffness(problem, poses, {.steady = 1, .scaled = factor}, K);
  return K;
}

bool has_potential(const RodProblem& problem) {
  for (const RodPointLoad& load : problem.point_loads) {
    if (load.direction == LoadDirection::following && !is_zero(load.force)) return false;
    if (!is_zero(load.moment) && !turns_about_one_axis(problem, load.sphere)) return false;
  }
  return std::ranges::none_of(problem.line_loads, [](const RodLineLoad& load) {
    return load.direction == LoadDirection::following && !is_zero(load.force);
  });
}

ChainVector<3> rod_reactions(const RodProblem& problem, const Poses<3>& poses, double factor) {
  const ChainVector<3> forces = rod_forces(problem, poses, factor);
  ChainVector<3> reactions;
  for (const RodSupport& support : problem.supports) {
    reactions.push_back(-forces[static_cast<std::size_t>(support.sphere)]);
  }
  return reactions;
}

}  // namespace fiberchain::dem
