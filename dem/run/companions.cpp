#include "dem/run/companions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <vector>

#include "dem/files/file_error.hpp"
#include "dem/record/errors.hpp"

namespace fiberchain::dem {
namespace {

namespace fs = std::filesystem;

/// A file that is not what it should be.
[[noreturn]] void fail_at(const fs::path& path, std::optional<std::int64_t> last, std::int64_t wanted) {
  throw ReadError(path, last ? fmt::format("ends at step {}, not at {}", *last, wanted)
                             : fmt::format("holds nothing up to step {}", wanted));
}

void check_log(const CompanionsOf& run, std::int64_t done) {
  const fs::path path = run.files.log();
  const auto last = RunLog::last_step(path, run.log, done);
  const std::int64_t wanted = run.written.log;
  if (last != wanted) fail_at(path, last, wanted);
}

/// A log of forces, with as many rows a step.
struct ForceLog {
  fs::path path;
  const Table& table;
  std::size_t rows;
  std::optional<RunLog> Companions::*member;
};

/// Those of walls and of grips, where there are any.
std::vector<ForceLog> force_logs(const CompanionsOf& run) {
  std::vector<ForceLog> logs;
  if (!run.schedule.samples.any()) return logs;
  if (run.walls > 0) logs.push_back({run.files.walls(), run.wall_log, run.walls, &Companions::walls});
  if (run.held > 0) logs.push_back({run.files.held(), run.held_log, run.held, &Companions::held});
  return logs;
}

void check_forces(const CompanionsOf& run, const ForceLog& log, std::int64_t done) {
  const auto last = RunLog::last_step(log.path, log.table, done, log.rows);
  const std::int64_t wanted = run.written.log;  // rows of all logs come together
  if (last != wanted) fail_at(log.path, last, wanted);
}

/// Bonds that broke before step `done`: how many is not known.
void check_breaks(const CompanionsOf& run, std::int64_t done) {
  RunLog::last_step(run.files.breaks(), run.break_log, done - 1, RunLog::any_rows);
}

/// The last frame, read, goes through all of the file that the next one will touch.
void check_trajectory(const CompanionsOf& run, std::int64_t done) {
  const fs::path path = run.files.trajectory();
  const TrajectoryReader reader(path);
  const auto kept = std::ranges::upper_bound(reader.steps(), done) - reader.steps().begin();
  const std::int64_t wanted = run.written.trajectory;
  std::optional<std::int64_t> last;
  if (kept > 0) last = reader.steps()[static_cast<std::size_t>(kept) - 1];
  if (last != wanted) fail_at(path, last, wanted);
  reader.read(kept - 1);
  reader.scalars(kept - 1);
}

VtkHeader vtk_header(const CompanionsOf& run) { return {entries(run.provenance), run.header.walls}; }

void check_series(const CompanionsOf& run, std::int64_t done) {
  const fs::path path = run.files.at(".pvd");
  const VtkSeries series = VtkSeries::read(run.files.directory, run.files.name, vtk_header(run), done);
  const std::int64_t wanted = run.written.vtk;
  if (series.last_step() != wanted) fail_at(path, series.last_step(), wanted);
  if (const auto part = series.missing_part())
    throw ReadError(*part, "is missing, of the series " + path.string());
}

/// What is wrong with a file; "" if nothing is.
template <class Check>
std::string fault_of(const fs::path& path, const Check& check) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return path.string() + ": is missing";
  try {
    check();
    return "";
  } catch (const std::exception& fault) {
    return fault.what();
  }
}

/// Renames a broken file to one of the names for such, and gives that.
fs::path put_aside(const fs::path& path) {
  for (int n = 1;; ++n) {
    const fs::path name = broken_name(path, n);
    if (fs::exists(name)) continue;
    std::error_code error;
    fs::rename(path, name, error);
    if (error) throw OutputError(name, error.message());
    return name;
  }
}

/// The companion resumed, or begun anew where it cannot be: what was there is kept. One that the scene did
/// not have before begins.
template <class Check, class Resume, class Begin>
auto resumed(const fs::path& path, std::int64_t written, std::int64_t done, const Say& say,
             const Check& check, const Resume& resume, const Begin& begin) {
  if (written < 0 && !fs::exists(fs::symlink_status(path))) return begin();
  std::string fault = fault_of(path, check);
  if (fault.empty()) {
    try {
      return resume();
    } catch (const ReadError& error) {
      fault = error.what();
    } catch (const InputError& error) {
      fault = error.what();
    }
  }
  if (fs::exists(fs::symlink_status(path))) fault += "; kept as " + put_aside(path).string();
  say(fmt::format("warning: {}; a new one begins behind step {}", fault, done));
  return begin();
}

}  // namespace

