#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "dem/mesh/triangle_soup.hpp"

// Files of triangles. They come from anywhere: nothing in them is believed before it is checked against what
// is there, no array is made larger than the file says and holds.
namespace fiberchain::dem {

/// Largest file [bytes]: that of most_triangles as ASCII STL, written with all digits.
inline constexpr std::size_t largest_mesh_file = std::size_t{350} * most_triangles;

/// Triangles of an STL file, binary or ASCII (which of them its size tells, not its first word). Normals are
/// left out: the order of the corners gives them.
/// @throws InvalidInput "NAME: ..." for a file that is empty, cut off, longer or shorter than it says, no
/// STL, has no triangles or more than most_triangles, or a coordinate that is not finite
TriangleSoup read_stl(std::string_view content, const std::string& name);

/// Bytes before the triangles of a binary STL file.
inline constexpr std::size_t stl_head_size = 84;

/// Looks at the first stl_head_size bytes (or all) of a file of `size` bytes alone.
/// @throws InvalidInput for a binary file of too many triangles
void check_stl_head(std::string_view head, std::uintmax_t size, const std::string& name);

/// Faces of a Wavefront OBJ file; those of more than three corners as fans of triangles. Normals, textures,
/// groups, materials, lines and points are left out.
/// @throws InvalidInput "NAME:LINE: ..." as read_stl(), for vertices that are not there and unknown words
TriangleSoup read_obj(std::string_view content, const std::string& name);

/// By the ending of the name: .stl or .obj, small or capital.
/// @throws InvalidInput as these, and for other endings
TriangleSoup read_mesh(std::string_view content, const std::string& name);

/// The same of a file. What is too large is refused before it is read.
/// @throws InvalidInput as read_mesh(), and for a file that cannot be read
TriangleSoup read_mesh_file(const std::filesystem::path& path);

}  // namespace fiberchain::dem
