#include "dem/scene/scene.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {

SceneText read_scene_text(const std::filesystem::path& path, std::size_t largest) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  std::string text;
  std::array<char, 64 * 1024> piece{};
  while (file && text.size() <= largest) {
    const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get());
    text.append(piece.data(), count);
    if (count < piece.size()) break;
  }
  if (!file || std::ferror(file.get())) {
    throw SceneError(fmt::format("{}: cannot read this scene: {}", path.string(), std::strerror(errno)));
  }
  if (text.size() > largest) {
    throw SceneError(fmt::format("{}: is no scene: more than {} bytes", path.string(), largest));
  }
  text.shrink_to_fit();
  return {path.string(), std::move(text)};
}

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = {{"cantilever", &cantilever_declarations},
                                               {"release", &release_declarations},
                                               {"flow", &flow_declarations},
                                               {"rod", &rod_declarations},
                                               {"packing", &packing_declarations}};
  return kinds;
}

Scene parse_scene(const SceneText& scene) {
  const StrictMapping top(scene);
  std::vector<std::string> words;
  for (const SceneKind& kind : scene_kinds()) words.emplace_back(kind.name);
  switch (top.choice("scene", words)) {
    case 0:
      return read_cantilever(top);
    case 1:
      return read_release(top);
    case 2:
      return read_flow(top);
    case 3:
      return read_rod(top);
    default:
      return read_packing(top);
  }
}

}  // namespace fiberchain::dem
