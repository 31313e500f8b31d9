#include "dem/run/run_scene.hpp"

#include "dem/scene/located_error.hpp"

namespace fiberchain::dem {

namespace {

SceneResult run_scene_of(const SceneText& text, const RunOptions& options) {
  const Scene scene = parse_scene(text);
  if (const auto* packing = std::get_if<PackingScene>(&scene)) return run_scene(text, *packing, options);
  if (const auto* cantilever = std::get_if<CantileverScene>(&scene)) return run_scene(*cantilever);
  if (const auto* rod = std::get_if<RodScene>(&scene)) return run_scene(*rod);
  if (const auto* release = std::get_if<ReleaseScene>(&scene)) return run_scene(*release);
  return run_scene(std::get<FlowScene>(scene));
}

}  // namespace

SceneResult run_scene(const std::filesystem::path& path, const RunOptions& options) {
  const SceneText text = read_scene_text(path);
  return located(text, [&] { return run_scene_of(text, options); });
}

}  // namespace fiberchain::dem
