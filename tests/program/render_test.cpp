#include <boost/test/unit_test.hpp>
#include <fstream>

#include "dem/trajectory/h5md.hpp"
#include "tests/dem/trajectory/frames.hpp"
#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(render_test)

using fiberchain::test::bent_fibers;
using fiberchain::test::is_one_error;
using fiberchain::test::Outcome;
using fiberchain::test::run;
namespace fs = std::filesystem;

namespace {

/// Three frames of fibers that sink at about 0.3 m/s.
struct Trajectory : fiberchain::test::Scratch {
  Trajectory() {
    fiberchain::dem::TrajectoryWriter writer(path / "fall.h5", {"tester", "1", {}});
    for (const std::int64_t step : {0, 10, 20}) writer.append(bent_fibers(5, 9, step));
  }

  Outcome render(std::vector<std::string> more) const {
    more.insert(more.begin(), {"render", "fall.h5", "--width", "320", "--height", "200"});
    return run(more, {.directory = path});
  }
};

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(a_frame_becomes_a_picture, Trajectory) {
  const Outcome outcome = render({"--frame", "1", "--range", "-0.4,0"});
  BOOST_TEST(outcome.status == 0, outcome.error);
  BOOST_TEST(outcome.out ==
             "frame 1 of 3, step 10, time 0.0017 s, 45 spheres, color scale from -0.4 to 0 m/s\n");
  const std::string png = fiberchain::test::content(path / "results/fall-0001-vertical_speed.png");
  BOOST_REQUIRE(png.size() > 2000);
  BOOST_TEST(png.substr(1, 3) == "PNG");
  BOOST_TEST(big_endian(png, 16) == 320);
  BOOST_TEST(big_endian(png, 20) == 200);
  BOOST_TEST(png.find("fiberchain:commit") != std::string::npos);
  BOOST_TEST(png.find("render fall.h5") != std::string::npos);
  BOOST_TEST(outcome.error.find("fall-0001-vertical_speed.png") != std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(pictures_differ_by_what_they_show, Trajectory) {
  const auto picture = [&](const std::vector<std::string>& options, const char* name) {
    const Outcome outcome = render(options);
    BOOST_TEST(outcome.status == 0, outcome.error);
    return outcome.out + fiberchain::test::content(path / "results" / name);
  };
  const std::string last = picture({}, "fall-0002-vertical_speed.png");
  BOOST_TEST(last.starts_with("frame 2 of 3"));
  const std::string bent = picture({"--color", "bending_angle"}, "fall-0002-bending_angle.png");
  BOOST_TEST((bent.substr(bent.find("PNG")) != last.substr(last.find("PNG"))));
  BOOST_TEST(bent.find(" rad\n") != std::string::npos);
  const std::string turned = picture({"--azimuth", "20", "--jobs", "1"}, "fall-0002-vertical_speed.png");
  BOOST_TEST((turned.substr(turned.find("PNG")) != last.substr(last.find("PNG"))));
}

BOOST_FIXTURE_TEST_CASE(bad_input_is_one_clear_error, Trajectory) {
  std::ofstream(path / "text.h5") << "no trajectory";
  const std::pair<std::vector<std::string>, const char*> faults[] = {
      {{"render"}, "FILE is required"},
      {{"render", "none.h5"}, "none.h5: cannot open this file: No such file or directory"},
      {{"render", "."}, ".: is no regular file"},
      {{"render", "text.h5"}, "text.h5: is no trajectory of fibers"},
      {{"render", "fall.h5", "--frame", "3"}, "--frame: '3' is out of range"},
      {{"render", "fall.h5", "--frame", "first"}, "--frame: 'first' is no number"},
      {{"render", "fall.h5", "--color", "red"}, "--color: 'red' is not among vertical_speed, bending_angle"},
      {{"render", "fall.h5", "--range", "1"}, "--range: '1' wants two numbers"},
      {{"render", "fall.h5", "--range", "2,1"}, "--range: '2,1' does not rise"},
      {{"render", "fall.h5", "--elevation", "90"}, "--elevation: '90' is out of range"},
      {{"render", "fall.h5", "--width", "1e9"}, "--width: '1e9'"},
      {{"render", "fall.h5", "--out", "/proc/none"}, "cannot write /proc/none"},
  };
  for (const auto& [arguments, says] : faults) {
    const Outcome outcome = run(arguments, {.directory = path});
    BOOST_TEST(outcome.status == (std::string(says).starts_with("cannot write") ? 3 : 2), says);
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(outcome.error.find(says) != std::string::npos, outcome.error << " lacks " << says);
    BOOST_TEST(outcome.out == "");
  }
}

BOOST_AUTO_TEST_SUITE_END()
