#pragma once

#include "dem/scene/scene.hpp"

// From a scene of one fiber to what the solvers take: Dim 2 for planar scenes, 3 for spatial ones.
namespace fiberchain::dem {

template <int Dim>
struct CantileverCase {
  Chain<Dim> chain;
  Boundary<Dim> boundary;
};

/// The straight chain, its clamp and its load.
template <int Dim>
CantileverCase<Dim> build_cantilever(const CantileverScene& scene);

/// The chain let go from its equilibrium under the load; times are counted by `period` [s], that of the first
/// mode. Throws NoConvergence.
template <int Dim>
Release<Dim> build_release(const ReleaseScene& scene, double period);

/// Whether a release has an energy to follow: explicit schemes have none to speak of where rolling friction
/// acts.
bool has_energy(const ReleaseScene& scene);

/// The straight fiber's spheres on the start's curve, center of mass at the origin. Bonds keep their length:
/// their angle to the line is the curve's slope, which is exact as the bend vanishes.
template <int Dim>
Poses<Dim> start_poses(const Fiber& fiber, const FlowStart& start);

template <int Dim>
FlowCase<Dim> build_flow(const FlowScene& scene);

/// From 0 to `duration`, that many intervals apart.
std::vector<double> even_times(double duration, int intervals);

}  // namespace fiberchain::dem
