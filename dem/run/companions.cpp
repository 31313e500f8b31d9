#include "dem/run/companions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

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

void check_walls(const CompanionsOf& run, std::int64_t done) {
  const fs::path path = run.files.walls();
  const auto last = RunLog::last_step(path, run.wall_log, done, run.walls);
  const std::int64_t wanted = run.written.log;  // rows of both come together
  if (last != wanted) fail_at(path, last, wanted);
}

bool logs_walls(const CompanionsOf& run) { return run.schedule.samples.any() && run.walls > 0; }

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

void check_series(const CompanionsOf& run, std::int64_t done) {
  const fs::path path = run.files.at(".pvd");
  const VtkSeries series =
      VtkSeries::read(run.files.directory, run.files.name, entries(run.provenance), done);
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
  if (logs_walls(run)) all.walls.emplace(run.files.walls(), run.wall_log, run.provenance);
  if (!run.schedule.frames.any()) return all;
  all.trajectory.emplace(run.files.trajectory(), run.header);
  if (run.vtk) all.vtk = VtkSeries(run.files.directory, run.files.name, entries(run.provenance));
  return all;
}

Companions resume_companions(const CompanionsOf& run, std::int64_t done, const Say& say) {
  const fs::path log = run.files.log(), trajectory = run.files.trajectory();
  const Entries from = entries(run.provenance);
  const std::string& name = run.files.name;
  Companions all;
  if (run.schedule.samples.any()) {
    all.log.emplace(resumed(
        log, run.written.log, done, say, [&] { check_log(run, done); },
        [&] { return RunLog::resume(log, run.log, run.provenance, done); },
        [&] { return RunLog(log, run.log, run.provenance); }));
  }
  if (logs_walls(run)) {
    const fs::path walls = run.files.walls();
    all.walls.emplace(resumed(
        walls, run.written.log, done, say, [&] { check_walls(run, done); },
        [&] { return RunLog::resume(walls, run.wall_log, run.provenance, done, run.walls); },
        [&] { return RunLog(walls, run.wall_log, run.provenance); }));
  }
  if (!run.schedule.frames.any()) return all;
  all.trajectory.emplace(resumed(
      trajectory, run.written.trajectory, done, say, [&] { check_trajectory(run, done); },
      [&] { return TrajectoryWriter::resume(trajectory, run.header, done); },
      [&] { return TrajectoryWriter(trajectory, run.header); }));
  if (!run.vtk) return all;
  all.vtk = resumed(
      run.files.at(".pvd"), run.written.vtk, done, say, [&] { check_series(run, done); },
      [&] { return VtkSeries::resume(run.files.directory, name, from, done); },
      [&] { return VtkSeries(run.files.directory, name, from); });
  return all;
}

void look_at_companions(const CompanionsOf& run, std::int64_t done, const Say& say) {
  const auto tell = [&](const fs::path& path, const auto& check) {
    const std::string fault = fault_of(path, [&] { check(run, done); });
    if (!fault.empty()) say(fmt::format("warning: {}", fault));
  };
  if (run.written.log >= 0) tell(run.files.log(), check_log);
  if (run.written.log >= 0 && logs_walls(run)) tell(run.files.walls(), check_walls);
  if (run.written.trajectory >= 0) tell(run.files.trajectory(), check_trajectory);
  if (run.written.vtk >= 0) tell(run.files.at(".pvd"), check_series);
}

}  // namespace fiberchain::dem
