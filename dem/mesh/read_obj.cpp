#include <algorithm>
#include <array>

#include "dem/mesh/mesh_words.hpp"
#include "dem/mesh/read_mesh.hpp"

namespace fiberchain::dem {
namespace {

/// Of OBJ files, what makes no faces.
constexpr std::array<std::string_view, 22> unused_obj_words{
    "vn",     "vt",     "vp",    "g",        "o",        "s",   "l",          "p",
    "usemtl", "mtllib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj",
    "maplib", "usemap", "mg",    "cstype",   "deg",      "end"};

/// The number of a corner, "7", "7/1/2" or "7//2"; -1 is the vertex before.
std::int32_t corner_of(const MeshWords& words, std::string_view word, std::int64_t vertices) {
  const auto typed = parse_integer(word.substr(0, word.find('/')));
  if (!typed) words.fail("'{}' is not allowed; allowed: the number of a vertex", word);
  const std::int64_t number = *typed < 0 ? vertices + *typed : *typed - 1;
  if (number < 0 || number >= vertices)
    words.fail("vertex '{}' is not allowed: there are {} above this line", word, vertices);
  return static_cast<std::int32_t>(number);
}

/// A face as a fan around its first corner.
void add_obj_face(MeshWords& words, TriangleSoup& soup) {
  std::int32_t first = 0, before = 0;
  int corners = 0;
  for (std::string_view word = words.next_in_line(); !word.empty(); word = words.next_in_line()) {
    const std::int32_t corner = corner_of(words, word, std::ssize(soup.vertices));
    if (corners == 0) first = corner;
    if (++corners > 2) soup.triangles.push_back({first, before, corner});
    before = corner;
  }
  if (corners < 3) words.fail("a face of {} corners is not allowed; allowed: at least 3", corners);
  if (std::ssize(soup.triangles) > most_triangles)
    words.fail("more than {} triangles are not allowed", most_triangles);
}

}  // namespace

TriangleSoup read_obj(std::string_view content, const std::string& name) {
  MeshWords words(content, name);
  if (content.empty()) throw InvalidInput(name + ": is empty");
  TriangleSoup soup;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      soup.vertices.push_back(words.vector());
      if (std::ssize(soup.vertices) > 3 * most_triangles)
        words.fail("more than {} vertices are not allowed", 3 * most_triangles);
      words.skip_line();  // weights and colors
    } else if (word == "f") {
      add_obj_face(words, soup);
    } else if (word.starts_with('#') || std::ranges::find(unused_obj_words, word) != unused_obj_words.end()) {
      words.skip_line();
    } else {
      words.fail("'{}' is not allowed; allowed: v, f and other words of OBJ files", word);
    }
  }
  if (soup.triangles.empty()) throw InvalidInput(name + ": holds no faces");
  return soup;
}

}  // namespace fiberchain::dem
