#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "dem/record/csv.hpp"
#include "dem/trajectory/checkpoint.hpp"
#include "tests/program/packings.hpp"

// Runs that go on: by --resume with the same physics, by start_from with any.
BOOST_AUTO_TEST_SUITE(start_from_test)

using namespace fiberchain::test;
namespace io = fiberchain::dem;
namespace fs = std::filesystem;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

/// Runs without pictures, which take longer than all else.
struct Undrawn : FewFibers {
  explicit Undrawn(int steps) : FewFibers(steps) {}
  Outcome go(const std::vector<std::string>& more = {}) const {
    return run(arguments(more), {.directory = path, .environment = {{"PATH", "/nonexistent"}}});
  }
  Outcome go(const std::string& scene, const std::string& text, std::vector<std::string> more = {}) const {
    file(scene, text);
    more.insert(more.begin(), {"run", scene, "--out", "next", "--jobs", "1"});
    return run(more, {.directory = path, .environment = {{"PATH", "/nonexistent"}}});
  }
  io::Checkpoint end(const std::string& name) const { return io::read_checkpoint(path / "next" / name); }
};

constexpr int kWhole = 9000, kPart = 5000;

/// The run that nothing interrupts.
const Undrawn& whole() {
  static const Undrawn fibers(kWhole);
  static const Outcome outcome = fibers.go();
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  return fibers;
}

const io::SavedState& whole_state() {
  static const io::SavedState state = io::read_checkpoint(whole().out("s.checkpoint")).state;
  return state;
}

/// A part of it.
const Undrawn& part() {
  static const Undrawn fibers(kPart);
  static const Outcome outcome = fibers.go();
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  return fibers;
}

const std::string kFrom = "start_from: out/s.checkpoint\n";

