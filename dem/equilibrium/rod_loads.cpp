#include "dem/equilibrium/rod_loads.hpp"

#include <algorithm>
#include <numbers>

#include "dem/chain/self_weight.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

/// One sphere's share of a load.
struct SphereLoad {
  int sphere;
  V force, moment;
  bool turns;  ///< with the sphere
  V lever{};   ///< unit tangent t of a moment arm t x w that turns with the sphere where the load does not
  V across{};  ///< w of that arm, its factor l^2 / 12 included [N m]
};

double factor_of(bool steady, const LoadFactors& factors) { return steady ? factors.steady : factors.scaled; }

template <class Use>
void each_point_load(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
                     const Use& use) {
  for (const RodPointLoad& load : problem.point_loads) {
    const double factor = factor_of(load.steady, factors);
    V force = factor * load.force, moment = factor * load.moment;
    const bool follows = load.direction == LoadDirection::following;
    if (follows) {
      const Quaternion<double>& q = poses[static_cast<std::size_t>(load.sphere)].orientation;
      force = rotate(q, force);
      moment = rotate(q, moment);
    }
    use(SphereLoad{load.sphere, force, moment, follows});
  }
}

/// One end of a bond under a force per length w: l/2 w, and +- l^2/12 t x w where consistent.
template <class Use>
void bond_end_load(const RodProblem& problem, const Poses<3>& poses, const RodLineLoad& load, double factor,
                   int bond, bool first, const Use& use) {
  const int sphere = first ? bond : bond + 1;
  Quaternion<double> end = poses[static_cast<std::size_t>(sphere)].orientation;
  if (!problem.chain.natural.empty()) {
    const auto& natural = problem.chain.natural[static_cast<std::size_t>(bond)];
    end = end * (first ? natural.first : natural.second);
  }
  const bool follows = load.direction == LoadDirection::following;
  const V w = factor * (follows ? rotate(end, load.force) : load.force);
  const double l = arc_length(problem.chain.fiber);
  SphereLoad share{sphere, (l / 2) * w, {}, follows};
  if (problem.line_load_rule == LineLoads::consistent) {
    const V t = rotate(end, V{1, 0, 0}), arm = ((first ? 1.0 : -1.0) * l * l / 12) * w;
    share.moment = cross(t, arm);
    if (!follows) {
      share.lever = t;
      share.across = arm;
    }
  }
  use(share);
}

template <class Use>
void each_line_load(const RodProblem& problem, const Poses<3>& poses, const RodLineLoad& load,
                    const LoadFactors& factors, const Use& use) {
  const double factor = factor_of(load.steady, factors);
  if (factor == 0) return;
  for (int bond = load.first; bond < load.last; ++bond) {
    bond_end_load(problem, poses, load, factor, bond, true, use);
    bond_end_load(problem, poses, load, factor, bond, false, use);
  }
}

template <class Use>
void each_weight(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
                 const Use& use) {
  if (dot(problem.gravity, problem.gravity) == 0) return;
  const Fiber& fiber = problem.chain.fiber;
  if (fiber.mass == MassModel::spheres) {
    for (const Load<3>& load : self_weight<3>(fiber, problem.gravity)) {
      use(SphereLoad{load.sphere, factors.steady * load.force, {}, false});
    }
    return;
  }
  const double R = sphere_radius(fiber), per_length = fiber.material.density * std::numbers::pi * R * R;
  const RodLineLoad weight{
      .first = 0, .last = fiber.aspect_ratio, .force = per_length * problem.gravity, .steady = true};
  each_line_load(problem, poses, weight, factors, use);
}

template <class Use>
void each_load(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors, const Use& use) {
  each_point_load(problem, poses, factors, use);
  for (const RodLineLoad& load : problem.line_loads) each_line_load(problem, poses, load, factors, use);
  each_weight(problem, poses, factors, use);
}

}  // namespace

void add_loads(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
               ChainVector<3>& forces) {
  each_load(problem, poses, factors, [&](const SphereLoad& load) {
    forces[static_cast<std::size_t>(load.sphere)] += motion_of<3>(load.force, load.moment);
  });
}

void add_load_stiffness(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
                        ChainTangent<3>& K) {
  using tangent_detail::eigen;
  using tangent_detail::skew;
  each_load(problem, poses, factors, [&](const SphereLoad& load) {
    auto& block = K.diagonal[static_cast<std::size_t>(load.sphere)];
    if (load.turns) {  // d(F) = a x F
      block.topRightCorner<3, 3>() += skew(load.force);
      block.bottomRightCorner<3, 3>() += skew(load.moment);
    } else {  // d(t x w) = (a x t) x w = t (w.a) - (w.t) a
      const Eigen::Vector3d t = eigen(load.lever), w = eigen(load.across);
      block.bottomRightCorner<3, 3>() -= t * w.transpose() - w.dot(t) * Eigen::Matrix3d::Identity();
    }
  });
}

bool has_steady_loads(const RodProblem& problem) {
  const auto steady = [](const auto& load) { return load.steady; };
  return dot(problem.gravity, problem.gravity) > 0 || std::ranges::any_of(problem.point_loads, steady) ||
         std::ranges::any_of(problem.line_loads, steady);
}

}  // namespace fiberchain::dem
