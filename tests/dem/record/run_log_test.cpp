#include "dem/record/run_log.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "compare/study/errors.hpp"
#include "dem/record/csv.hpp"
#include "dem/record/run_status.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(run_log_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::dem;
using namespace fiberchain::test;

namespace {

dem::RunStatus status(std::int64_t step) {
  return {
      step,  4e-6 * static_cast<double>(step),        3 * step, 1.5e-4 / static_cast<double>(step), 0.0625,
      812.5, std::numeric_limits<double>::quiet_NaN()};
}

dem::Table empty_table() {
  return dem::Table(
      {"step", "simulated_time", "contacts", "kinetic_energy", "height", "step_rate", "time_left"});
}

dem::Table row(std::int64_t step) {
  const dem::RunStatus now = status(step);
  dem::Table table = empty_table();
  table.append({{"step", now.step},
                {"simulated_time", now.time},
                {"contacts", now.contacts},
                {"kinetic_energy", now.kinetic_energy},
                {"height", now.height},
                {"step_rate", now.step_rate},
                {"time_left", now.time_left}});
  return table;
}

std::vector<std::int64_t> steps(const std::filesystem::path& path) {
  std::vector<std::int64_t> all;
  const dem::CsvDocument document = dem::read_csv(path);
  for (const auto& row : document.table.rows()) all.push_back(std::get<std::int64_t>(row.front()));
  return all;
}

const dem::Provenance kProvenance{.version = "1",
                                  .commit = "abc",
                                  .command = "run",
                                  .scene = "",
                                  .scene_sha256 = "",
                                  .compiler = "",
                                  .flags = "",
                                  .cpu = "",
                                  .date = ""};

}  // namespace

BOOST_AUTO_TEST_CASE(every_line_is_there_at_once) {
  const Scratch scratch;
  const auto path = scratch.path / "log.csv";
  dem::RunLog log(path, empty_table(), kProvenance);
  BOOST_TEST(steps(path).empty());
  for (const std::int64_t step : {7, 11, 30}) {
    log.append(row(step));
    const dem::CsvDocument document = dem::read_csv(path);
    const std::size_t last = document.table.rows().size() - 1;
    BOOST_TEST(steps(path).back() == step);
    BOOST_TEST(document.table.number(last, "simulated_time") == status(step).time);
    BOOST_TEST(document.table.number(last, "contacts") == 3.0 * static_cast<double>(step));
    BOOST_TEST(document.table.number(last, "kinetic_energy") == status(step).kinetic_energy);
    BOOST_TEST(document.table.number(last, "height") == 0.0625);
    BOOST_TEST(document.table.number(last, "step_rate") == 812.5);
    BOOST_TEST(std::isnan(document.table.number(last, "time_left")));
  }
  BOOST_TEST(content(path).starts_with("# program: fiberchain\n"));
}

BOOST_AUTO_TEST_CASE(resuming_drops_what_is_later_and_what_was_cut_off) {
  const Scratch scratch;
  const auto path = scratch.path / "log.csv";
  {
    dem::RunLog log(path, empty_table(), kProvenance);
    for (const std::int64_t step : {7, 11, 30}) log.append(row(step));
  }
  std::ofstream(path, std::ios::app) << "40,0.00";
  {
    dem::RunLog log = dem::RunLog::resume(path, empty_table(), kProvenance, 100);
    log.append(row(50));
  }
  BOOST_TEST(steps(path) == (std::vector<std::int64_t>{7, 11, 30, 50}), boost::test_tools::per_element());
  dem::RunLog log = dem::RunLog::resume(path, empty_table(), kProvenance, 29);
  log.append(row(31));
  BOOST_TEST(steps(path) == (std::vector<std::int64_t>{7, 11, 31}), boost::test_tools::per_element());
  dem::RunLog fresh = dem::RunLog::resume(scratch.path / "other.csv", empty_table(), kProvenance, 100);
  fresh.append(row(8));
  BOOST_TEST(steps(scratch.path / "other.csv") == (std::vector<std::int64_t>{8}),
             boost::test_tools::per_element());
  std::ofstream(scratch.path / "foreign.csv") << "a,b\n1,2\n";
  BOOST_CHECK_THROW(dem::RunLog::resume(scratch.path / "foreign.csv", empty_table(), kProvenance, 1),
                    InputError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_whole_lines) {
  const Scratch scratch;
  const auto path = scratch.path / "log.csv";
  dem::RunLog log(path, empty_table(), kProvenance);
  log.append(row(7));
  const std::string before = content(path);
  {
    const SizeLimit full(before.size() + 10);
    BOOST_CHECK_THROW(log.append(row(8)), dem::OutputError);
  }
  BOOST_TEST(content(path) == before);
  log.append(row(9));
  BOOST_TEST(steps(path).back() == 9);
}

BOOST_AUTO_TEST_CASE(a_status_is_a_line) {
  dem::RunStatus now = status(1200);
  now.time_left = 187.2;
  BOOST_TEST(dem::status_line(now, 20000) ==
             "step 1200 of 20000, t = 0.0048 s, 3600 contacts, kinetic energy 1.25e-07 J, height 0.0625 m, "
             "812 steps/s, "
             "3:08 min left");
  now.time_left = now.step_rate = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(dem::status_line(now, 20000).ends_with("height 0.0625 m"));
}

BOOST_AUTO_TEST_CASE(a_status_fits_the_terminal) {
  dem::RunStatus now = status(12345678);
  now.time_left = 187.2;
  for (const std::size_t columns : {20, 40, 80, 100, 200}) {
    const std::string line = dem::status_line(now, 200'000'000, columns);
    BOOST_TEST(line.size() < columns);
    BOOST_TEST(line.starts_with("step 12345678 of 20"));
  }
  BOOST_TEST(dem::status_line(now, 200'000'000, 80).find("3:08 min left") != std::string::npos);
  BOOST_TEST(dem::status_line(now, 200'000'000, 200) == dem::status_line(now, 200'000'000));
}

BOOST_AUTO_TEST_CASE(a_display_is_quiet_in_a_pipe_and_ends_its_line) {
  std::ostringstream pipe, terminal;
  {
    dem::StatusDisplay quiet(pipe, false), shown(terminal, true);
    for (const std::int64_t step : {10, 20, 30}) {  // the second within a third of a second of the first
      quiet.show(status(step), 30);
      shown.show(status(step), 30);
    }
  }
  BOOST_TEST(pipe.str() == "");
  BOOST_TEST(terminal.str().starts_with("\rstep 10 of 30"));
  BOOST_TEST(terminal.str().find("\rstep 30 of 30") != std::string::npos);
  BOOST_TEST(terminal.str().ends_with("\n"));
}

BOOST_AUTO_TEST_CASE(a_pace_counts_the_steps_of_this_session) {
  const dem::Pace pace(1000, 3000);
  BOOST_TEST(std::isnan(pace.step_rate(1000)));
  const double rate = pace.step_rate(2000), left = pace.time_left(2000);
  BOOST_TEST(rate > 0);
  BOOST_TEST(left > 0);
  BOOST_TEST(left * rate >= 1000 * (1 - 1e-12));  // the clock went on between the two
}

BOOST_AUTO_TEST_SUITE_END()
