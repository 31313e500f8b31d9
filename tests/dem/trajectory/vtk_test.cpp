#include "dem/trajectory/vtk.hpp"

#include <boost/beast/core/detail/base64.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <sstream>

#include "dem/files/base64.hpp"
#include "dem/files/file_error.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/trajectory/files.hpp"
#include "tests/dem/trajectory/frames.hpp"

BOOST_AUTO_TEST_SUITE(vtk_test)

using namespace fiberchain::dem;
using namespace fiberchain::test;
using boost::property_tree::ptree;
namespace fs = std::filesystem;

namespace {

const Entries kProvenance = {{"command", "fiberchain run x.yaml --out there"},
                             {"note", "a --> b < c & d ---"}};
const VtkHeader kHeader{.provenance = kProvenance};

ptree parsed(const std::string& text) {
  std::istringstream stream(text);
  ptree tree;
  read_xml(stream, tree);
  return tree;
}

std::string decoded(const std::string& text) {
  namespace b64 = boost::beast::detail::base64;
  std::string bytes(b64::decoded_size(text.size()), '\0');
  bytes.resize(b64::decode(bytes.data(), text.data(), text.size()).first);
  return bytes;
}

/// Values of a DataArray: its header, 12 characters of base64, gives the number of bytes of the rest.
template <class Number>
std::vector<Number> values(const ptree& piece, const std::string& section, const std::string& name,
                           const char* type) {
  for (const auto& [tag, found] : piece.get_child(section)) {
    const ptree& array = found;
    if (tag != "DataArray" || array.get<std::string>("<xmlattr>.Name") != name) continue;
    BOOST_TEST(array.get<std::string>("<xmlattr>.type") == type);
    BOOST_TEST(array.get<std::string>("<xmlattr>.format") == "binary");
    const std::string text = array.data();
    std::uint64_t size = 0;
    std::memcpy(&size, decoded(text.substr(0, 12)).data(), sizeof size);
    const std::string bytes = decoded(text.substr(12));
    BOOST_REQUIRE(bytes.size() == size);
    std::vector<Number> all(size / sizeof(Number));
    std::memcpy(all.data(), bytes.data(), size);
    return all;
  }
  BOOST_FAIL("no array " << name);
  return {};
}

void check_points(const ptree& piece, const TrajectoryFrame& frame) {
  const std::size_t spheres = frame.position.size();
  BOOST_TEST(piece.get<std::size_t>("<xmlattr>.NumberOfPoints") == spheres);
  const auto points = values<double>(piece, "Points", "points", "Float64");
  const auto velocity = values<float>(piece, "PointData", "v", "Float32");
  const auto radius = values<float>(piece, "PointData", "radius", "Float32");
  const auto force = values<float>(piece, "PointData", "bond_force", "Float32");
  const auto angle = values<float>(piece, "PointData", "bending_angle", "Float32");
  BOOST_TEST((values<std::int32_t>(piece, "PointData", "fiber", "Int32") == frame.fiber));
  BOOST_REQUIRE(points.size() == 3 * spheres);
  BOOST_REQUIRE(velocity.size() == 3 * spheres);
  BOOST_REQUIRE(force.size() == 3 * spheres);
  BOOST_REQUIRE(angle.size() == spheres);
  std::size_t bond = 0;
  for (std::size_t i = 0; i < spheres; ++i) {
    const bool bonded = bond < frame.bonds.size() && frame.bonds[bond].first == static_cast<std::int64_t>(i);
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 3 * i + static_cast<std::size_t>(k);
      BOOST_TEST(points[at] == frame.position[i][k]);
      BOOST_TEST(velocity[at] == static_cast<float>(frame.velocity[i][k]));
      BOOST_TEST(force[at] == (bonded ? static_cast<float>(frame.bonds[bond].force[k]) : 0.f));
    }
    BOOST_TEST(radius[i] == static_cast<float>(frame.radius[i]));
    BOOST_TEST(angle[i] == (bonded ? static_cast<float>(frame.bonds[bond].bending_angle) : 0.f));
    if (bonded) ++bond;
  }
  BOOST_TEST(bond == frame.bonds.size());
}

