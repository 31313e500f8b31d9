#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>

#include "dem/files/base64.hpp"
#include "dem/trajectory/output_fields.hpp"
#include "dem/trajectory/vtk.hpp"

namespace fiberchain::dem {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

template <class Number>
constexpr const char* kType = nullptr;
template <>
constexpr const char* kType<float> = "Float32";
template <>
constexpr const char* kType<double> = "Float64";
template <>
constexpr const char* kType<std::int32_t> = "Int32";
template <>
constexpr const char* kType<std::int64_t> = "Int64";

/// A DataArray: the number of its bytes (UInt64), then they, in base64 each.
template <class Number>
std::string array(const char* name, int components, const std::vector<Number>& values) {
  const std::uint64_t bytes = values.size() * sizeof(Number);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}{}</DataArray>\n",
      kType<Number>, name, components, base64(&bytes, sizeof bytes), base64(values.data(), bytes));
}

std::vector<double> flat(const std::vector<Vec<double, 3>>& vectors) {
  std::vector<double> all;
  all.reserve(3 * vectors.size());
  for (const auto& vector : vectors) all.insert(all.end(), vector.c, vector.c + 3);
  return all;
}

std::vector<std::int64_t> numbers_from(std::int64_t first, std::size_t count) {
  std::vector<std::int64_t> all(count);
  for (std::int64_t& number : all) number = first++;
  return all;
}

std::vector<float> singles(const std::vector<double>& values) {
  std::vector<float> all;
  all.reserve(values.size());
  for (const double value : values) all.push_back(static_cast<float>(value));
  return all;
}

/// A field of the bonds at the first sphere of each; 0 where none begins.
std::vector<float> at_first_spheres(const TrajectoryFrame& frame, const OutputField& field) {
  const auto width = static_cast<std::size_t>(field.width);
  std::vector<float> all(width * frame.position.size(), 0);
  const std::vector<double> values = field.values(frame);
  for (std::size_t bond = 0; bond < frame.bonds.size(); ++bond) {
    const auto first = static_cast<std::size_t>(frame.bonds[bond].first);
    for (std::size_t k = 0; k < width; ++k)
      all[width * first + k] = static_cast<float>(values[width * bond + k]);
  }
  return all;
}

std::string point_data(const TrajectoryFrame& frame) {
  const std::size_t spheres = frame.position.size();
  const std::vector<float> radius(frame.radius.begin(), frame.radius.end());
  std::string text = "<PointData Scalars=\"radius\" Vectors=\"v\">\n" +
                     array("id", 1, numbers_from(0, spheres)) + array("fiber", 1, frame.fiber) +
                     array("radius", 1, radius);
  for (const OutputField& field : sphere_fields)
    text += array(field.point_array, field.width, singles(field.values(frame)));
  for (const OutputField& field : bond_fields)
    text += array(field.point_array, field.width, at_first_spheres(frame, field));
  return text + "</PointData>\n";
}

/// Texts as VTK has them in a file: bytes with a zero behind each.
std::string texts(const char* name, const std::vector<std::string>& all) {
  std::string bytes;
  for (const std::string& text : all) bytes += text + '\0';
  const std::uint64_t size = bytes.size();
  return fmt::format(
      "<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"binary\">{}{}</DataArray>\n",
      name, all.size(), base64(&size, sizeof size), base64(bytes.data(), bytes.size()));
}

/// A number of the whole file.
template <class Number>
std::string field_number(const char* name, Number value) {
  const std::uint64_t bytes = sizeof value;
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfTuples=\"1\" format=\"binary\">{}{}</DataArray>\n",
      kType<Number>, name, base64(&bytes, sizeof bytes), base64(&value, sizeof value));
}

/// Time, step and provenance as field data, which viewers show; by TimeValue ParaView knows the time of a
/// file that is opened alone.
std::string field_data(const TrajectoryFrame& frame, const Entries& provenance) {
  std::string text =
      "<FieldData>\n" + field_number("TimeValue", frame.time) + field_number("step", frame.step);
  std::vector<std::string> lines;
  for (const auto& [key, value] : provenance) lines.push_back(fmt::format("{}: {}", key, value));
  if (!lines.empty()) text += texts("provenance", lines);
  return text + "</FieldData>\n";
}

