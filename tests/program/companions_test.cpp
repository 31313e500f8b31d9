#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "dem/record/csv.hpp"
#include "tests/program/packings.hpp"

// Whatever has become of the files beside a checkpoint, the run goes on.
BOOST_AUTO_TEST_SUITE(companions_test)

using namespace fiberchain::test;
namespace io = fiberchain::dem;
namespace fs = std::filesystem;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Runs without pictures, which take longer than all else.
struct Undrawn : FewFibers {
  explicit Undrawn(int steps) : FewFibers(steps) {}
  Outcome go(const std::vector<std::string>& more = {}) const {
    return run(arguments(more), {.directory = path, .environment = {{"PATH", "/nonexistent"}}});
  }
};

/// A run whose last checkpoint is gone, so that there is something left to do.
struct Unfinished : Undrawn {
  Unfinished() : Undrawn(2000) {
    static const Undrawn whole(2000);
    static const int status = whole.go().status;
    BOOST_REQUIRE_EQUAL(status, 0);
    fs::copy(whole.path / "out", path / "out", fs::copy_options::recursive);
    fs::rename(out("s.checkpoint.previous"), out("s.checkpoint"));
  }
};

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string without(std::string text, std::size_t from, std::size_t count) { return text.erase(from, count); }

struct Damage {
  const char* name;
  const char* file;
  std::string (*of)(const std::string& text);
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Damage& damage) { return out << damage.name; }

const Damage kDamages[] = {
    {"log with a broken number", "s-log.csv",
     [](const std::string& text) {
       return text.substr(0, text.rfind("\n", text.size() - 400)) + "x" +
              text.substr(text.rfind("\n", text.size() - 400));
     },
     "s-log.csv:"},
    {"log with a broken header", "s-log.csv",
     [](const std::string& text) { return without(text, text.find("\nstep,") + 2, 3); },
     "is no log of this run"},
    {"empty log", "s-log.csv", [](const std::string&) { return std::string(); }, "is no log of this run"},
    {"log that ends early", "s-log.csv",
     [](const std::string& text) { return text.substr(0, text.rfind('\n', text.size() - 900) + 1); },
     "ends at step"},
    {"cut trajectory", "s.h5", [](const std::string& text) { return text.substr(0, text.size() / 2); },
     "is cut off"},
    {"trajectory with a damaged head", "s.h5", [](const std::string& text) { return "g" + text.substr(1); },
     "its head is not whole"},
    {"trajectory with damaged metadata", "s.h5",
     [](const std::string& text) { return text.substr(0, 560) + "???" + text.substr(563); },
     "is no trajectory"},
    {"empty trajectory", "s.h5", [](const std::string&) { return std::string(); }, "its head is not whole"},
    {"series with a long word", "s.pvd",
     [](const std::string&) {
       return "type=\"Collection\" <DataSet timestep=\"" + std::string(50000, 'a') + "</VTKFile>";
     },
     "is no series of VTK files"},
    {"series with a changed entry", "s.pvd",
     [](const std::string& text) { return without(text, text.find("part=\"0\"", 400), 1); }, "s.pvd: line "},
    {"series that ends early", "s.pvd",
     [](const std::string& text) { return text.substr(0, text.size() / 2); }, "s.pvd: line "},
};

}  // namespace

BOOST_DATA_TEST_CASE(a_damaged_companion_is_kept_and_a_new_one_begins, boost::unit_test::data::make(kDamages),
                     damage) {
  const Unfinished run;
  const fs::path path = run.out(damage.file);
  const std::string damaged = damage.of(content(path));
  write(path, damaged);
  const Outcome resumed = run.go({"--resume"});
  BOOST_TEST(resumed.status == 0, resumed.error);
  BOOST_TEST(holds(resumed.error, damage.says), resumed.error);
  BOOST_TEST(holds(resumed.error, path.filename().string() + ".bad; a new one begins behind step 1913"),
             resumed.error);
  BOOST_TEST((content(path.string() + ".bad") == damaged));
  BOOST_TEST(holds(content(run.out("s.csv")), "finished"));
  BOOST_TEST(io::read_csv(run.out("s-log.csv")).table.rows().size() > 0);
  BOOST_TEST(io::TrajectoryReader(run.out("s.h5")).steps().back() == 2000);
  BOOST_TEST(holds(content(run.out("s.pvd")), "spheres-000000002000.vtp"));
  const Outcome again = run.go({"--resume"});  // and what began in the middle is no fault
  BOOST_TEST(again.status == 0, again.error);
  BOOST_TEST(!holds(again.error, "begins"), again.error);
  BOOST_TEST(!holds(again.error, ": is missing"), again.error);
}

BOOST_AUTO_TEST_CASE(a_missing_companion_is_said_and_begun_anew) {
  for (const char* name : {"s-log.csv", "s.h5", "s.pvd"}) {
    const Unfinished run;
    fs::remove(run.out(name));
    const Outcome resumed = run.go({"--resume"});
    BOOST_TEST(resumed.status == 0, resumed.error);
    BOOST_TEST(holds(resumed.error, std::string(name) + ": is missing; a new one begins behind step 1913"),
               resumed.error);
    BOOST_TEST(fs::exists(run.out(name)), name);
  }
}

BOOST_AUTO_TEST_CASE(a_missing_part_of_a_series_is_said) {
  const Unfinished run;
  fs::remove(run.out("s/lines-000000000000.vtp"));
  const Outcome resumed = run.go({"--resume"});
  BOOST_TEST(resumed.status == 0, resumed.error);
  BOOST_TEST(holds(resumed.error, "lines-000000000000.vtp: is missing, of the series"), resumed.error);
}

BOOST_AUTO_TEST_CASE(a_finished_run_keeps_its_run_time_and_says_what_is_missing) {
  const Undrawn run(2000);
  BOOST_REQUIRE_EQUAL(run.go().status, 0);
  const double before = io::read_csv(run.out("s.csv")).table.number(0, "run_time");
  fs::remove(run.out("s.h5"));
  const Outcome again = run.go({"--resume"});
  BOOST_TEST(again.status == 0, again.error);
  BOOST_TEST(holds(again.error, "s.h5: is missing"), again.error);
  BOOST_TEST(io::read_csv(run.out("s.csv")).table.number(0, "run_time") == before);
  fs::remove(run.out("s.csv"));
  BOOST_TEST(run.go({"--resume"}).status == 0);
  BOOST_TEST(std::isnan(io::read_csv(run.out("s.csv")).table.number(0, "run_time")));
}

BOOST_AUTO_TEST_CASE(pictures_of_a_run_at_work_never_fail) {
  const FewFibers run(2'000'000);
  run.file("s.yaml", [] {
    std::string text = short_fibers(2'000'000, few);
    return text.replace(text.find("frames: 11"), 10, "frames: 200000");
  }());
  Started program(run.arguments(), run.here());
  wait_until([&] { return fs::exists(run.out("s.h5")); });
  for (int n = 0; n < 8; ++n) {
    const Outcome picture = fiberchain::test::run(
        {"render", "out/s.h5", "--width", "160", "--height", "100", "--jobs", "1"}, run.here());
    BOOST_TEST(picture.status == 0, picture.error);
  }
  program.send(SIGTERM);
  BOOST_TEST(program.finish().status == 143);
}

BOOST_AUTO_TEST_SUITE_END()