double largest_of(const std::vector<double>& a, const std::vector<double>& b) {
  BOOST_REQUIRE_EQUAL(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

const std::vector<double>& reals(const io::SavedState& state, const std::string& name) {
  return std::get<std::vector<double>>(state.find(name)->second.values);
}

void check_refused(const Outcome& outcome, const std::string& says) {
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(holds(outcome.error, says), outcome.error);
}

}  // namespace

BOOST_AUTO_TEST_CASE(started_from_its_end_it_ends_as_the_run_never_stopped) {
  const Outcome outcome = part().go("longer.yaml", kFrom + short_fibers(kWhole, few));
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(holds(outcome.error, "going on from step 5000 of 9000"), outcome.error);
  const io::Checkpoint end = part().end("longer.checkpoint");
  BOOST_TEST(end.step == kWhole);
  BOOST_TEST((end.state == whole_state()));
  BOOST_TEST(io::TrajectoryReader(part().path / "next/longer.h5").steps().front() == kPart);
}

BOOST_AUTO_TEST_CASE(killed_and_started_from_its_checkpoint_it_ends_alike) {
  const Undrawn fibers(kWhole);
  {
    Started program(fibers.arguments(), fibers.here());
    wait_until([&] { return fs::exists(fibers.out("s.checkpoint.previous")); });
    program.send(SIGKILL);
    BOOST_TEST(program.finish().status == 128 + SIGKILL);
  }
  BOOST_TEST(io::read_checkpoint(fibers.out("s.checkpoint")).step < kWhole);
  const Outcome outcome = fibers.go("again.yaml", kFrom + short_fibers(kWhole, few));
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST((fibers.end("again.checkpoint").state == whole_state()));
}

BOOST_AUTO_TEST_CASE(a_longer_duration_resumes) {
  const Undrawn fibers(kPart);
  BOOST_REQUIRE_EQUAL(fibers.go().status, 0);
  std::string text = "# now longer\n" + short_fibers(kWhole, few);
  text = replaced(text, "samples: 37, frames: 11, checkpoints: 23", "samples: 12, frames: 5, checkpoints: 3");
  fibers.file("s.yaml", text);
  const Outcome outcome = fibers.go({"--resume"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(!holds(outcome.error, "warning: out"), outcome.error);
  BOOST_TEST(!fs::exists(fibers.out("s-log.csv.bad")));
  BOOST_TEST((io::read_checkpoint(fibers.out("s.checkpoint")).state == whole_state()));
  const auto steps = io::TrajectoryReader(fibers.out("s.h5")).steps();
  BOOST_TEST((steps.front() == 0 && steps.back() == kWhole && steps.size() == 12u + 3));
}

BOOST_AUTO_TEST_CASE(other_physics_is_not_resumed) {
  const std::pair<std::string, std::string> changes[] = {{"friction: 0.3", "friction: 0.4"},
                                                         {"x: 24 mm", "x: 25 mm"},
                                                         {"damping: 1", "damping: 0.9"},
                                                         {"seed: 3", "seed: 4"},
                                                         {"-9.81", "-9.8"},
                                                         {"energy: true", "energy: false"},
                                                         {"count: 31", "count: 32"},
                                                         {"2.6 MPa", "2600001 Pa"}};
  const char* names[] = {"contacts.friction: 0.4, was 0.3",
                         "walls.box.x",
                         "fibers[0].bond.damping: 0.9, was 1",
                         "filling.seed: 4, was 3",
                         "gravity: [0, 0, -9.8], was [0, 0, -9.81]",
                         "output.energy: false, was true",
                         "fibers[0].count: 32, was 31",
                         "fibers[0].youngs_modulus: 2600001, was 2600000"};
  const Undrawn fibers(200);
  BOOST_REQUIRE_EQUAL(fibers.go().status, 0);
  for (std::size_t n = 0; n < std::size(changes); ++n) {
    fibers.file("s.yaml", replaced(short_fibers(300, few), changes[n].first, changes[n].second));
    check_refused(fibers.go({"--resume"}), names[n]);
  }
  fibers.file("s.yaml", short_fibers(199, few));
  check_refused(fibers.go({"--resume"}), "steps: steps = 199 is not allowed: out/s.checkpoint is of t = ");
}

BOOST_AUTO_TEST_CASE(what_changed_is_said_and_the_rest_goes_on) {
  std::string text = kFrom + short_fibers(kPart + 1000, few);
  text = replaced(text, "friction: 0.3", "friction: 0.6");
  text = replaced(text, "gravity: [0, 0, -9.81]", "gravity: [0, 0, 0]");
  text = replaced(text, "damping: 1", "damping: 0.5");
  text = replaced(text, "2.6 MPa", "2.5 MPa");
  const Outcome outcome = part().go("other.yaml", text);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(holds(outcome.error, "contacts.friction: 0.6, was 0.3"), outcome.error);
  BOOST_TEST(holds(outcome.error, "gravity: [0, 0, 0], was [0, 0, -9.81]"), outcome.error);
  BOOST_TEST(holds(outcome.error, "contacts keep their history"), outcome.error);
  const io::TrajectoryReader trajectory(part().path / "next/other.h5");
  const io::TrajectoryReader before(part().out("s.h5"));
  const io::TrajectoryFrame first = trajectory.read(0), last = before.read(before.frames() - 1);
  BOOST_TEST(first.time == last.time, boost::test_tools::tolerance(1e-12));
  for (std::size_t i = 0; i < first.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) BOOST_TEST(std::abs(first.position[i][c] - last.position[i][c]) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(another_step_follows_the_same_course) {
  const double step = reals(whole_state(), "time_step")[0];
  std::ostringstream half;  // the same end with half of the step
  half << std::setprecision(17) << "motion: {step: " << step / 2 << "}\nsteps: " << 2 * kWhole;
  const std::string text = replaced(kFrom + short_fibers(20000, few), "steps: 20000", half.str());
  const Outcome outcome = part().go("finer.yaml", text);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const auto far = largest_of(reals(part().end("finer.checkpoint").state, "position_radius"),
                              reals(whole_state(), "position_radius"));
  BOOST_TEST(far < 2e-4);  // a tenth of a diameter: collisions tell steps apart
}

BOOST_AUTO_TEST_CASE(a_resting_frame_stays_at_rest) {
  const Outcome outcome =
      part().go("frame.yaml", "start_from: {file: out/s.h5, clock: zero}\n" + short_fibers(300, few));
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(holds(outcome.error, "start_from: frame 11 of out/s.h5"), outcome.error);
  BOOST_TEST(holds(outcome.error, "a frame has no histories"), outcome.error);
  BOOST_TEST(part().end("frame.checkpoint").step == 300);
}

BOOST_AUTO_TEST_CASE(more_fibers_come_to_those_there) {
  std::string text = replaced("start_from: {file: out/s.checkpoint, clock: zero}\n" + short_fibers(300, few),
                              "count: 31", "count: 40");
  text = replaced(text, "z: [1 mm, 50 mm]", "z: [60 mm, 120 mm]");
  const Outcome outcome = part().go("more.yaml", text);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const io::TrajectoryReader trajectory(part().path / "next/more.h5");
  BOOST_TEST(trajectory.read(0).position.size() == 40u * 7);
  const Outcome again = part().go("more.yaml", replaced(text, "steps: 300", "steps: 400"), {"--resume"});
  BOOST_TEST(again.status == 0, again.error);
  BOOST_TEST(part().end("more.checkpoint").step == 400);
}

BOOST_AUTO_TEST_CASE(a_changed_run_resumes_without_its_file) {
  const Undrawn fibers(200);
  BOOST_REQUIRE_EQUAL(fibers.go().status, 0);
  const std::string text = replaced(kFrom + short_fibers(900, few), "friction: 0.3", "friction: 0.6");
  BOOST_REQUIRE_EQUAL(fibers.go("a.yaml", text).status, 0);
  BOOST_REQUIRE_EQUAL(fibers.go("b.yaml", replaced(text, "steps: 900", "steps: 500")).status, 0);
  fs::remove(fibers.out("s.checkpoint"));
  const Outcome outcome = fibers.go("b.yaml", text, {"--resume"});
  BOOST_TEST(outcome.status == 0, outcome.error);
  BOOST_TEST((fibers.end("a.checkpoint").state == fibers.end("b.checkpoint").state));
}

BOOST_AUTO_TEST_CASE(what_cannot_go_is_refused_by_its_key) {
  const std::string plain = kFrom + short_fibers(kWhole, few);
  const std::pair<std::string, const char*> faults[] = {
      {replaced(plain, "aspect_ratio: 6", "aspect_ratio: 7"), "fibers[0].aspect_ratio: "},
      {replaced(plain, "diameter: 2 mm", "diameter: 2.1 mm"), "fibers[0].diameter: "},
      {replaced(plain, "count: 31", "count: 30"), "fibers[0].count: "},
      {replaced(plain, "steps: 9000", "steps: 4999"), "steps: "},
      {replaced(plain, "out/s.checkpoint", "out/none.checkpoint"),
       "start_from: out/none.checkpoint: cannot open"},
      {replaced(plain, "out/s.checkpoint", "s.yaml"), "start_from: s.yaml: is no checkpoint"},
      {replaced(plain, "out/s.checkpoint", "{file: out/s.h5, frame: 12}"), "start_from.frame: "},
      {replaced(plain, "out/s.checkpoint", "{file: out/none.h5}"), "start_from: out/none.h5"},
      {replaced(
           replaced(plain, "box: {x: 24 mm, y: 22 mm, lid: open}", "box: {x: 24 mm, y: 9 mm, lid: open}"),
           "z: [1 mm, 50 mm]", "z: [1 mm, 50 mm], x: [1 mm, 20 mm], y: [1 mm, 8 mm]"),
       "its center is behind wall"},
  };
  for (const auto& [text, says] : faults) {
    const Outcome outcome = part().go("wrong.yaml", text);
    check_refused(outcome, says);
    BOOST_TEST(holds(outcome.error, "wrong.yaml:"), outcome.error);
    BOOST_TEST(!fs::exists(part().path / "next/wrong.checkpoint"));
    if (holds(outcome.error, "center is behind")) continue;  // no fiber is put anywhere
    const Outcome checked = run({"check", "wrong.yaml", "--jobs", "1"}, {.directory = part().path});
    BOOST_TEST(checked.status == 2);
    BOOST_TEST(is_one_error(checked.error), checked.error);
    BOOST_TEST(holds(checked.error, says), checked.error);
  }
}

BOOST_AUTO_TEST_CASE(a_scene_that_goes_on_is_checked_with_the_fibers_of_its_file) {
  part().file("fine.yaml",
              replaced("start_from: {file: out/s.checkpoint, clock: zero}\n" + short_fibers(300, few),
                       "count: 31", "count: 33"));
  const Outcome checked = run({"check", "fine.yaml", "--jobs", "1"}, {.directory = part().path});
  BOOST_TEST(checked.status == 0, checked.error);
  BOOST_TEST(holds(checked.out, "fibers           33\n"), checked.out);
}

/// Held, driven and loaded spheres among contacts by name: a run with another behind it, and one with none.
BOOST_AUTO_TEST_CASE(runs_with_held_spheres_resume_to_the_bit) {
  const auto text = [](int steps) {
    return replaced(
        short_fibers(steps, few), "friction: 0.3}",
        "friction: 0.3, pairs: [{between: [a, a], friction: 0.5}]}\n"
        "held:\n  - {name: clamp, fiber: 3, spheres: first}\n  - {fiber: 4, spheres: 2..4, place: x, turn: "
        "none, velocity: [0.2, 0, 0], from: 1 ms, until: 4 ms}\n"
        "loads: [{fiber: 5, spheres: last, force: [0, 0, 1e-4], ramp: 2 ms}]");
  };
  const auto named = [&](int steps) {
    return replaced(text(steps), "{diameter: 2 mm", "{name: a, diameter: 2 mm");
  };
  const Undrawn fibers(10);
  BOOST_REQUIRE_EQUAL(fibers.go("whole.yaml", named(900)).status, 0);
  const Outcome first = fibers.go("parts.yaml", named(500));
  BOOST_REQUIRE_MESSAGE(first.status == 0, first.error);
  const std::string log = content(fibers.path / "next/parts-held.csv");
  BOOST_TEST(holds(log, "clamp"), log);
  BOOST_REQUIRE_EQUAL(fibers.go("parts.yaml", named(900), {"--resume"}).status, 0);
  BOOST_TEST((fibers.end("whole.checkpoint").state == fibers.end("parts.checkpoint").state));
  const Outcome other = fibers.go("parts.yaml", replaced(named(900), "fiber: 3", "fiber: 2"), {"--resume"});
  check_refused(other, "held[0].fiber: 2, was 3");
}

BOOST_AUTO_TEST_SUITE_END()
