#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>
#include <vector>

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

/// Numbered pictures of one color scale; a film where ffmpeg is, and a word where it is not.
BOOST_FIXTURE_TEST_CASE(all_frames_become_pictures_and_a_film, Trajectory) {
  const Outcome outcome = render({"--frames", "all", "--color", "velocity", "--jobs", "200"});
  BOOST_TEST(outcome.status == 0, outcome.error);
  const std::size_t scale = outcome.out.find("color scale");
  const std::string words = outcome.out.substr(scale, outcome.out.find(" m/s", scale) - scale);
  std::size_t times = 0;
  for (std::size_t at = 0; (at = outcome.out.find(words, at)) != std::string::npos; ++at) ++times;
  BOOST_TEST(times == 3u, outcome.out);
  for (const char* name : {"fall-0000-velocity.png", "fall-0001-velocity.png", "fall-0002-velocity.png"})
    BOOST_TEST(fs::exists(path / "results" / name), name);
  const fs::path film = path / "results/fall-velocity.mp4";
  if (fs::exists(film))
    BOOST_TEST(fiberchain::test::content(film).substr(4, 4) == "ftyp");
  else
    BOOST_TEST(outcome.error.find("no film: ffmpeg is not installed") != std::string::npos, outcome.error);
}

/// What the color scale leaves out is counted.
BOOST_FIXTURE_TEST_CASE(values_beyond_the_scale_are_told, Trajectory) {
  const Outcome outcome = render({"--frame", "1", "--range", "-0.35,-0.3"});
  BOOST_TEST(outcome.status == 0, outcome.error);
  std::size_t below = 0, above = 0;
  for (const auto& v : bent_fibers(5, 9, 10).velocity) {
    below += static_cast<float>(v[2]) < -0.35;
    above += static_cast<float>(v[2]) > -0.3;
  }
  const std::string words =
      ", " + std::to_string(below) + " spheres below it and " + std::to_string(above) + " above\n";
  BOOST_TEST(below > 0u);
  BOOST_TEST(outcome.out.ends_with(words), outcome.out << " lacks " << words);
}

/// The files that a run with `vtk: true` writes.
BOOST_FIXTURE_TEST_CASE(frames_become_vtk_files, Trajectory) {
  const Outcome outcome =
      run({"export", "fall.h5", "--format", "vtk", "--frames", "1..2"}, {.directory = path});
  BOOST_TEST(outcome.status == 0, outcome.error);
  BOOST_TEST(outcome.out == "2 frames of 3\n");
  const std::string series = fiberchain::test::content(path / "results/fall.pvd");
  BOOST_TEST(series.find("fall/spheres-000000000010.vtp") != std::string::npos, series);
  BOOST_TEST(series.find("fall/spheres-000000000020.vtp") != std::string::npos, series);
  BOOST_TEST(fs::exists(path / "results/fall/lines-000000000020.vtp"));
}

/// LAMMPS's dump and extended XYZ: a line a sphere, places as in the trajectory.
BOOST_FIXTURE_TEST_CASE(frames_become_text, Trajectory) {
  for (const auto& [format, name, head] :
       {std::tuple{"lammps", "fall.lammpstrj", std::size_t{13}}, {"xyz", "fall.xyz", std::size_t{2}}}) {
    const Outcome outcome = run({"export", "fall.h5", "--format", format}, {.directory = path});
    BOOST_TEST(outcome.status == 0, outcome.error);
    BOOST_TEST(outcome.out == "3 frames of 3\n");
    std::ifstream file(path / "results" / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    BOOST_TEST_REQUIRE(lines.size() == 3 * (head + 45), name);
    // the first sphere of the second frame
    const auto x = fiberchain::dem::TrajectoryReader(path / "fall.h5").read(1).position[0];
    std::istringstream row(lines[head + 45 + head]);
    const std::vector<std::string> words{std::istream_iterator<std::string>(row), {}};
    const std::size_t from = std::string(format) == "lammps" ? 4 : 1;
    for (std::size_t c = 0; c < 3; ++c)
      BOOST_TEST(std::abs(std::stod(words.at(from + c)) - x[static_cast<int>(c)]) < 1e-12);
  }
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
      {{"render", "fall.h5", "--color", "red"},
       "--color: 'red' is not among vertical_speed, bending_angle, velocity"},
      {{"render", "fall.h5", "--color", "contact_force"}, "has no contacts (output.contacts)"},
      {{"render", "fall.h5", "--frames", "1..3"}, "--frames: '1..3' is not allowed"},
      {{"render", "fall.h5", "--frames", "2..1"}, "--frames: '2..1' is not allowed"},
      {{"render", "fall.h5", "--frames", "all", "--frame", "1"}, "exclude each other"},
      {{"export", "fall.h5", "--format", "pdb"}, "--format: 'pdb' is not among lammps, xyz, vtk"},
      {{"export", "text.h5"}, "text.h5: is no trajectory of fibers"},
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
