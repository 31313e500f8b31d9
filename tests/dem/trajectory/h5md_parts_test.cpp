#include <boost/test/unit_test.hpp>

#include "dem/model/errors.hpp"
#include "tests/dem/trajectory/files.hpp"
#include "tests/dem/trajectory/h5md_frames.hpp"

BOOST_AUTO_TEST_SUITE(h5md_parts_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::test;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(contacts_come_back) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  TrajectoryHeader with = kHeader;
  with.contacts = true;
  TrajectoryWriter writer(path, kHeader);
  write_frames(writer, 0, 20);
  TrajectoryWriter begun = TrajectoryWriter::resume(path, with, 15);
  for (const std::int64_t step : {20, 30, 40, 50}) {
    TrajectoryFrame frame = with_contacts(bent_fibers(3, 7, step));
    if (step == 30) frame.contacts.clear();
    begun.append(frame, {{"height", 1}});
  }
  TrajectoryWriter ended = TrajectoryWriter::resume(path, kHeader, 40);
  ended.append(bent_fibers(3, 7, 60), {{"height", 1}});
  ended.append(with_contacts(bent_fibers(3, 7, 70)), {{"height", 1}});
  const TrajectoryReader reader(path);
  const std::size_t expected[] = {0, 0, 3, 0, 3, 0, 3};
  for (std::int64_t n = 0; n < reader.frames(); ++n) {
    const TrajectoryFrame frame = reader.read(n);
    BOOST_TEST(frame.has_contacts == (n >= 2 && n != 5), "frame " << n);
    BOOST_TEST_REQUIRE(frame.contacts.size() == expected[n], "frame " << n);
    const TrajectoryFrame written = with_contacts(frame);
    for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
      const FrameContact &found = frame.contacts[i], &wanted = written.contacts[i];
      BOOST_TEST(found.first == wanted.first);
      BOOST_TEST(found.second == wanted.second);
      BOOST_TEST((found.kind == wanted.kind));
      check_equal(found.point, wanted.point, 0);
      check_equal(found.normal, wanted.normal, 6e-8);
      check_equal(found.force, wanted.force, 6e-8);
    }
  }
  TrajectoryFrame alone = with_contacts(bent_fibers(3, 7, 80));
  alone.contacts[0].second = 21;
  BOOST_CHECK_THROW(ended.append(alone, {{"height", 1}}), InvalidInput);
}

/// Numbers of contacts follow spheres that are there.
BOOST_AUTO_TEST_CASE(contacts_of_the_spheres_that_are_there) {
  TrajectoryFrame frame = with_contacts(bent_fibers(3, 7, 0));
  frame.missing = {0, 1, 2, 3, 4, 5, 6};
  frame.contacts = {{8, 15, ContactKind::fibers, {}, {}, {}}, {9, 3, ContactKind::wall, {}, {}, {}}};
  const TrajectoryFrame present = present_part(frame);
  BOOST_TEST(present.contacts[0].first == 1);
  BOOST_TEST(present.contacts[0].second == 8);
  BOOST_TEST(present.contacts[1].first == 2);
  BOOST_TEST(present.contacts[1].second == 3);
}

BOOST_AUTO_TEST_CASE(walls_come_back) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  TrajectoryHeader header = kHeader;
  header.walls = two_walls();
  TrajectoryWriter writer(path, header);
  for (const std::int64_t step : {0, 10}) writer.append(with_walls(bent_fibers(3, 7, step)));
  TrajectoryWriter::resume(path, header, 10).append(with_walls(bent_fibers(3, 7, 20)));
  BOOST_CHECK_THROW(writer.append(bent_fibers(3, 7, 30)), InvalidInput);
  const TrajectoryReader reader(path);
  BOOST_TEST_REQUIRE(reader.walls().size() == 2);
  for (std::size_t w = 0; w < 2; ++w) {
    BOOST_TEST(reader.walls()[w].shape == header.walls[w].shape);
    BOOST_TEST((reader.walls()[w].triangles == header.walls[w].triangles));
    for (std::size_t i = 0; i < header.walls[w].points.size(); ++i)
      check_equal(reader.walls()[w].points.at(i), header.walls[w].points[i], 0);
  }
  for (std::int64_t n = 0; n < 3; ++n) {
    const auto found = reader.read(n).walls, wanted = with_walls(bent_fibers(3, 7, 10 * n)).walls;
    BOOST_TEST_REQUIRE(found.size() == 2);
    for (std::size_t w = 0; w < 2; ++w) {
      check_equal(found[w].offset, wanted[w].offset, 0);
      check_equal(found[w].turn.v, wanted[w].turn.v, 0);
      BOOST_TEST(found[w].turn.w == wanted[w].turn.w);
      BOOST_TEST(found[w].is_there == wanted[w].is_there);
    }
  }
}

/// A file of before walls and contacts were in it, with bonds in a group and a box by its edges: numbers as
/// h5py reads them.
BOOST_AUTO_TEST_CASE(files_of_an_earlier_version_are_read) {
  const TrajectoryReader reader(std::string(FIBERCHAIN_SOURCE_DIR) + "/tests/dem/trajectory/earlier.h5");
  BOOST_TEST_REQUIRE(reader.frames() == 2);
  BOOST_TEST(reader.walls().empty());
  BOOST_TEST((reader.scalars(1).front().first == "contacts"));
  const TrajectoryFrame frame = reader.read(1);
  BOOST_TEST_REQUIRE(frame.position.size() == 12);
  check_equal(frame.position[11], {0.01026924393988793, 0.00254774049997764, 0.00158160797654716}, 1e-14);
  check_equal(frame.high - frame.low, {0.012, 0.011, 0.012}, 1e-15);
  check_equal(frame.bonds.at(4).force, {3.5429678e-16, 9.2721012e-16, -8.3949144e-16}, 1e-7);
  BOOST_CHECK_CLOSE_FRACTION(frame.bonds.at(7).bending_angle, 0.04700789, 1e-6);
  BOOST_TEST(!frame.has_contacts);
}

BOOST_AUTO_TEST_SUITE_END()
