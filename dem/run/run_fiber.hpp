#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dem/equilibrium/stability.hpp"
#include "dem/scene/scene.hpp"
#include "dem/vibration/first_mode.hpp"

// Scenes of one fiber, run in memory: they write no files.
namespace fiberchain::dem {

/// A cantilever at rest, in the scene's own dimension.
template <int Dim>
struct RestState {
  Poses<Dim> poses;
  Imbalance residual;
  Stability stability;                     ///< in the scene's dimension, of the total form
  std::optional<std::int64_t> iterations;  ///< Newton iterations, if solved
  std::optional<std::int64_t> steps;       ///< time steps, if marched
};

/// Solves or marches the scene to rest.
/// @throws InvalidInput, NoConvergence (also where a march rests on an unstable equilibrium that the scene
/// does not allow), Diverged
template <int Dim>
RestState<Dim> find_rest(const CantileverScene& scene);

// Results in space, whatever the scene's dimension: a planar fiber lies at z = 0.
using Positions = std::vector<Vec<double, 3>>;

struct CantileverResult {
  Positions positions;  ///< of the spheres, from the clamp to the free end [m]
  Imbalance residual;
  Stability stability;  ///< in the scene's dimension, of the total form
};

/// The free end at one moment.
struct FreeEnd {
  double time;                        ///< since the release [s]
  Vec<double, 3> position, velocity;  ///< [m], [m/s]
  double energy;                      ///< elastic and kinetic [J]; 0 where the scene's physics has none
};

struct ReleaseResult {
  FirstMode mode;                ///< of the linear chain
  std::vector<FreeEnd> samples;  ///< the first is the moment of release
  double time_step;              ///< [s]
  Integrator integrator;
  std::string failure;  ///< why the run stopped early; "" if it did not
};

/// The centers of the spheres at one moment.
struct FiberShape {
  double time;          ///< [s]
  Positions positions;  ///< [m]
};

struct FlowResult {
  std::vector<FiberShape> samples;  ///< as many intervals as the scene asks for
  FlowRecord record;                ///< with the reason if the run stopped early
};

struct RodResult {
  RodPath path;
  std::optional<RodPath> branch;  ///< where the scene asks for one

  const RodPath& last() const { return branch ? *branch : path; }
};

/// @throws InvalidInput, NoConvergence; also for a branch of a bifurcation that the path does not have
RodResult run_scene(const RodScene& scene);

/// @throws InvalidInput, NoConvergence, Diverged
CantileverResult run_scene(const CantileverScene& scene);

/// @throws InvalidInput, also for an overdamped first mode; NoConvergence
ReleaseResult run_scene(const ReleaseScene& scene);

/// @throws InvalidInput
FlowResult run_scene(const FlowScene& scene);

}  // namespace fiberchain::dem
