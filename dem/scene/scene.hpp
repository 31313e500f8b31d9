#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/rod_path.hpp"
#include "dem/flow/integrate_in_flow.hpp"
#include "dem/model/fiber.hpp"
#include "dem/scene/key_declaration.hpp"
#include "dem/scene/packing_scene.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/scene_text.hpp"
#include "dem/vibration/release.hpp"

/// Scenes as values, and their reader: YAML, quantities with units, nothing guessed.
namespace fiberchain::dem {

enum class Dimension { planar, spatial };
enum class Method { solve, march };

constexpr std::string_view name(Dimension dimension) {
  return dimension == Dimension::planar ? "planar" : "spatial";
}
constexpr std::string_view name(Method method) { return method == Method::solve ? "solve" : "march"; }

/// A straight fiber, clamped at its first sphere, with a dead load at its last.
struct CantileverScene {
  Dimension dimension = Dimension::planar;
  Fiber fiber;
  double load;                                  ///< P L^2 / (E I) [-]
  std::array<double, 3> direction = {0, 1, 0};  ///< of the load, unit vector; the fiber lies along x
  std::array<double, 3> gravity = {0, 0, 0};    ///< acceleration that gives every sphere a weight [m/s^2]
  Method method = Method::solve;
  bool allow_unstable = false;  ///< an unstable equilibrium is an answer too
  RelaxOptions march = {};      ///< with the form of the bond law; solving has the total form only
  DampingSummary damping = {};  ///< of the material; an equilibrium is the relaxed one
};

/// What pulls at the free end.
struct EndPull {
  double load;                                  ///< P L^2 / (E I) [-]
  std::array<double, 3> direction = {0, 1, 0};  ///< unit vector; the fiber lies along x
};

/// The cantilever held under its load, then let go.
struct ReleaseScene {
  Dimension dimension = Dimension::planar;
  Fiber fiber;
  EndPull pull;
  double periods = 10;          ///< of the first mode, how long it is watched
  ReleaseOptions motion = {};   ///< integrator, form, steps, samples
  DampingSummary damping = {};  ///< of the material
};

/// Where a free fiber starts: its center of mass at the origin, where the flow is at rest. It is straight at
/// rest, so that a bend strains it.
struct FlowStart {
  std::array<double, 3> direction = {0, 1, 0};  ///< of the fiber, unit vector
  double bend = 0;    ///< height of a parabola over the fiber's ends, over its length
  double s_bend = 0;  ///< height of a cubic's ends over the fiber's line, over its length
  std::array<double, 3> bend_direction = {-1, 0, 0};  ///< across `direction`, unit vector
};

/// A free fiber carried, turned and bent by a flow.
struct FlowScene {
  Dimension dimension = Dimension::planar;
  Fiber fiber;
  Fluid fluid;
  double rate;  ///< what strain is counted by [1/s]: size of the named flow's rate, or the gradient's
                ///< Frobenius norm
  bool shear;   ///< the flow is a simple shear, steady: Jeffery's orbits are its reference
  FlowStart start;
  double duration;    ///< [s]
  int samples = 500;  ///< intervals of the history
  int shapes = 8;     ///< intervals of the recorded shapes
  FlowOptions motion = {};
  DampingSummary damping = {};  ///< none: fibers in fluids have no branches
};

/// Which of the bifurcations of a rod's path is left, and how.
struct RodBranch {
  int bifurcation = 1;      ///< number along the path, from 1
  int sign = 1;             ///< 1 or -1: the way of the mode, or against it
  double amplitude = 0.02;  ///< of the mode at the first point of the branch [L, rad]
};

/// A rod held and loaded in any way, followed along its equilibria.
struct RodScene {
  Dimension dimension = Dimension::planar;
  Fiber fiber;
  RodProblem problem = {};
  RodPathOptions path = {};
  std::optional<RodBranch> branch = std::nullopt;
  int shapes = 10;              ///< of the path that are recorded, at most, besides those of singular points
  DampingSummary damping = {};  ///< none: rods have no branches of a material's memory
};

using Scene = std::variant<CantileverScene, ReleaseScene, FlowScene, RodScene, PackingScene>;

/// A kind of scene: the word of key `scene`, and its keys.
struct SceneKind {
  const char* name;
  std::vector<KeyDeclaration> (*keys)();
};

/// All kinds, in the order of the types of a Scene.
const std::vector<SceneKind>& scene_kinds();

/// The scene in a text. Files that it names are looked for from its own directory.
/// @throws SceneError naming file, line, key, value and what is allowed
Scene parse_scene(const SceneText& scene);

/// The scene in a file.
/// @throws SceneError
inline Scene read_scene(const std::filesystem::path& path) { return parse_scene(read_scene_text(path)); }

}  // namespace fiberchain::dem
