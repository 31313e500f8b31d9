// Declared quantities of spheres and bonds reach every file.
#include "dem/trajectory/output_fields.hpp"

#include <boost/test/unit_test.hpp>

#include "dem/trajectory/h5md.hpp"
#include "dem/trajectory/vtk.hpp"
#include "tests/dem/trajectory/files.hpp"
#include "tests/dem/trajectory/frames.hpp"

BOOST_AUTO_TEST_SUITE(output_fields_test)

using namespace fiberchain::dem;
using namespace fiberchain::test;

namespace {

std::vector<float> singles(const std::vector<double>& values) { return {values.begin(), values.end()}; }

/// check(field, rows) for all fields of spheres and of bonds.
template <class Check>
void each_field(const TrajectoryFrame& frame, const Check& check) {
  for (const OutputField& field : sphere_fields) check(field, frame.position.size());
  for (const OutputField& field : bond_fields) check(field, frame.bonds.size());
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_set_as_they_are_got) {
  TrajectoryFrame frame = bent_fibers(3, 5, 7);
  each_field(frame, [&](const OutputField& field, std::size_t rows) {
    std::vector<double> values = field.values(frame);
    BOOST_TEST_REQUIRE(values.size() == rows * static_cast<std::size_t>(field.width), field.name);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.5 + static_cast<double>(i);
    field.set(frame, values);
    BOOST_TEST(field.values(frame) == values, field.name);
  });
}

BOOST_AUTO_TEST_CASE(a_trajectory_gives_every_field_back) {
  const Scratch scratch;
  const TrajectoryFrame frame = bent_fibers(4, 6, 9);
  TrajectoryWriter(scratch.path / "run.h5", {.author = "a", .creator_version = "1", .provenance = {}})
      .append(frame);
  const TrajectoryFrame read = TrajectoryReader(scratch.path / "run.h5").read(0);
  each_field(frame, [&](const OutputField& field, std::size_t) {
    BOOST_TEST(singles(field.values(read)) == singles(field.values(frame)), field.name);
  });
}

BOOST_AUTO_TEST_CASE(vtk_names_every_field) {
  const TrajectoryFrame frame = bent_fibers(2, 4, 1);
  const std::string vtp = vtp_spheres(frame, {});
  each_field(frame, [&](const OutputField& field, std::size_t) {
    const std::string array = "Name=\"" + std::string(field.point_array) + "\" NumberOfComponents=\"" +
                              std::to_string(field.width) + "\"";
    BOOST_TEST(vtp.find(array) != std::string::npos, field.name);
  });
}

BOOST_AUTO_TEST_SUITE_END()
