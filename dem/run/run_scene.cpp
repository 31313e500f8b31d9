#include "dem/run/run_scene.hpp"

namespace fiberchain::dem {

SceneResult run_scene(const std::filesystem::path& path, const RunOptions& options) {
  const SceneText text = read_scene_text(path);
  const Scene scene = parse_scene(text);
  if (const auto* packing = std::get_if<PackingScene>(&scene)) return run_scene(text, *packing, options);
  if (const auto* cantilever = std::get_if<CantileverScene>(&scene)) return run_scene(*cantilever);
  if (const auto* release = std::get_if<ReleaseScene>(&scene)) return run_scene(*release);
  return run_scene(std::get<FlowScene>(scene));
}

}  // namespace fiberchain::dem
