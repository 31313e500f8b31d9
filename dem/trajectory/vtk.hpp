#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/h5md.hpp"

// Frames as VTK PolyData (.vtp, inline base64) that ParaView and OVITO open, and their series (.pvd).
//
// OVITO reads PolyData as particles only if it holds nothing but a vertex for every point, with the arrays
// "id", "radius" and "v"; so spheres and polylines are two files a frame:
//   NAME.pvd         the spheres in time: NAME/spheres-STEP.vtp
//   NAME-lines.pvd   the fibers in time:  NAME/lines-STEP.vtp, a polyline a fiber
// Both have at their points id, fiber, radius [m], v [m/s] (velocity), bond_force [N] and bending_angle
// [rad]. The last two are those of the bond to the next sphere, the force that on the point's own sphere; at
// the last sphere of a fiber 0. Where there are any:
//   NAME-contacts.pvd  contacts in time, if asked for: NAME/contacts-STEP.vtp, a point each, with first and
//                      second (ids of the spheres, of a wall its number from 1), kind (ContactKind), normal
//                      (from the first to the second), force (on the first [N])
//   NAME-walls.pvd   walls in time: NAME/walls-STEP.vtp, triangles with the wall's number from 1; a file
//   where
//                    some wall has moved, come or gone since the one before
// All have TimeValue [s], step and provenance as field data.
namespace fiberchain::dem {

/// The spheres of a frame as a .vtp file.
std::string vtp_spheres(const TrajectoryFrame& frame, const Entries& provenance);

/// The fibers of a frame as polylines in a .vtp file.
std::string vtp_lines(const TrajectoryFrame& frame, const Entries& provenance);

/// The contacts of a frame as points in a .vtp file.
std::string vtp_contacts(const TrajectoryFrame& frame, const Entries& provenance);

/// The walls that are there, where they are in a frame.
std::string vtp_walls(const TrajectoryFrame& frame, const std::vector<WallSurface>& walls,
                      const Entries& provenance);

/// What a series has beside its frames.
struct VtkHeader {
  Entries provenance;
  std::vector<WallSurface> walls = {};
};

/// The files of a series' frames that lie in its folder `place`, in order.
std::vector<std::filesystem::path> vtk_parts(const std::filesystem::path& place);

/// Writes frames one by one; every file appears whole, and the series name none that is not there.
class VtkSeries {
 public:
  /// A new series. Nothing is written before the first frame.
  VtkSeries(std::filesystem::path directory, std::string name, VtkHeader header);

  /// Goes on with the series in a directory, without its frames later than `last_step`; begins it if there is
  /// none.
  /// @throws ReadError if the .pvd there is none of ours, WriteError
  static VtkSeries resume(std::filesystem::path directory, std::string name, VtkHeader header,
                          std::int64_t last_step);

  /// The series as it stands up to `last_step`; nothing is written.
  /// @throws ReadError
  static VtkSeries read(std::filesystem::path directory, std::string name, VtkHeader header,
                        std::int64_t last_step);

  std::optional<std::int64_t> last_step() const;              ///< of its frames; nothing without any
  std::optional<std::filesystem::path> missing_part() const;  ///< a file of its frames that is not there

  /// @throws InvalidInput if the step is not later than the last, WriteError
  void append(const TrajectoryFrame& frame);

  std::int64_t frames() const { return static_cast<std::int64_t>(entries_.size()); }

 private:
  struct Entry {
    std::int64_t step;
    double time;
    bool has_contacts = false;
    std::int64_t walls = -1;  ///< step of the file of its walls; -1 without
  };
  std::string line_of(double time, std::int64_t step, const char* kind) const;
  void write_series() const;
  /// Which files stand beside those of its spheres.
  void find_others(Entry& entry) const;
  void read_series(std::int64_t last_step);

  std::filesystem::path directory_;
  std::string name_;
  VtkHeader header_;
  std::vector<Entry> entries_;
};

}  // namespace fiberchain::dem