/// Times and files of a series.
std::vector<std::pair<double, std::string>> entries(const fs::path& path) {
  std::vector<std::pair<double, std::string>> all;
  const ptree tree = parsed(content(path));
  BOOST_TEST(tree.get<std::string>("VTKFile.<xmlattr>.type") == "Collection");
  for (const auto& [tag, set] : tree.get_child("VTKFile.Collection")) {
    if (tag == "DataSet")
      all.emplace_back(set.get<double>("<xmlattr>.timestep"), set.get<std::string>("<xmlattr>.file"));
  }
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(base64_is_that_of_the_standard) {  // RFC 4648, 10
  const char* const words[][2] = {{"", ""},
                                  {"f", "Zg=="},
                                  {"fo", "Zm8="},
                                  {"foo", "Zm9v"},
                                  {"foob", "Zm9vYg=="},
                                  {"fooba", "Zm9vYmE="},
                                  {"foobar", "Zm9vYmFy"},
                                  {"\xff\xfe\xfd", "//79"}};
  for (const auto& [bytes, text] : words) BOOST_TEST(base64(bytes, std::strlen(bytes)) == text);
}

// What OVITO asks of particles: a vertex for every point and nothing else.
BOOST_AUTO_TEST_CASE(spheres_are_a_vertex_each) {
  const TrajectoryFrame frame = bent_fibers(3, 7, 40);
  const ptree tree = parsed(vtp_spheres(frame, kProvenance));
  BOOST_TEST(tree.get<std::string>("VTKFile.<xmlattr>.byte_order") == "LittleEndian");
  BOOST_TEST(tree.get<std::string>("VTKFile.<xmlattr>.header_type") == "UInt64");
  const ptree piece = tree.get_child("VTKFile.PolyData.Piece");
  check_points(piece, frame);
  BOOST_TEST(piece.get<int>("<xmlattr>.NumberOfVerts") == 21);
  BOOST_TEST(piece.get<int>("<xmlattr>.NumberOfLines") == 0);
  const auto points = values<std::int64_t>(piece, "Verts", "connectivity", "Int64");
  const auto ends = values<std::int64_t>(piece, "Verts", "offsets", "Int64");
  for (std::size_t i = 0; i < 21; ++i) {
    BOOST_TEST(points.at(i) == static_cast<std::int64_t>(i));
    BOOST_TEST(ends.at(i) == static_cast<std::int64_t>(i) + 1);
  }
}

BOOST_AUTO_TEST_CASE(lines_are_the_fibers) {
  const TrajectoryFrame frame = bent_fibers(3, 7, 40);
  const ptree piece = parsed(vtp_lines(frame, kProvenance)).get_child("VTKFile.PolyData.Piece");
  check_points(piece, frame);
  BOOST_TEST(piece.get<int>("<xmlattr>.NumberOfVerts") == 0);
  BOOST_TEST(piece.get<int>("<xmlattr>.NumberOfLines") == 3);
  BOOST_TEST(values<std::int64_t>(piece, "Lines", "connectivity", "Int64").size() == 21);
  BOOST_TEST(
      (values<std::int64_t>(piece, "Lines", "offsets", "Int64") == std::vector<std::int64_t>{7, 14, 21}));
}

BOOST_AUTO_TEST_CASE(files_say_when_and_whence) {
  const TrajectoryFrame frame = bent_fibers(2, 5, 40);
  const ptree data = parsed(vtp_lines(frame, kProvenance)).get_child("VTKFile.PolyData");
  BOOST_TEST(values<double>(data, "FieldData", "TimeValue", "Float64").at(0) == frame.time);
  BOOST_TEST(values<std::int64_t>(data, "FieldData", "step", "Int64").at(0) == 40);
  const auto bytes = values<char>(data, "FieldData", "provenance", "String");
  const std::string expected =
      std::string("command: fiberchain run x.yaml --out there") + '\0' + "note: a --> b < c & d ---" + '\0';
  BOOST_TEST((std::string(bytes.begin(), bytes.end()) == expected));
}

BOOST_AUTO_TEST_CASE(contacts_are_points_with_their_forces) {
  const TrajectoryFrame frame = with_contacts(bent_fibers(2, 5, 40));
  const ptree piece = parsed(vtp_contacts(frame, {})).get_child("VTKFile.PolyData.Piece");
  BOOST_TEST(piece.get<int>("<xmlattr>.NumberOfVerts") == 3);
  const auto points = values<double>(piece, "Points", "points", "Float64");
  const auto force = values<float>(piece, "PointData", "force", "Float32");
  const auto normal = values<float>(piece, "PointData", "normal", "Float32");
  BOOST_TEST(
      (values<std::int32_t>(piece, "PointData", "kind", "Int32") == std::vector<std::int32_t>{0, 1, 2}));
  for (std::size_t n = 0; n < 3; ++n) {
    const FrameContact& contact = frame.contacts[n];
    BOOST_TEST(values<std::int64_t>(piece, "PointData", "first", "Int64").at(n) == contact.first);
    BOOST_TEST(values<std::int64_t>(piece, "PointData", "second", "Int64").at(n) == contact.second);
    for (int c = 0; c < 3; ++c) {
      const std::size_t at = 3 * n + static_cast<std::size_t>(c);
      BOOST_TEST(points.at(at) == contact.point[c]);
      BOOST_TEST(force.at(at) == static_cast<float>(contact.force[c]));
      BOOST_TEST(normal.at(at) == static_cast<float>(contact.normal[c]));
    }
  }
}

/// Walls that have not moved are one file; those that are gone are not drawn.
BOOST_AUTO_TEST_CASE(walls_are_triangles_where_they_are) {
  const Scratch scratch;
  const VtkHeader header{.provenance = {}, .walls = two_walls()};
  VtkSeries series(scratch.path, "run", header);
  series.append(with_walls(bent_fibers(2, 5, 0)));
  TrajectoryFrame same = with_walls(bent_fibers(2, 5, 10)), gone = with_walls(bent_fibers(2, 5, 20));
  same.walls_as_before = true;
  gone.walls[0].is_there = false;
  series.append(same);
  VtkSeries resumed = VtkSeries::resume(scratch.path, "run", header, 15);
  resumed.append(gone);
  const auto all = entries(scratch.path / "run-walls.pvd");
  BOOST_REQUIRE(all.size() == 3);
  BOOST_TEST(all[0].second == all[1].second);
  BOOST_TEST(all[1].second != all[2].second);
  const auto piece = [&](std::size_t n) {
    return parsed(content(scratch.path / all[n].second)).get_child("VTKFile.PolyData.Piece");
  };
  BOOST_TEST(piece(0).get<int>("<xmlattr>.NumberOfPolys") == 3);
  BOOST_TEST(
      (values<std::int32_t>(piece(0), "CellData", "wall", "Int32") == std::vector<std::int32_t>{1, 2, 2}));
  BOOST_TEST(
      (values<std::int32_t>(piece(2), "CellData", "wall", "Int32") == std::vector<std::int32_t>{2, 2}));
  const auto points = values<double>(piece(0), "Points", "points", "Float64");
  for (int c = 0; c < 3; ++c)
    BOOST_TEST(points.at(static_cast<std::size_t>(c)) ==
               placed_at(with_walls(bent_fibers(2, 5, 0)).walls[0], header.walls[0].points[0])[c]);
}

BOOST_AUTO_TEST_CASE(a_series_names_its_frames_and_goes_on) {
  const Scratch scratch;
  VtkSeries series(scratch.path, "run", kHeader);
  for (const std::int64_t step : {0, 10, 20}) series.append(bent_fibers(2, 5, step));
  BOOST_CHECK_THROW(series.append(bent_fibers(2, 5, 20)), InvalidInput);
  VtkSeries resumed = VtkSeries::resume(scratch.path, "run", kHeader, 15);
  BOOST_TEST(resumed.frames() == 2);
  BOOST_TEST(entries(scratch.path / "run.pvd").size() == 2);
  resumed.append(bent_fibers(2, 5, 30));
  for (const char* name : {"run.pvd", "run-lines.pvd"}) {
    const auto all = entries(scratch.path / name);
    BOOST_REQUIRE(all.size() == 3);
    const std::int64_t steps[] = {0, 10, 30};
    for (std::size_t i = 0; i < 3; ++i) {
      BOOST_TEST(all[i].first == bent_fibers(2, 5, steps[i]).time);
      check_points(parsed(content(scratch.path / all[i].second)).get_child("VTKFile.PolyData.Piece"),
                   bent_fibers(2, 5, steps[i]));
    }
  }
  BOOST_TEST(VtkSeries::resume(scratch.path, "other", kHeader, 15).frames() == 0);
  std::ofstream(scratch.path / "bad.pvd") << "not ours";
  BOOST_CHECK_THROW(VtkSeries::resume(scratch.path, "bad", kHeader, 15), ReadError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_series_whole) {
  const Scratch scratch;
  VtkSeries series(scratch.path, "run", kHeader);
  series.append(bent_fibers(2, 5, 0));
  const std::string before = content(scratch.path / "run.pvd");
  {
    const SizeLimit full(1000);
    BOOST_CHECK_THROW(series.append(bent_fibers(2, 5, 10)), WriteError);
  }
  BOOST_TEST(content(scratch.path / "run.pvd") == before);
  BOOST_TEST(files_in(scratch.path / "run") == 2);
  BOOST_TEST(series.frames() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
