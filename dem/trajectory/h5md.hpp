#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/wall_surface.hpp"

// Trajectories in HDF5 by the H5MD convention, version 1.1 (https://nongnu.org/h5md).
//
//   /h5md                                    version, author, creator
//   /particles/fibers/{position,velocity}    step, time, value[frame][sphere][3] in m and m/s
//   /particles/fibers/{radius,fiber,id}      fixed: [m], number of the fiber, number of the sphere; where
//                                            fibers come later id is in time, -1 for those not there yet,
//                                            whose positions and velocities are NaN
//   /particles/fibers/box/{edges,origin}     in time: a diagonal matrix; the low corner, which H5MD does not
//                                            know
//   /connectivity/bonds                      fixed: pairs of spheres
//   /observables/{bond_force,bending_angle}  in time, a row a bond: on its first sphere [N]; [rad]
//   /observables/NAME                        in time, scalars
//   /connectivity/contacts                   where asked for (dem/trajectory/h5md_contacts.hpp)
//   /parameters/walls                        where there are any (dem/trajectory/h5md_walls.hpp)
//   /parameters/runs/N                       provenance of the run that began the file, and of those that
//   resumed it
//
// The file begins with 512 bytes of text of its own (dem/files/file_head.hpp), which HDF5 passes over. Its
// metadata and data have checksums (HDF5 1.10's format, Fletcher32): what is damaged is an error.
//
// All have the same steps and times, which are one dataset. Positions are rounded to 2^-37 of their value
// (7e-12), what else moves to floats: digits beyond these compress to nothing and mean nothing. Checkpoints
// have them all. Units stand as H5MD's attribute "unit" except on positions: MDAnalysis refuses the meter. It
// reads the file in SI units by load_new("NAME.h5md", convert_units=False); NAME.h5md is a link to NAME.h5
// with the suffix that it knows.
namespace fiberchain::dem {

/// Has HDF5 not tidy up when the program ends, where it complains of damaged files it could not close. For
/// programs that use it through this library alone: before the first file.
void leave_hdf5_as_it_is_at_exit();

using Entries = std::vector<std::pair<std::string, std::string>>;
using Scalars = std::vector<std::pair<std::string, double>>;

struct TrajectoryHeader {
  std::string author;           ///< H5MD asks for one
  std::string creator_version;  ///< of the program
  Entries provenance;           ///< attributes, by name
  bool growing = false;         ///< frames have absent spheres, which come later
  bool contacts = false;        ///< contacts of frames are written
  std::vector<WallSurface> walls = {};
};

struct FrameRoom;

/// Appends frames to a file, whole or not at all: each frame opens the file, brings it to the disk in one
/// step and closes it again, so that readers can open a run in progress and nothing is lost but the frame
/// being written when the run is killed or the disk is full. A kill within the microseconds of that step
/// leaves a journal beside the file, which TrajectoryReader and resuming understand. Beside FILE.h5 stands
/// FILE.h5md, a link to it.
class TrajectoryWriter {
 public:
  /// A new file; it appears with the first frame, in place of what stood there.
  TrajectoryWriter(std::filesystem::path path, TrajectoryHeader header);

  TrajectoryWriter(TrajectoryWriter&&) noexcept;
  TrajectoryWriter& operator=(TrajectoryWriter&&) noexcept;
  ~TrajectoryWriter();

  /// Goes on with a file (or begins it, if there is none), without its frames later than `last_step`.
  /// @throws ReadError if it is no such file, WriteError
  static TrajectoryWriter resume(std::filesystem::path path, TrajectoryHeader header, std::int64_t last_step);

  /// @param scalars the same names with every frame
  /// @throws InvalidInput if spheres, bonds or scalars are not those of the first frame, or the step is not
  /// later than
  ///         the last; WriteError, the file is then as it was; ReadError if it is not as it was left
  void append(const TrajectoryFrame& frame, const Scalars& scalars = {});

  std::int64_t frames() const { return static_cast<std::int64_t>(times_.size()); }

 private:
  std::filesystem::path path_;
  TrajectoryHeader header_;
  std::vector<double> times_;
  std::int64_t last_step_ = 0;
  std::unique_ptr<FrameRoom> room_;
};

/// Reads a trajectory of ours as it is now; open another to see later frames.
class TrajectoryReader {
 public:
  /// @throws ReadError if there is no such file or it is no trajectory
  explicit TrajectoryReader(std::filesystem::path path);

  std::int64_t frames() const { return static_cast<std::int64_t>(steps_.size()); }
  const std::vector<std::int64_t>& steps() const { return steps_; }
  const std::vector<double>& times() const { return times_; }

  /// Provenance of the run that began the file.
  const Entries& provenance() const { return provenance_; }

  /// Of all walls, where they were put; empty in files of earlier versions.
  const std::vector<WallSurface>& walls() const { return walls_; }

  /// TrajectoryFrame `n`, from 0: the spheres that are there.
  /// @throws ReadError if there is none such or it cannot be read
  TrajectoryFrame read(std::int64_t n) const;

  /// The scalars of frame `n`.
  /// @throws ReadError
  Scalars scalars(std::int64_t n) const;

 private:
  std::filesystem::path path_;
  std::vector<std::int64_t> steps_;
  std::vector<double> times_;
  Entries provenance_;
  std::vector<WallSurface> walls_;
};

}  // namespace fiberchain::dem
