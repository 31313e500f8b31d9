#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "dem/fiber.hpp"
#include "dem/io/scene_error.hpp"

/// Scenes as values, and their reader: YAML, quantities with units, nothing guessed.
namespace fiberchain::dem::io {

enum class Dimension { planar, spatial };
enum class Form { total, incremental };
enum class Method { solve, march };

/// How a march to the equilibrium goes.
struct MarchSettings {
  double step_ratio = 0.2;                         ///< dt / t_b [-]
  double residual = 1e-10;                         ///< stop when the imbalance over the load is below [-]
  std::optional<double> ramp_time = std::nullopt;  ///< time over which the load grows [s]; chosen if not set
};

/// A straight fiber, clamped at its first sphere, with a dead load at its last.
struct CantileverScene {
  Dimension dimension = Dimension::planar;
  Fiber fiber;
  double load;                                  ///< P L^2 / (E I) [-]
  std::array<double, 3> direction = {0, 1, 0};  ///< of the load, unit vector; the fiber lies along x
  Form form = Form::total;
  Method method = Method::solve;
  MarchSettings march = {};
};

using Scene = std::variant<CantileverScene>;

/// A scene file as read: what the messages call it, and its text.
struct SceneText {
  std::string name;
  std::string text;
};

/// Largest scene file [bytes]. Long data belong in files the scene names.
inline constexpr std::size_t kLargestScene = 256 * 1024;

/// Reads the file.
/// @throws SceneError if there is none, it is a directory, it cannot be read, or it is too large
SceneText read_scene_text(const std::filesystem::path& path);

/// The scene in a text.
/// @throws SceneError naming file, line, key, value and what is allowed
Scene parse_scene(const SceneText& scene);

}  // namespace fiberchain::dem::io
