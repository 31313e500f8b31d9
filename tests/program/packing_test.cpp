#include <boost/test/unit_test.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dem/record/csv.hpp"
#include "dem/trajectory/checkpoint.hpp"
#include "tests/program/packings.hpp"

BOOST_AUTO_TEST_SUITE(packing_test)

using namespace fiberchain::test;
namespace io = fiberchain::dem;
namespace fs = std::filesystem;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

void flip_a_byte(const fs::path& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(2000);
  const int byte = file.get();
  file.seekp(2000);
  file.put(static_cast<char>(byte ^ 16));
}

/// The run that nothing befalls.
const FewFibers& undisturbed() {
  static const FewFibers fibers;
  static const Outcome outcome = fibers.go();
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  return fibers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_small_packing_leaves_all_its_files) {
  const Scratch scratch;
  std::string text = content(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes/packing-small.yaml");
  const auto at = text.find("duration: 0.1 s");
  BOOST_REQUIRE(at != std::string::npos);
  text.replace(at, 15, "duration: 4 ms");
  const auto output = text.find("output: {");
  BOOST_REQUIRE(output != std::string::npos);
  scratch.file("small.yaml", text.insert(output + 9, "vtk: true, contacts: true, "));
  const Outcome outcome = run({"run", "small.yaml", "--json", "--jobs", "1"}, {.directory = scratch.path});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const auto row = nlohmann::json::parse(outcome.out)["rows"][0];
  BOOST_TEST(row["fibers"] == 200);
  BOOST_TEST(row["spheres"] == 4200);
  BOOST_TEST(row["status"] == "finished");
  BOOST_TEST(row["step_set_by"] == "bond damping");
  const double step = row["time_step"].get<double>();
  BOOST_TEST(std::abs(row["steps"].get<double>() * step - 4e-3) < step);
  BOOST_TEST(holds(outcome.error, "0.9 of what is stable, set most by bond damping; each alone: bonds"));
  const fs::path results = scratch.path / "results";
  for (const char* end : {".csv", ".md", "-log.csv", ".checkpoint", ".checkpoint.previous", ".h5", ".h5md",
                          ".pvd", "-lines.pvd", "-contacts.pvd", "-walls.pvd"}) {
    BOOST_TEST(fs::file_size(results / (std::string("small") + end)) > 100, end);
  }
  for (const char* end : {"-bending.svg", "-bending.png", "-energy.svg", "-energy.png"}) {
    BOOST_TEST(!fs::exists(results / (std::string("small") + end)), end);  // nobody asked for pictures
    BOOST_TEST(fs::file_size(undisturbed().out(std::string("s") + end)) > 1000, end);
  }
  const io::TrajectoryReader trajectory(results / "small.h5");
  BOOST_TEST(trajectory.frames() == 11);
  BOOST_TEST(trajectory.steps().back() == row["steps"].get<std::int64_t>());
  BOOST_TEST(files_under(results / "small") == 34);  // spheres, lines, contacts; one of walls that stay
  for (std::int64_t n = 0; n < 11; ++n) {
    const io::TrajectoryFrame frame = trajectory.read(n);
    BOOST_TEST(frame.has_contacts);
    BOOST_TEST(
        (trajectory.scalars(n) == io::Scalars{{"contacts", static_cast<double>(frame.contacts.size())}}));
    BOOST_TEST(frame.walls.size() == trajectory.walls().size());
  }
  const io::TrajectoryFrame last = trajectory.read(10);
  BOOST_TEST(last.position.size() == 4200);
  BOOST_TEST(last.bonds.size() == 4000);
  BOOST_TEST((last.low[2] == 0 && last.high[0] == 0.05));
  const Outcome picture =
      run({"render", "results/small.h5", "--width", "320", "--height", "200"}, {.directory = scratch.path});
  BOOST_TEST(picture.status == 0, picture.error);
  const io::Checkpoint checkpoint = io::read_checkpoint(results / "small.checkpoint");
  BOOST_TEST(checkpoint.step == row["steps"].get<std::int64_t>());
  BOOST_TEST(checkpoint.scene == text);
}

BOOST_AUTO_TEST_CASE(softened_contacts_are_followed_and_warned_of) {
  const FewFibers fibers;
  std::string text = short_fibers(9000, few);
  fibers.file("s.yaml", text.replace(text.find("contacts: {"), 11, "contacts: {youngs_modulus: 150 kPa, "));
  const Outcome outcome = fibers.go({"--json"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(holds(outcome.error, "of the smaller radius; warning: beyond 0.1 contacts are too soft"));
  const std::string warning = "warning: a contact has overlapped by";
  const auto first = outcome.error.find(warning), last = outcome.error.rfind(warning);
  BOOST_TEST((first < last && outcome.error.rfind("t = ", first) != std::string::npos), outcome.error);
  BOOST_TEST(outcome.error.find(warning, first + 1) == last,
             outcome.error);  // once on its way, once at the end
  const auto row = nlohmann::json::parse(outcome.out)["rows"][0];
  const io::Table log = io::read_csv(fibers.out("s-log.csv")).table;
  const std::size_t end = log.rows().size() - 1;
  BOOST_TEST(row["overlap_mean"].get<double>() == log.number(end, "overlap_mean"));
  BOOST_TEST(row["overlap_peak"].get<double>() == log.number(end, "overlap_peak"));
  BOOST_TEST(log.number(end, "overlap_mean") > 1e-3);
  BOOST_TEST(log.number(end, "overlap_peak") > 0.1);
  for (std::size_t n = 1; n <= end; ++n) {
    BOOST_TEST(log.number(n, "overlap_peak") >= log.number(n - 1, "overlap_peak"));
    BOOST_TEST(log.number(n, "overlap_peak") >= log.number(n, "overlap_mean"));
  }
  const auto plain = undisturbed().out("s-log.csv");  // the fibers' own modulus
  BOOST_TEST(io::read_csv(plain).table.number(end, "overlap_peak") < 0.7 * log.number(end, "overlap_peak"));
}

BOOST_AUTO_TEST_CASE(killed_at_any_moment_it_resumes_and_ends_the_same) {
  const FewFibers fibers;
  BOOST_TEST(kill_and_resume(fibers, {0, 7, 31}) >= 2);
  const fs::path journal = fibers.out("..s.h5.journal.4194303.part");
  std::ofstream(journal) << "half";
  const fs::path left[] = {fibers.out("s/.lines-000000000007.vtp.4194303.part"),
                           fibers.out(".s.csv.4194303.part"), fibers.out(".other.csv.4194303.part")};
  for (const fs::path& path : left) std::ofstream(path) << "half";
  BOOST_TEST(fibers.go({"--resume"}).status == 0);
  BOOST_TEST((!fs::exists(left[0]) && !fs::exists(left[1]) && fs::exists(left[2]) && !fs::exists(journal)));
  BOOST_TEST(same_end(fibers, undisturbed()));
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  const Crowd crowd{1500, "500 mm"};  // 10 500 spheres: fewer would take one thread
  const FewFibers fibers(200, "", crowd), others(200, "", crowd);
  BOOST_TEST(fibers.go().status == 0);
  BOOST_TEST(run({"run", "s.yaml", "--out", "out", "--threads", "2"}, others.here()).status == 0);
  BOOST_TEST((io::read_checkpoint(fibers.out("s.checkpoint")).state ==
              io::read_checkpoint(others.out("s.checkpoint")).state));
}

BOOST_AUTO_TEST_CASE(fibers_whose_bonds_are_solved_for_survive_a_kill) {
  const std::string stiff = "}\nmotion: {integrator: leapfrog-stiff";  // behind the filling
  const FewFibers fibers(8000, stiff), others(8000, stiff);
  BOOST_REQUIRE_EQUAL(others.go().status, 0);
  BOOST_TEST(kill_and_resume(fibers, {0, 7}) >= 1);
  BOOST_TEST(same_end(fibers, others));
}

BOOST_AUTO_TEST_CASE(fibers_that_come_in_batches_survive_a_kill) {
  const std::string batches = ", batches: {number: 3, interval: 15 ms}";
  const FewFibers fibers(12000, batches), others(12000, batches);
  BOOST_REQUIRE_EQUAL(others.go().status, 0);
  BOOST_TEST(kill_and_resume(fibers, {2, 9}) >= 1);
  BOOST_TEST(same_end(fibers, others));
  const io::TrajectoryReader trajectory(fibers.out("s.h5"));
  BOOST_TEST(trajectory.read(0).position.size() == 7u * 10);
  BOOST_TEST(trajectory.read(11).position.size() == 7u * 31);
}

BOOST_AUTO_TEST_CASE(signals_stop_it_at_a_checkpoint) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const FewFibers fibers;
    Started program(fibers.arguments(), fibers.here());
    wait_until([&] { return fs::exists(fibers.out("s.checkpoint.previous")); });
    program.send(signal);
    const Outcome stopped = program.finish();
    BOOST_TEST(stopped.status == 128 + signal);
    BOOST_TEST(holds(stopped.error, "to go on: fiberchain run s.yaml --out out --resume"), stopped.error);
    BOOST_TEST(stopped.out == "");
    BOOST_TEST(!fs::exists(fibers.out("s.csv")));
    const Outcome resumed = fibers.go({"--resume"});
    BOOST_TEST(resumed.status == 0, resumed.error);
    BOOST_TEST(same_end(fibers, undisturbed()));
  }
}

BOOST_AUTO_TEST_CASE(one_run_at_a_time_and_none_overwritten) {
  const FewFibers fibers(2000000);
  Started first(fibers.arguments(), fibers.here());
  wait_until([&] { return fs::exists(fibers.out("s.checkpoint")); });
  for (const char* how : {"--resume", "--force"}) {
    const Outcome second = fibers.go({how});
    BOOST_TEST(second.status == 3);
    BOOST_TEST(holds(second.error, "cannot write out: another run is at work in this directory"),
               second.error);
  }
  first.send(SIGTERM);
  BOOST_TEST(first.finish().status == 143);
  const std::string checkpoint = content(fibers.out("s.checkpoint"));
  const Outcome again = fibers.go();
  BOOST_TEST(again.status == 2);
  BOOST_TEST(holds(again.error, "s.checkpoint is there already, of a run before: --resume goes on with it"),
             again.error);
  BOOST_TEST((content(fibers.out("s.checkpoint")) == checkpoint));
  BOOST_TEST(fibers.go({"--force", "--resume"}).status == 2);
  fibers.file("s.yaml", short_fibers(500, few));
  const Outcome rebuilt = fibers.go({"--force"});
  BOOST_TEST(rebuilt.status == 0, rebuilt.error);
  BOOST_TEST(io::read_checkpoint(fibers.out("s.checkpoint")).step == 500);
}

BOOST_AUTO_TEST_CASE(what_is_not_of_a_run_stays) {
  const FewFibers fibers(500);
  BOOST_REQUIRE_EQUAL(fibers.go().status, 0);
  std::ofstream(fibers.out("s/notes.txt")) << "mine";
  const Outcome rebuilt = fibers.go({"--force"});
  BOOST_TEST(rebuilt.status == 0, rebuilt.error);
  BOOST_TEST(content(fibers.out("s/notes.txt")) == "mine");
  BOOST_TEST(files_under(fibers.out("s")) == 26);  // two a frame, the walls, the notes
  fs::remove(fibers.out("s.checkpoint"));
  fs::remove(fibers.out("s.checkpoint.previous"));
  const std::string trajectory = content(fibers.out("s.h5"));
  const Outcome resumed = fibers.go({"--resume"});
  BOOST_TEST(resumed.status == 2);
  BOOST_TEST(holds(resumed.error, "s.h5: holds a run up to step 500, of which no checkpoint is there"),
             resumed.error);
  BOOST_TEST((content(fibers.out("s.h5")) == trajectory));
}

BOOST_AUTO_TEST_CASE(fibers_that_lie_in_each_other_are_refused) {
  const Scratch scratch;
  scratch.file("starts.csv",
               "x,y,z,ux,uy,uz\n0.01,0.01,0.02,1,0,0\n0.01,0.0122,0.02,0.8,0.6,0\n"
               "0.01,0.0107,0.02,1,0,0\n");
  std::string text = short_fibers(10, few);
  text.replace(text.find("count: 31"), 9, "starts: starts.csv");
  const auto filling = text.find("filling:");
  text.erase(filling, text.find("walls:") - filling);
  scratch.file("s.yaml", text);
  const Outcome outcome = run({"run", "s.yaml"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(holds(outcome.error, "starts.csv:4: sphere 0 of fiber 2 is not allowed there"), outcome.error);
}

BOOST_AUTO_TEST_CASE(a_finished_run_resumes_to_itself) {
  const std::string before = content(undisturbed().out("s.checkpoint")),
                    log = content(undisturbed().out("s-log.csv")),
                    trajectory = content(undisturbed().out("s.h5"));
  const Outcome again = undisturbed().go({"--resume"});
  BOOST_TEST(again.status == 0, again.error);
  BOOST_TEST(holds(again.out, "finished"));
  BOOST_TEST((content(undisturbed().out("s.checkpoint")) == before));
  BOOST_TEST((content(undisturbed().out("s-log.csv")) == log));
  BOOST_TEST((content(undisturbed().out("s.h5")) == trajectory));
}

BOOST_AUTO_TEST_CASE(checkpoints_that_cannot_be_used_are_refused) {
  const FewFibers fibers(2000), others(2000);
  BOOST_REQUIRE_EQUAL(fibers.go().status, 0);
  BOOST_REQUIRE_EQUAL(others.go().status, 0);
  const fs::path last = fibers.out("s.checkpoint"), previous = fibers.out("s.checkpoint.previous");
  flip_a_byte(last);
  const Outcome from_previous = fibers.go({"--resume"});
  BOOST_TEST(from_previous.status == 0, from_previous.error);
  BOOST_TEST(holds(from_previous.error,
                   "s.checkpoint: is corrupt: its checksum is not that of its content; going on "
                   "from the one before, of step 1913"),
             from_previous.error);
  BOOST_TEST(same_end(fibers, others));

  io::Checkpoint foreign = io::read_checkpoint(last);
  fibers.file("s.yaml", short_fibers(2000, few, ", gap: 1 nm"));
  const Outcome other_scene = fibers.go({"--resume"});
  BOOST_TEST(other_scene.status == 2);
  BOOST_TEST(holds(other_scene.error, "s.checkpoint: belongs to another scene: filling.gap: "),
             other_scene.error);
  fibers.file("s.yaml", short_fibers(2000, few));
  foreign.program += " of old";
  io::write_checkpoint(last, foreign);
  const Outcome other_program = fibers.go({"--resume"});
  BOOST_TEST(other_program.status == 2);
  BOOST_TEST(holds(other_program.error, "s.checkpoint: was written by another program"), other_program.error);
  flip_a_byte(last);
  flip_a_byte(previous);
  const Outcome corrupt = fibers.go({"--resume"});
  BOOST_TEST(corrupt.status == 2);
  BOOST_TEST(holds(corrupt.error, "no checkpoint to go on from: out/s.checkpoint: is corrupt"),
             corrupt.error);
}

BOOST_AUTO_TEST_CASE(a_full_disk_ends_it_and_keeps_what_is_good) {
  const FewFibers fibers;
  Circumstances full = fibers.here();
  full.largest_file = 110'000;
  const Outcome ended = run(fibers.arguments(), full);
  BOOST_TEST(ended.status == 3);
  BOOST_TEST(holds(ended.error, "cannot write out/s.h5: File too large"), ended.error);
  BOOST_TEST(holds(ended.error, "with --resume the run goes on from there"), ended.error);
  BOOST_TEST(io::TrajectoryReader(fibers.out("s.h5")).frames() >= 1);
  const Outcome resumed = fibers.go({"--resume"});
  BOOST_TEST(resumed.status == 0, resumed.error);
  BOOST_TEST(same_end(fibers, undisturbed()));
}

BOOST_AUTO_TEST_CASE(what_blows_up_says_where_and_can_be_looked_at) {
  const FewFibers fibers;
  std::string text = short_fibers(15000, few);
  fibers.file("s.yaml", text.replace(text.find("velocity: [0, 0, -1]"), 20, "velocity: [0, 0, -999]"));
  const Outcome outcome = fibers.go();
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(holds(outcome.error, "fiberchain: error: "), outcome.error);
  BOOST_TEST(holds(outcome.error, "fiber "), outcome.error);
  BOOST_TEST(holds(outcome.error, "sphere "), outcome.error);
  BOOST_TEST(holds(content(fibers.out("s.csv")), "likely cause"));
  BOOST_TEST(io::read_checkpoint(fibers.out("s.checkpoint")).step >= 0);
  BOOST_TEST(io::TrajectoryReader(fibers.out("s.h5")).frames() >= 1);
}

BOOST_AUTO_TEST_CASE(wrong_scenes_leave_nothing_behind) {
  const std::pair<std::string, const char*> faults[] = {
      {short_fibers(10, few) + "colour: red\n", "unknown key 'colour'"},
      {short_fibers(10, few, ", gap: 9 mm"), "found no place"},
      {short_fibers(10, few, ", orientation: near_axis"), "filling: key 'direction' is missing"},
  };
  for (const auto& [text, says] : faults) {
    const FewFibers fibers;
    fibers.file("s.yaml", text);
    const Outcome outcome = fibers.go();
    BOOST_TEST((outcome.status == 2 || outcome.status == 3));
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(holds(outcome.error, says), outcome.error);
    BOOST_TEST(!fs::exists(fibers.path / "out"));
  }
  const Scratch scratch;
  scratch.file("r.yaml", content(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes/cantilever.yaml"));
  const Outcome outcome = run({"run", "r.yaml", "--resume"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(holds(outcome.error, "--resume: is of use only with scene: packing"), outcome.error);
}

BOOST_AUTO_TEST_SUITE_END()
