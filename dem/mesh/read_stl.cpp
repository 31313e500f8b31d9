#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "dem/files/numbers.hpp"
#include "dem/mesh/mesh_words.hpp"
#include "dem/mesh/read_mesh.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::size_t stl_triangle = 50;  // [bytes]

[[noreturn]] void refuse_stl(const std::string& name, const std::string& what) {
  throw InvalidInput(name + ": " + what);
}

void check_triangle_count(const std::string& name, std::uint64_t count) {
  if (count > static_cast<std::uint64_t>(most_triangles))
    refuse_stl(name, fmt::format("{} triangles are not allowed: at most {}", count, most_triangles));
  if (count == 0) refuse_stl(name, "holds no triangles");
}

template <class Number>
Number little_endian(const char* bytes) {
  std::uint32_t number = 0;
  for (int k = 3; k >= 0; --k) number = number << 8 | static_cast<unsigned char>(bytes[k]);
  return std::bit_cast<Number>(number);
}

/// What a binary file says it has; nothing where it is shorter than that takes.
std::uint64_t binary_count(std::string_view content) {
  return content.size() < stl_head_size ? 0
                                        : little_endian<std::uint32_t>(content.data() + stl_head_size - 4);
}

std::uint64_t binary_size(std::uint64_t count) { return stl_head_size + count * stl_triangle; }

TriangleSoup read_binary_stl(std::string_view content, const std::string& name) {
  const std::uint64_t count = binary_count(content);
  check_triangle_count(name, count);
  TriangleSoup soup;
  soup.vertices.reserve(3 * count), soup.triangles.reserve(count);
  for (std::uint64_t t = 0; t < count; ++t) {
    const char* corners = content.data() + stl_head_size + t * stl_triangle + 12;  // behind the normal
    const auto first = static_cast<std::int32_t>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) {
      Vec<double, 3> x{};
      for (int c = 0; c < 3; ++c) x[c] = little_endian<float>(corners + 12 * k + 4 * c);
      if (!std::isfinite(x[0] + x[1] + x[2]))
        refuse_stl(name, fmt::format("a corner of triangle {} is not finite", t + 1));
      soup.vertices.push_back(x);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleSoup read_ascii_stl(std::string_view content, const std::string& name) {
  MeshWords words(content, name);
  TriangleSoup soup;
  std::string_view word = words.next();  // solid
  words.skip_line();                     // and its name, of any words
  for (word = words.next(); !word.empty(); word = words.next()) {
    if (word == "endsolid" || word == "solid") {
      words.skip_line();
      continue;
    }
    if (word != "facet") words.fail("'{}' is not allowed; allowed: facet, endsolid or solid", word);
    if (std::ssize(soup.triangles) == most_triangles)
      refuse_stl(name, fmt::format("more than {} triangles are not allowed", most_triangles));
    words.skip_line();  // its normal
    words.require("outer"), words.require("loop");
    const auto first = static_cast<std::int32_t>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) {
      words.require("vertex");
      soup.vertices.push_back(words.vector());
    }
    words.require("endloop"), words.require("endfacet");
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  check_triangle_count(name, soup.triangles.size());
  return soup;
}

bool begins_with_solid(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && content.substr(first).starts_with("solid");
}

}  // namespace

void check_stl_head(std::string_view head, std::uintmax_t size, const std::string& name) {
  const std::uint64_t count = binary_count(head);
  if (size == binary_size(count)) check_triangle_count(name, count);
}

TriangleSoup read_stl(std::string_view content, const std::string& name) {
  if (content.empty()) refuse_stl(name, "is empty");
  const std::uint64_t count = binary_count(content), size = binary_size(count);
  if (content.size() == size) return read_binary_stl(content, name);
  // some programs begin binary files with "solid": those hold zeros
  const bool is_text = begins_with_solid(content) && content.find('\0') == std::string_view::npos;
  if (is_text) return read_ascii_stl(content, name);
  if (content.size() < stl_head_size)
    refuse_stl(name, fmt::format("is no STL file: {} bytes, without the head of one", content.size()));
  refuse_stl(name, fmt::format("is cut off or damaged: it says that it holds {} triangles, which take {} "
                               "bytes, and has {}",
                               count, size, content.size()));
}

}  // namespace fiberchain::dem