Companions begin_companions(const CompanionsOf& run) {
  Companions all;
  if (run.schedule.samples.any()) all.log.emplace(run.files.log(), run.log, run.provenance);
  for (const ForceLog& log : force_logs(run)) (all.*log.member).emplace(log.path, log.table, run.provenance);
  if (run.breaks) all.breaks.emplace(run.files.breaks(), run.break_log, run.provenance);
  if (!run.schedule.frames.any()) return all;
  all.trajectory.emplace(run.files.trajectory(), run.header);
  if (run.vtk) all.vtk = VtkSeries(run.files.directory, run.files.name, vtk_header(run));
  return all;
}

Companions resume_companions(const CompanionsOf& run, std::int64_t done, const Say& say) {
  const fs::path log = run.files.log(), trajectory = run.files.trajectory();
  const std::string& name = run.files.name;
  Companions all;
  if (run.schedule.samples.any()) {
    all.log.emplace(resumed(
        log, run.written.log, done, say, [&] { check_log(run, done); },
        [&] { return RunLog::resume(log, run.log, run.provenance, done); },
        [&] { return RunLog(log, run.log, run.provenance); }));
  }
  for (const ForceLog& forces : force_logs(run)) {
    (all.*forces.member)
        .emplace(resumed(
            forces.path, run.written.log, done, say, [&] { check_forces(run, forces, done); },
            [&] { return RunLog::resume(forces.path, forces.table, run.provenance, done, forces.rows); },
            [&] { return RunLog(forces.path, forces.table, run.provenance); }));
  }
  if (run.breaks) {
    const fs::path breaks = run.files.breaks();
    all.breaks.emplace(resumed(
        breaks, 0, done, say, [&] { check_breaks(run, done); },
        [&] { return RunLog::resume(breaks, run.break_log, run.provenance, done - 1, RunLog::any_rows); },
        [&] { return RunLog(breaks, run.break_log, run.provenance); }));
  }
  if (!run.schedule.frames.any()) return all;
  all.trajectory.emplace(resumed(
      trajectory, run.written.trajectory, done, say, [&] { check_trajectory(run, done); },
      [&] { return TrajectoryWriter::resume(trajectory, run.header, done); },
      [&] { return TrajectoryWriter(trajectory, run.header); }));
  if (!run.vtk) return all;
  all.vtk = resumed(
      run.files.at(".pvd"), run.written.vtk, done, say, [&] { check_series(run, done); },
      [&] { return VtkSeries::resume(run.files.directory, name, vtk_header(run), done); },
      [&] { return VtkSeries(run.files.directory, name, vtk_header(run)); });
  return all;
}

void look_at_companions(const CompanionsOf& run, std::int64_t done, const Say& say) {
  const auto tell = [&](const fs::path& path, const auto& check) {
    const std::string fault = fault_of(path, [&] { check(run, done); });
    if (!fault.empty()) say(fmt::format("warning: {}", fault));
  };
  if (run.written.log >= 0) tell(run.files.log(), check_log);
  for (const ForceLog& log : force_logs(run)) {
    if (run.written.log >= 0)
      tell(log.path, [&](const CompanionsOf& of, std::int64_t step) { check_forces(of, log, step); });
  }
  if (run.breaks) tell(run.files.breaks(), check_breaks);
  if (run.written.trajectory >= 0) tell(run.files.trajectory(), check_trajectory);
  if (run.written.vtk >= 0) tell(run.files.at(".pvd"), check_series);
}

}  // namespace fiberchain::dem
