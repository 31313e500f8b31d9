#pragma once

#include <cstdint>
#include <optional>

#include "dem/record/run_log.hpp"
#include "dem/run/files.hpp"
#include "dem/run/schedule.hpp"
#include "dem/trajectory/h5md.hpp"
#include "dem/trajectory/vtk.hpp"

// The files that grow beside the checkpoint of a run: logs, trajectory and VTK series. A run goes on whatever
// has become of them: one that is missing or damaged is said, kept under another name and begun anew.
namespace fiberchain::dem {

/// What they are opened for.
struct CompanionsOf {
  RunFiles files;
  Table log;          ///< empty, with its columns
  Table wall_log;     ///< likewise
  std::size_t walls;  ///< how many; rows of that of each step
  Table held_log;     ///< likewise
  std::size_t held;   ///< grips, likewise
  Table break_log;    ///< likewise
  bool breaks;        ///< whether there are bonds that break
  Provenance provenance;
  TrajectoryHeader header;
  bool vtk;
  RunSchedule schedule;
  WrittenSteps written = {};  ///< what should stand in those of a run that goes on
};

/// Those that the schedule has times for.
struct Companions {
  std::optional<RunLog> log;
  std::optional<RunLog> walls, held;  ///< where there are any
  std::optional<RunLog> breaks;       ///< where bonds break
  std::optional<TrajectoryWriter> trajectory;
  std::optional<VtkSeries> vtk;
};

/// Those of a new run.
/// @throws OutputError
Companions begin_companions(const CompanionsOf& run);

/// Those of a run that goes on behind step `done`.
/// @throws OutputError
Companions resume_companions(const CompanionsOf& run, std::int64_t done, const Say& say);

/// Says which of them are missing or damaged, of a run that has ended, and changes none.
void look_at_companions(const CompanionsOf& run, std::int64_t done, const Say& say);

}  // namespace fiberchain::dem
