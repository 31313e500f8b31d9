// Fibers' starts from CSV text: what is read, and what is refused and where.
#include "dem/scene/fiber_csv.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "dem/scene/scene_error.hpp"

BOOST_AUTO_TEST_SUITE(fiber_csv_test)

namespace dem = fiberchain::dem;

namespace {

std::vector<dem::FiberStart> read(const std::string& text) {
  std::istringstream stream(text);
  return dem::read_fiber_starts(stream, "fibers.csv");
}

void refused(const std::string& text, const std::string& place, const std::string& what) {
  BOOST_CHECK_EXCEPTION(read(text), dem::SceneError, [&](const dem::SceneError& e) {
    const std::string message = e.what();
    BOOST_TEST_MESSAGE(message);
    return message.starts_with(place) && message.find(what) != std::string::npos &&
           message.find('\n') == std::string::npos;
  });
}

const std::string header = "x,y,z,ux,uy,uz,vx,vy,vz\n";

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_go_where_the_header_says) {
  const auto starts = read(
      "# a comment, with commas\n\nuz, uy,ux,x,y,z\r\n1,0,0, 1.5e-3,-2,+3\r\n # another\n0,-0.6,0.8,4,5,6");
  BOOST_REQUIRE(starts.size() == 2u);
  BOOST_TEST(starts[0].position[0] == 1.5e-3);
  BOOST_TEST(starts[0].position[1] == -2);
  BOOST_TEST(starts[0].position[2] == 3);
  BOOST_TEST(starts[0].direction[2] == 1);
  BOOST_TEST(starts[0].velocity[2] == 0);
  BOOST_TEST(starts[1].direction[0] == 0.8);
  BOOST_TEST(starts[1].direction[1] == -0.6);
  const auto moving = read("\xEF\xBB\xBF" + header + "1,2,3,0,1,0,7,8,9\n");
  BOOST_TEST(moving[0].velocity[0] == 7);
  BOOST_TEST(moving[0].velocity[2] == 9);
}

BOOST_AUTO_TEST_CASE(a_fiber_starts_there) {
  const dem::Chain<3> chain = dem::straight_chain<3>({dem::isotropic_material(1e7, 0.3, 1000), 2e-3, 20});
  const auto start = read(header + "0.01,0.02,0.03,0.36,0.48,-0.8,1,2,3\n")[0];
  const dem::ChainState<3> state = placed(chain, start);
  BOOST_TEST(state.poses.size() == 21u);
  BOOST_TEST(norm(state.poses[0].position - dem::Vec<double, 3>{0.01, 0.02, 0.03}) == 0);
  BOOST_TEST(norm(state.poses[20].position - state.poses[0].position - 0.04 * start.direction) < 1e-16);
  for (const auto& pose : state.poses) BOOST_TEST(norm(axis(pose) - start.direction) < 1e-15);
  BOOST_TEST(norm(state.velocity[20] - start.velocity) == 0);
  BOOST_TEST(dem::elastic_energy(chain, state.poses) < 1e-25);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_said_with_line_and_column) {
  refused("", "fibers.csv: ", "no line of column names");
  refused("# only\n", "fibers.csv: ", "no line of column names");
  refused(header, "fibers.csv: ", "no fiber");
  refused("x,y,z,ux,uy\n", "fibers.csv:1: ", "'uz' is missing");
  refused("x,y,z,ux,uy,uz,vx\n", "fibers.csv:1: ", "'vy' is missing");
  refused("x,y,z,ux,uy,uz,w\n", "fibers.csv:1: ", "'w' is unknown");
  refused("#\nx,y,x,ux,uy,uz\n", "fibers.csv:2: ", "'x' stands twice");
  refused("# c\n" + header + "1,2,3,0,1,0,7,8\n", "fibers.csv:3: ", "8 fields");
  refused(header + "1,2,3,0,1,0,7,8,9,\n", "fibers.csv:2: ", "10 fields");
  refused(header + "1,2,3,0,1,0,7,8,9\n1,2,3a,0,1,0,7,8,9\n", "fibers.csv:3: ", "'z': '3a'");
  refused(header + "1,2,3,0,1,0,7,,9\n", "fibers.csv:2: ", "'vy'");
  refused(header + "1,2,inf,0,1,0,7,8,9\n", "fibers.csv:2: ", "'z'");
  refused(header + "1,2,3,0,1.01,0,7,8,9\n", "fibers.csv:2: ", "length is 1.01");
  refused(header + "1,2,3,0,0,0,7,8,9\n", "fibers.csv:2: ", "length is 0");
  refused(header + "1,2,3" + '\0' + ",0,1,0,7,8,9\n", "fibers.csv:2: ", "'z'");
  refused(header + "1,2,3,0,1,0,\x1b[31m7,8,9\n", "fibers.csv:2: ", "'vx'");
  BOOST_CHECK_THROW(dem::read_fiber_starts(std::string("/nonexistent/fibers.csv")), dem::SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
