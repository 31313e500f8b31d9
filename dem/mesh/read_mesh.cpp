#include "dem/mesh/read_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

std::string ending_of(const std::string& name) {
  const std::size_t dot = name.find_last_of('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot);
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

}  // namespace

TriangleSoup read_mesh(std::string_view content, const std::string& name) {
  const std::string ending = ending_of(name);
  if (ending == ".stl") return read_stl(content, name);
  if (ending == ".obj") return read_obj(content, name);
  throw InvalidInput(name + ": its ending is not allowed; allowed: .stl or .obj");
}

TriangleSoup read_mesh_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  std::ifstream file(path, std::ios::binary);
  if (failure || !file)
    throw InvalidInput(
        fmt::format("{}: cannot be read: {}", name, failure ? failure.message() : std::strerror(errno)));
  if (size > largest_mesh_file)
    throw InvalidInput(
        fmt::format("{}: {} bytes are not allowed: at most {}", name, size, largest_mesh_file));
  std::string content(std::min<std::uintmax_t>(size, stl_head_size), '\0');
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (ending_of(name) == ".stl") check_stl_head(content, size, name);
  const std::size_t head = content.size();
  content.resize(size);
  file.read(content.data() + head, static_cast<std::streamsize>(size - head));
  if (!file) throw InvalidInput(fmt::format("{}: cannot be read: it ends before its {} bytes", name, size));
  return read_mesh(content, name);
}

}  // namespace fiberchain::dem
