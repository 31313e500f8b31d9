#define BOOST_TEST_MODULE mpi_packing_test
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "dem/assembly/carried_state.hpp"
#include "dem/record/csv.hpp"
#include "dem/run/run_packing.hpp"
#include "dem/scene/scene.hpp"
#include "dem/trajectory/checkpoint.hpp"
#include "dem/trajectory/h5md.hpp"
#include "tests/lammps/mpi_process.hpp"

// fiberchain-mpi on one rank and several against the engine itself: the same laws, summed in other orders.
BOOST_AUTO_TEST_SUITE(mpi_packing_test)

using namespace fiberchain::dem;
using namespace fiberchain::test::mpi;

namespace {

/// Short thick fibers of odd numbers that fall into a box, a plate on them from the middle of the run on.
std::string falling(int steps, const std::string& motion, const std::string& more, const std::string& walls) {
  return fmt::format(
      "scene: packing\n"
      "fibers:\n"
      "  - {{diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: 1300 "
      "kg/m^3,\n"
      "     bond: {{damping: 0.7}}, count: 23}}\n"
      "  - {{diameter: 1.5 mm, aspect_ratio: 9, youngs_modulus: 3.1 MPa, poisson_ratio: 0.3, density: 1100 "
      "kg/m^3,\n"
      "     bond: {{damping: 1}}, mass: cylinder, count: 9}}\n"
      "filling: {{region: {{z: [1 mm, 36 mm]}}, velocity: [0.1, 0, -2], seed: 3}}\n"
      "{}gravity: [0.4, 0, -9.81]\n"
      "contacts: {{restitution: 0.5, friction: 0.3{}}}\n"
      "motion: {{{}}}\n"
      "steps: {}\n"
      "output: {{samples: 10, frames: 4, checkpoints: 4}}\n",
      walls, more, motion, steps);
}

constexpr const char* kBox = "walls: {box: {x: 24 mm, y: 22 mm, lid: open}}\n";

/// The engine's own run of the scene, in `own`.
void run_here(const Scratch& scratch) {
  const SceneText text = read_scene_text(scratch.path / "s.yaml");
  const PackingEndState end =
      run_scene(text, std::get<PackingScene>(parse_scene(text)), {.directory = scratch.path / "own"});
  BOOST_REQUIRE_MESSAGE(end.finished(), end.failure);
}

CarriedState end_of(const fs::path& directory) {
  return carried_state(read_checkpoint(directory / "s.checkpoint").state);
}

/// The largest distance of spheres in the two states [m], and that over speeds.
double largest_distance(const CarriedState& a, const CarriedState& b) {
  double most = 0;
  BOOST_REQUIRE_EQUAL(a.groups.size(), b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    for (std::size_t f = 0; f < a.groups[g].fibers.size(); ++f) {
      const ChainState<3>&x = a.groups[g].fibers[f], &y = b.groups[g].fibers[f];
      for (std::size_t i = 0; i < x.poses.size(); ++i)
        most = std::max(most, norm(x.poses[i].position - y.poses[i].position));
    }
  }
  return most;
}

/// The logs alike but for words and the clock's columns: numbers to `part` of the largest in their column.
void check_same_logs(const Scratch& scratch, const std::string& directory, const char* name, double part,
                     bool periodic = false) {
  std::vector<std::string> left_out{"step_rate", "time_left", "wall_name", "wall_shape"};
  // moments are of the images of spheres in the cell, there of where they have gone to
  if (periodic)
    left_out.insert(left_out.end(), {"wall_moment_x", "wall_moment_y", "wall_moment_z", "wall_moment_peak"});
  const Table a = read_csv(scratch.path / "own" / name).table,
              b = read_csv(scratch.path / directory / name).table;
  BOOST_REQUIRE_EQUAL(a.rows().size(), b.rows().size());
  BOOST_TEST(a.columns() == b.columns(), boost::test_tools::per_element());
  for (const std::string& column : a.columns()) {
    if (std::ranges::find(left_out, column) != left_out.end()) continue;
    double largest = 0;
    for (std::size_t row = 0; row < a.rows().size(); ++row)
      largest = std::max(largest, std::abs(a.number(row, column)));
    for (std::size_t row = 0; row < a.rows().size(); ++row) {
      const double difference = std::abs(a.number(row, column) - b.number(row, column));
      BOOST_TEST(!(difference > part * largest), column << " in row " << row << ": " << a.number(row, column)
                                                        << " " << b.number(row, column));
    }
  }
}

/// The scene here and over these ranks: ends and logs alike.
void check_as_here(const std::string& scene, const std::vector<std::pair<int, std::string>>& ways,
                   double distance) {
  const Scratch scratch;
  scratch.file("s.yaml", scene);
  run_here(scratch);
  const CarriedState own = end_of(scratch.path / "own");
  BOOST_TEST(own.contacts.size() > 10u);
  for (const auto& [ranks, how] : ways) {
    const std::string directory = fmt::format("of-{}{}", ranks, how);
    const Outcome outcome = go(scratch, ranks, fmt::format("run s.yaml --out '{}' {}", directory, how));
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
    const CarriedState end = end_of(scratch.path / directory);
    BOOST_TEST(largest_distance(own, end) < distance,
               fmt::format("{}: {}", directory, largest_distance(own, end)));
    BOOST_TEST(end.contacts.size() == own.contacts.size());
    check_same_logs(scratch, directory, "s-log.csv", 1e-6);
    check_same_logs(scratch, directory, "s-walls.csv", 1e-6, scene.find("periodic") != std::string::npos);
    BOOST_TEST(TrajectoryReader(scratch.path / directory / "s.h5").frames() == 5);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_kinds_fall_into_a_box) {
  check_as_here(falling(1500, "form: total", "", kBox), {{1, ""}, {2, ""}, {4, ""}, {3, "--tiles"}}, 2e-12);
}

BOOST_AUTO_TEST_CASE(incremental_between_periodic_sides_under_a_plate) {
  const std::string walls =
      "periodic: {x: 24 mm, y: 26 mm}\n"
      "walls:\n"
      "  planes:\n"
      "    - {point: [0, 0, 0], normal: [0, 0, 1]}\n"
      "    - {point: [0, 0, 40 mm], normal: [0, 0, -1], velocity: [0, 0, -1.5], name: plate}\n";
  check_as_here(falling(1500, "form: incremental", ", rolling_friction: 0.02", walls),
                {{1, ""}, {2, ""}, {2, "--tiles"}}, 2e-12);
}

BOOST_AUTO_TEST_CASE(adhesive_contacts) {
  check_as_here(falling(1500, "form: total", ", law: jkr, work_of_adhesion: 0.05", kBox), {{2, ""}}, 2e-12);
}

BOOST_AUTO_TEST_CASE(goes_on_with_another_number_of_ranks) {
  const Scratch scratch;
  scratch.file("s.yaml", falling(1500, "form: incremental", "", kBox));
  run_here(scratch);
  scratch.file("s.yaml", falling(900, "form: incremental", "", kBox));
  const Outcome first = go(scratch, 2, "run s.yaml --out two");
  BOOST_REQUIRE_MESSAGE(first.status == 0, first.error);
  scratch.file("s.yaml", falling(1500, "form: incremental", "", kBox));
  const Outcome second = go(scratch, 3, "run s.yaml --out two --resume --tiles");
  BOOST_REQUIRE_MESSAGE(second.status == 0, second.error);
  const CarriedState own = end_of(scratch.path / "own"), end = end_of(scratch.path / "two");
  BOOST_TEST(largest_distance(own, end) < 2e-12, largest_distance(own, end));
  BOOST_TEST(go(scratch, 1, "run s.yaml --out two").status == 2);  // is there already
}

BOOST_AUTO_TEST_CASE(a_rank_that_is_killed_ends_all_and_files_stay) {
  const Scratch scratch;
  scratch.file("s.yaml", falling(20000, "form: total", "", kBox));
  const pid_t child = fork();
  if (child == 0) {
    const std::string line = fmt::format("cd '{}' && {} > out.txt 2> error.txt", scratch.path.string(),
                                         mpirun(2, "run s.yaml --out k"));
    execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  const auto child_of_mpirun = [&] {
    std::istringstream all(content(fmt::format("/proc/{0}/task/{0}/children", child)));
    std::vector<int> pids;
    for (int pid = 0; all >> pid;) {
      if (content(fmt::format("/proc/{}/cmdline", pid)).find("fiberchain-mpi") != std::string::npos)
        pids.push_back(pid);
    }
    return pids;
  };
  // behind the checkpoint of the start comes that of a quarter of the run
  std::vector<int> pids;
  for (int n = 0; n < 6000; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    pids = child_of_mpirun();
    if (fs::exists(scratch.path / "k/s.checkpoint") && pids.size() == 2 &&
        read_checkpoint(scratch.path / "k/s.checkpoint").step > 0)
      break;
  }
  BOOST_REQUIRE_EQUAL(pids.size(), 2u);
  ::kill(pids[1], SIGKILL);
  int ended = 0;
  waitpid(child, &ended, 0);
  BOOST_TEST((!WIFEXITED(ended) || WEXITSTATUS(ended) != 0));
  const std::int64_t step = read_checkpoint(scratch.path / "k/s.checkpoint").step;
  BOOST_TEST(step > 0);
  BOOST_TEST(TrajectoryReader(scratch.path / "k/s.h5").frames() >= 2);
  const Outcome on = go(scratch, 1, "run s.yaml --out k --resume");
  BOOST_TEST(on.status == 0, on.error);
  BOOST_TEST(end_of(scratch.path / "k").time > 0);
}

BOOST_AUTO_TEST_CASE(a_script_of_lammps_has_the_fibers) {
  const Scratch scratch;
  scratch.file("s.yaml", falling(100, "form: total", "", kBox));
  scratch.file("in.lmp",
               "dump places all custom 50 places.txt id type x y z\ndump_modify places sort id\nrun 100\n");
  const Outcome outcome = go(scratch, 2, "--in in.lmp --scene s.yaml");
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const std::string dump = content(scratch.path / "places.txt");
  BOOST_TEST(dump.find("ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n251\n") !=
             std::string::npos);  // 23 7 + 9 10
}

// Rows of one machine, of one rank and two; ghosts where two share the scene, none where each has a copy of
// it.
BOOST_AUTO_TEST_CASE(bench_has_all_costs) {
  const Scratch scratch;
  scratch.file(
      "starts.csv",
      "x,y,z,ux,uy,uz\n0.003,0.011,0.002,1,0,0\n0.004,0.015,0.002,1,0,0\n0.011,0.004,0.0041,0,1,0\n");
  std::string scene = falling(100, "step: 2 us", "", kBox);
  const std::size_t fibers = scene.find("fibers:"), walls = scene.find("walls:");
  scene.replace(
      fibers, walls - fibers,
      "fibers:\n  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, "
      "density: 1300 kg/m^3, starts: starts.csv}\n");
  scratch.file("s.yaml", scene);
  const Outcome outcome = go(scratch, 2, "bench s.yaml --steps 20 --after 30 --copies 3");
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  std::istringstream table(content(scratch.path / "out.txt"));
  std::string line;
  std::getline(table, line), std::getline(table, line);
  std::vector<std::pair<std::string, bool>> rows;  // spheres and ranks; whether there are ghosts
  while (std::getline(table, line)) {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, '|');) cells.push_back(cell);
    BOOST_REQUIRE_GE(cells.size(), 8u);
    rows.emplace_back(cells[1] + cells[2], std::atof(cells[6].c_str()) > 0);
    BOOST_TEST((std::stod(cells[3]) > 0 && std::stod(cells[4]) > 0 && std::stod(cells[5]) > 0), line);
  }
  const std::vector<std::pair<std::string, bool>> expected{
      {" 21  fiberchain ", false}, {" 21  1 ", false},          {" 21  2 ", true}, {" 42  1 ", false},
      {" 42  2 ", false},          {" 63  fiberchain ", false}, {" 63  1 ", false}};
  BOOST_TEST((rows == expected), content(scratch.path / "out.txt"));
  for (const char* wrong : {"bench s.yaml --steps 0", "bench"})
    BOOST_TEST(go(scratch, 1, wrong).status == 2, wrong);
}

// What is not carried is refused by its key, with status 2 and no files.
BOOST_AUTO_TEST_CASE(what_is_not_there_is_refused) {
  const std::string scene = falling(100, "form: total", "", kBox);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = scene;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  const std::pair<const char*, std::string> refused[] = {
      {"fibers[0].bond.strength", with("{damping: 0.7}", "{damping: 0.7, strength: {tension: 1 MPa}}")},
      {"motion.integrator", with("form: total", "integrator: leapfrog-stiff")},
      {"fluid", scene + "fluid: {viscosity: 1 mPa s}\n"},
      {"held", scene + "held: [{name: clamp, fibers: 0, spheres: first}]\n"},
      {"output.energy", with("checkpoints: 4", "checkpoints: 4, energy: true")},
      {"output.contacts", with("checkpoints: 4", "checkpoints: 4, contacts: true")},
      {"fibers[0].material_damping",
       with("count: 23", "count: 23, material_damping: {loss_factor: 0.02, band: [10, 1000]}")}};
  for (const auto& [key, text] : refused) {
    const Scratch scratch;
    scratch.file("s.yaml", text);
    const Outcome outcome = go(scratch, key == std::string("fluid") ? 2 : 1, "run s.yaml --out r");
    BOOST_TEST(outcome.status == 2, key << ": " << outcome.error);
    BOOST_TEST(outcome.error.find(key) != std::string::npos, key << ": " << outcome.error);
    BOOST_TEST(!fs::exists(scratch.path / "r/s.h5"), key);
  }
}

BOOST_AUTO_TEST_SUITE_END()
