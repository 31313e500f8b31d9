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

/// A comment may not hold two dashes.
std::string comment(const Entries& provenance) {
  std::string text = "<!--\n";
  for (const auto& [key, value] : provenance) {
    std::string line = fmt::format("{}: {}", key, value);
    for (std::size_t at = 0; (at = line.find("--", at)) != std::string::npos;) line.replace(at, 2, "- -");
    text += line + " \n";
  }
  return text + "-->\n";
}

/// VTK cells of one kind, by the points they join and the end of each.
std::string cells(const char* kind, const std::vector<std::int64_t>& points,
                  const std::vector<std::int64_t>& ends) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind, array("connectivity", 1, points),
                     array("offsets", 1, ends));
}

std::string file(const TrajectoryFrame& frame, const Entries& provenance, std::size_t verts,
                 std::size_t lines, const std::string& rest) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n{}<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
      "NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n{}<Points>\n{}</Points>\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
      comment(provenance), frame.position.size(), verts, lines, point_data(frame),
      array("points", 3, flat(frame.position)), rest);
}

}  // namespace

std::string vtp_spheres(const TrajectoryFrame& frame, const Entries& provenance) {
  const std::size_t spheres = frame.position.size();
  return file(frame, provenance, spheres, 0,
              cells("Verts", numbers_from(0, spheres), numbers_from(1, spheres)));
}

std::string vtp_lines(const TrajectoryFrame& frame, const Entries& provenance) {
  const std::size_t spheres = frame.position.size();
  std::vector<std::int64_t> ends;
  for (std::size_t i = 1; i <= spheres; ++i) {
    if (i == spheres || frame.fiber[i] != frame.fiber[i - 1]) ends.push_back(static_cast<std::int64_t>(i));
  }
  return file(frame, provenance, 0, ends.size(), cells("Lines", numbers_from(0, spheres), ends));
}

}  // namespace fiberchain::dem
