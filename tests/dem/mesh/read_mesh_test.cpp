// Files of triangles: sound ones, and all that can be wrong with them.
#include <bit>
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <fstream>
#include <string>

#include "dem/mesh/mesh_topology.hpp"
#include "dem/mesh/read_mesh.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/mesh/meshes.hpp"

BOOST_AUTO_TEST_SUITE(read_mesh_test)

using namespace meshes;

namespace {

std::string binary_stl(const dem::TriangleSoup& soup, std::uint32_t says) {
  std::string text = "solid but binary";
  text.resize(80, '\0');
  const auto put = [&](auto number) { text.append(reinterpret_cast<const char*>(&number), sizeof number); };
  put(says);
  for (const auto& t : soup.triangles) {
    for (int c = 0; c < 3; ++c) put(0.0f);
    for (const auto v : t) {
      for (const double c : soup.vertices[v].c) put(static_cast<float>(c));
    }
    put(std::uint16_t{0});
  }
  return text;
}

std::string binary_stl(const dem::TriangleSoup& soup) {
  return binary_stl(soup, static_cast<std::uint32_t>(soup.triangles.size()));
}

const std::string kAscii =
    "solid a name of words\n  facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1.5e0 0 0\n vertex 0 2 "
    "0\n"
    "endloop endfacet\r\nendsolid a name of words\n";
const std::string kObj =
    "# comment\nmtllib x\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2//1 3 -1\n";

std::string refusal(const std::string& content, const std::string& name) {
  try {
    dem::make_mesh(dem::read_mesh(content, name), 1, name);
  } catch (const dem::InvalidInput& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

BOOST_AUTO_TEST_CASE(sound_files_are_read) {
  const dem::TriangleSoup cube = box({0.5, 1, 2});
  const dem::TriangleSoup read = dem::read_stl(binary_stl(cube), "cube.stl");
  BOOST_TEST_REQUIRE(read.triangles.size() == 12u);
  for (std::size_t n = 0; n < cube.vertices.size(); ++n)
    BOOST_TEST(norm(read.vertices[n] - cube.vertices[n]) == 0);
  const dem::TriangleSoup ascii = dem::read_stl(kAscii, "a.stl");
  BOOST_TEST_REQUIRE(ascii.triangles.size() == 1u);
  BOOST_TEST(ascii.vertices[1][0] == 1.5);
  BOOST_TEST(ascii.vertices[2][1] == 2.0);
  const dem::TriangleSoup obj = dem::read_mesh(kObj, "A.OBJ");
  BOOST_TEST_REQUIRE(obj.triangles.size() == 2u);
  BOOST_TEST((obj.triangles[1] == std::array<std::int32_t, 3>{0, 2, 3}));
}

BOOST_AUTO_TEST_CASE(shared_corners_are_one) {
  const dem::TriangleMesh mesh = dem::make_mesh(box({0.5, 1, 2}), 1e-3, "cube");
  BOOST_TEST(mesh.vertices.size() == 8u);
  BOOST_TEST(mesh.edges.size() == 18u);
  BOOST_TEST(mesh.is_closed);
  BOOST_TEST(std::abs(topology_of(mesh).volume / 8e-9 - 1) < 1e-12);
  BOOST_TEST(notes_on(mesh, true).empty());
}

BOOST_AUTO_TEST_CASE(damaged_files_are_refused_in_words) {
  const std::string stl = binary_stl(box({1, 1, 1}));
  BOOST_TEST(refusal("", "a.stl") == "a.stl: is empty");
  BOOST_TEST(refusal("", "a.obj") == "a.obj: is empty");
  BOOST_TEST(refusal("abc", "a.stl") == "a.stl: is no STL file: 3 bytes, without the head of one");
  BOOST_TEST(
      refusal(stl.substr(0, 300), "a.stl") ==
      "a.stl: is cut off or damaged: it says that it holds 12 triangles, which take 684 bytes, and has 300");
  BOOST_TEST(refusal(stl + "more", "a.stl").ends_with("take 684 bytes, and has 688"));
  BOOST_TEST(refusal(binary_stl({}, 0), "a.stl") == "a.stl: holds no triangles");
  // a count that would take 200 GB
  BOOST_TEST(refusal(binary_stl(box({1, 1, 1}), 4'000'000'000u), "a.stl").find("is cut off") !=
             std::string::npos);
  dem::TriangleSoup bad = box({1, 1, 1});
  bad.vertices[7][1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(refusal(binary_stl(bad), "a.stl") == "a.stl: a corner of triangle 3 is not finite");
  bad.vertices[7][1] = 1e30;
  BOOST_TEST(refusal(binary_stl(bad), "a.stl").find("at most 1e+06 m") != std::string::npos);
  BOOST_TEST(refusal(kAscii.substr(0, 56), "a.stl") == "a.stl:4: is cut off: vertex is missing");
  BOOST_TEST(refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n", "a.stl") ==
             "a.stl:4: 'inf' is not allowed; allowed: a finite number");
  BOOST_TEST(refusal("solid x\nendsolid x\n", "a.stl") == "a.stl: holds no triangles");
  BOOST_TEST(refusal("v 0 0 0\nf 1 2 3\n", "a.obj") ==
             "a.obj:2: vertex '2' is not allowed: there are 1 above this line");
  BOOST_TEST(refusal("v 0 0 0\nf 1 1\n", "a.obj") ==
             "a.obj:2: a face of 2 corners is not allowed; allowed: at least 3");
  BOOST_TEST(refusal("v 0 0\n", "a.obj") == "a.obj:1: a coordinate is missing");
  BOOST_TEST(refusal("solid\n", "a.obj") ==
             "a.obj:1: 'solid' is not allowed; allowed: v, f and other words of OBJ files");
  BOOST_TEST(refusal("v 0 0 0\n", "a.obj") == "a.obj: holds no faces");
  BOOST_TEST(refusal("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\n", "a.obj") ==
             "a.obj: none of its 2 triangles has an area");
  BOOST_TEST(refusal("x", "a.ply") == "a.ply: its ending is not allowed; allowed: .stl or .obj");
}

/// A file of ten million triangles is refused by its head: nothing of it is read.
BOOST_AUTO_TEST_CASE(files_that_are_too_large_are_refused_unread) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "fiberchain-large.stl";
  const std::string head = binary_stl({}, 10'000'000);
  std::ofstream(path, std::ios::binary) << head;
  std::filesystem::resize_file(path, 84 + 50 * std::uintmax_t{10'000'000});  // a hole
  const auto message = [&] {
    try {
      dem::read_mesh_file(path);
    } catch (const dem::InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  BOOST_TEST(message() == path.string() + ": 10000000 triangles are not allowed: at most 2000000");
  std::filesystem::resize_file(path, dem::largest_mesh_file + 1);
  BOOST_TEST(message() == path.string() + ": 700000001 bytes are not allowed: at most 700000000");
  std::filesystem::remove(path);
  BOOST_TEST(message().starts_with(path.string() + ": cannot be read: "));
}

BOOST_AUTO_TEST_CASE(odd_surfaces_are_told) {
  const auto notes = [](const dem::TriangleSoup& soup, bool one_sided = false) {
    std::string all;
    for (const std::string& note : notes_on(dem::make_mesh(soup, 1, "x"), one_sided)) all += note + "|";
    return all;
  };
  dem::TriangleSoup cube = box({1, 1, 1});
  BOOST_TEST(notes(cube, true).empty());
  dem::TriangleSoup open = cube;
  open.triangles.pop_back();
  BOOST_TEST(notes(open) == "is open: 3 of its 18 edges belong to one triangle alone|");
  dem::TriangleSoup inward = cube;
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  BOOST_TEST(notes(inward).empty());
  BOOST_TEST(notes(inward, true) ==
             "is closed and inside-out (its normals point inside): fibers belong inside of it|");
  dem::TriangleSoup needle = cube;
  add_triangle(needle, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  BOOST_TEST(notes(needle) == "1 triangles without area are left out|");
  dem::TriangleSoup crossed = cube;
  for (const auto& t : box({0.3, 0.3, 3}).triangles) {
    const auto& x = box({0.3, 0.3, 3}).vertices;
    add_triangle(crossed, x[t[0]], x[t[1]], x[t[2]]);
  }
  BOOST_TEST(notes(crossed).find("crosses itself") != std::string::npos);
  dem::TriangleSoup fin = cube;
  add_triangle(fin, {1, 1, -1}, {1, 1, 1}, {2, 2, 0});
  BOOST_TEST(notes(fin).find("1 of its edges belong to more than two triangles") != std::string::npos);
  dem::TriangleSoup turned = cube;
  std::swap(turned.triangles[4][0], turned.triangles[4][1]);
  const auto pair = topology_of(dem::make_mesh(turned, 1, "x")).turned;
  BOOST_TEST_REQUIRE(pair.has_value());
  BOOST_TEST(((*pair)[0] == 4 || (*pair)[1] == 4));
}

BOOST_AUTO_TEST_SUITE_END()