/// VTK cells of one kind, by the points they join and the end of each.
std::string cells(const char* kind, const std::vector<std::int64_t>& points,
                  const std::vector<std::int64_t>& ends) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind, array("connectivity", 1, points),
                     array("offsets", 1, ends));
}

/// Numbers of cells of each kind.
struct CellCounts {
  std::size_t verts = 0, lines = 0, polys = 0;
};

std::string file(const std::string& fields, const std::vector<Vec<double, 3>>& points,
                 const CellCounts& counts, const std::string& data, const std::string& rest) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n{}<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
      "NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n{}<Points>\n{}</Points>\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
      fields, points.size(), counts.verts, counts.lines, counts.polys, data, array("points", 3, flat(points)),
      rest);
}

/// A vertex for every point.
std::string vertices(std::size_t points) {
  return cells("Verts", numbers_from(0, points), numbers_from(1, points));
}

std::vector<float> singles(const std::vector<Vec<double, 3>>& vectors) { return singles(flat(vectors)); }

}  // namespace

std::string vtp_spheres(const TrajectoryFrame& frame, const Entries& provenance) {
  const std::size_t spheres = frame.position.size();
  return file(field_data(frame, provenance), frame.position, {.verts = spheres}, point_data(frame),
              vertices(spheres));
}

std::string vtp_lines(const TrajectoryFrame& frame, const Entries& provenance) {
  const std::size_t spheres = frame.position.size();
  std::vector<std::int64_t> ends;
  for (std::size_t i = 1; i <= spheres; ++i) {
    if (i == spheres || frame.fiber[i] != frame.fiber[i - 1]) ends.push_back(static_cast<std::int64_t>(i));
  }
  return file(field_data(frame, provenance), frame.position, {.lines = ends.size()}, point_data(frame),
              cells("Lines", numbers_from(0, spheres), ends));
}

std::string vtp_contacts(const TrajectoryFrame& frame, const Entries& provenance) {
  std::vector<std::int64_t> first, second;
  std::vector<std::int32_t> kind;
  std::vector<Vec<double, 3>> point, normal, force;
  for (const FrameContact& contact : frame.contacts) {
    first.push_back(contact.first), second.push_back(contact.second);
    kind.push_back(static_cast<std::int32_t>(contact.kind));
    point.push_back(contact.point), normal.push_back(contact.normal), force.push_back(contact.force);
  }
  const std::string data = "<PointData Vectors=\"force\">\n" + array("first", 1, first) +
                           array("second", 1, second) + array("kind", 1, kind) +
                           array("normal", 3, singles(normal)) + array("force", 3, singles(force)) +
                           "</PointData>\n";
  return file(field_data(frame, provenance), point, {.verts = point.size()}, data, vertices(point.size()));
}

std::string vtp_walls(const TrajectoryFrame& frame, const std::vector<WallSurface>& walls,
                      const Entries& provenance) {
  std::vector<Vec<double, 3>> points;
  std::vector<std::int64_t> corners, ends;
  std::vector<std::int32_t> wall;
  for (std::size_t w = 0; w < std::min(walls.size(), frame.walls.size()); ++w) {
    if (!frame.walls[w].is_there) continue;
    const auto before = static_cast<std::int64_t>(points.size());
    for (const Vec<double, 3>& point : walls[w].points) points.push_back(placed_at(frame.walls[w], point));
    for (const auto& triangle : walls[w].triangles) {
      for (const std::int32_t corner : triangle) corners.push_back(before + corner);
      ends.push_back(static_cast<std::int64_t>(corners.size()));
      wall.push_back(static_cast<std::int32_t>(w) + 1);
    }
  }
  const std::string data = "<CellData Scalars=\"wall\">\n" + array("wall", 1, wall) + "</CellData>\n";
  return file(field_data(frame, provenance), points, {.polys = ends.size()}, data,
              cells("Polys", corners, ends));
}

}  // namespace fiberchain::dem
